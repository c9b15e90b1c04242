#include "core/preview/renderer.h"

#include "gl_fixture.h"
#include "small_pictures.h"
#include "test_environments.h"

#include "core/image/mip_pyramid.h"
#include "core/shading/lambda.h"

#include <cmath>

using namespace mirrorball;
using namespace mirrorball::preview;
using namespace mirrorball::test;

using RenderedLevels = mirrorball::test::GlTest;

TEST_F(RenderedLevels, LambdaPastTheLastLevelIsTheLastLevel)
{
    Renderer renderer(TexelFormat::Float);
    for (const MapLayout& layout : everyLayout(32)) {
        auto pyramid = buildMipPyramid(environmentFrom(layout, smoothRadiance)).levels;
        pyramid.resize(4);
        const MapLevels levels = std::make_shared<const std::vector<EnvironmentMap>>(pyramid);
        RenderSettings settings = small(GeometryKind::Torus);
        settings.background.kind = Backdrop::None;
        settings.material.lambda = 50.0f;
        const Image clamped = renderer.renderRadiance(settings, {levels, {}, {}});
        settings.material.lambda = 0.0f;
        const Image last = renderer.renderRadiance(settings, {asLevels(pyramid.back()), {}, {}});
        for (size_t i = 0; i < clamped.texels.size(); ++i)
            ASSERT_NEAR(clamped.texels[i], last.texels[i], 1e-4) << name(layout.kind);
    }
}

// A bias would add to a level that is coarse already; a clamp leaves it.
TEST_F(RenderedLevels, LambdaIsAClampAndNotABias)
{
    const auto pyramid = buildMipPyramid(environmentFrom({Parameterization::Cube, 512, 0}, smoothRadiance));
    EnvironmentMap numbered = pyramid.levels[0];
    std::vector<EnvironmentMap> levels;
    for (size_t i = 0; i < pyramid.levels.size(); ++i) // every level its own value: the picture shows the level used
        levels.push_back(environmentFrom(pyramid.levels[i].layout, [=](const glm::dvec3&) { return glm::vec3(float(i)); }));
    const MapLevels maps = std::make_shared<const std::vector<EnvironmentMap>>(levels);
    RenderSettings settings = small(GeometryKind::Sphere);
    settings.background.kind = Backdrop::None;
    settings.camera.distance = 8.0f; // small on the screen: the reflection is minified
    Renderer renderer(TexelFormat::Float);
    const Image free = renderer.renderRadiance(settings, {maps, {}, {}});
    settings.material.lambda = 4.0f;
    const Image clamped = renderer.renderRadiance(settings, {maps, {}, {}});
    int coarser = 0;
    for (size_t i = 0; i < free.texels.size(); i += 4) {
        if (free.texels[i + 3] != 1.0f)
            continue;
        ASSERT_NEAR(clamped.texels[i], std::max(free.texels[i], 4.0f), 1e-4);
        if (free.texels[i] > 4.2f)
            ++coarser;
    }
    EXPECT_GT(coarser, 20);
}

// Every level its own value, so that the picture shows the level used.
TEST_F(RenderedLevels, LambdaFallsTowardsGrazingAnglesAsTheTwinSays)
{
    std::vector<EnvironmentMap> levels;
    for (int size = 256; size >= 1; size /= 2) {
        const float value = float(levels.size());
        levels.push_back(environmentFrom({Parameterization::Cube, size, 0}, [=](const glm::dvec3&) { return glm::vec3(value); }));
    }
    const MapLevels maps = std::make_shared<const std::vector<EnvironmentMap>>(levels);
    RenderSettings settings = small(GeometryKind::Sphere);
    settings.geometry.level = 64;
    settings.background.kind = Backdrop::None;
    settings.camera.distance = 2.6f;
    Renderer renderer(TexelFormat::Float);
    const Image free = renderer.renderRadiance(settings, {maps, {}, {}});
    settings.material.lambda = 5.0f;
    for (const float grazing : {0.0f, 1.0f, 2.0f}) {
        settings.material.lambdaGrazing = grazing;
        const Image picture = renderer.renderRadiance(settings, {maps, {}, {}});
        const GeometryBuffers buffers = renderer.renderBuffers(settings);
        int atGrazing = 0;
        for (int y = 0; y < settings.height; ++y)
            for (int x = 0; x < settings.width; ++x) {
                if (!isInterior(buffers.position, x, y))
                    continue;
                const glm::dvec3 v = glm::normalize(glm::dvec3(settings.camera.eye()) - at(buffers.position, x, y));
                const double c = glm::dot(at(buffers.normal, x, y), v);
                ASSERT_NEAR(picture.texel(x, y)[0], std::max(double(free.texel(x, y)[0]), lambdaAt(5.0, grazing, c)), 2e-3)
                    << grazing << ' ' << c;
                atGrazing += c < 0.3;
            }
        EXPECT_GT(atGrazing, 50);
    }
}

// The level follows the direction, which knows no seam: along a line across seams it may not jump.
TEST_F(RenderedLevels, TheLevelDoesNotJumpAtSeams)
{
    Renderer renderer(TexelFormat::Float);
    for (const MapLayout& layout : everyLayout(256)) {
        std::vector<EnvironmentMap> levels;
        for (MapLayout level = layout; level.size >= 1; level.size /= 2, level.border = (level.border + 1) / 2) {
            if (2 * level.border >= level.size)
                level.border = 0;
            const float value = float(levels.size());
            levels.push_back(environmentFrom(level, [=](const glm::dvec3&) { return glm::vec3(value); }));
        }
        RenderSettings settings = small(GeometryKind::Sphere);
        settings.geometry.level = 64;
        settings.background.kind = Backdrop::None;
        settings.camera.distance = 2.6f;
        settings.width = 320;
        settings.height = 240;
        const Image picture = renderer.renderRadiance(settings, {std::make_shared<const std::vector<EnvironmentMap>>(levels), {}, {}});
        const GeometryBuffers buffers = renderer.renderBuffers(settings);
        for (int y = 1; y < settings.height - 1; ++y)
            for (int x = 1; x < settings.width - 1; ++x) {
                if (!isInterior(buffers.position, x, y) || !isInterior(buffers.position, x + 1, y))
                    continue;
                const glm::dvec3 n = at(buffers.normal, x, y);
                const glm::dvec3 v = glm::normalize(glm::dvec3(settings.camera.eye()) - at(buffers.position, x, y));
                if (glm::dot(n, v) < 0.3)
                    continue; // towards the silhouette the level rises fast by right
                ASSERT_LT(std::abs(picture.texel(x, y)[0] - picture.texel(x + 1, y)[0]), 0.25f)
                    << name(layout.kind) << ' ' << x << ' ' << y;
            }
    }
}
