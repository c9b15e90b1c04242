#include "core/preview/renderer.h"
#include "core/preview/window_mesh.h"
#include "core/preview/window_view.h"

#include "gl_fixture.h"

#include <cmath>

using namespace mirrorball;
using namespace mirrorball::preview;
using namespace mirrorball::test;

using WindowTest = mirrorball::test::GlTest;

namespace {

SphereMapChain places(float alpha = 1.0f)
{
    Image image(256, 256, 4);
    for (int y = 0; y < 256; ++y)
        for (int x = 0; x < 256; ++x) {
            float* t = image.texel(x, y);
            t[0] = alpha * (float(x) + 0.5f) / 256.0f;
            t[1] = alpha * (1.0f - (float(y) + 0.5f) / 256.0f);
            t[2] = 0.0f;
            t[3] = alpha;
        }
    return std::make_shared<const SphereMapTexels>(SphereMapTexels{.levels = {image}});
}

RenderSettings view(MapSpace space)
{
    RenderSettings settings;
    settings.width = 160;
    settings.height = 120;
    settings.samples = 1;
    settings.geometry.kind = GeometryKind::Window;
    settings.background.kind = Backdrop::None;
    settings.material.paint.space = space;
    settings.camera = Camera{.yaw = 0.2f, .pitch = 0.1f, .distance = 3.0f};
    settings.windowDepths = glm::vec3(1e6f);
    return settings;
}

bool isPane(const RenderSettings& settings, Renderer& renderer, int x, int y)
{
    const auto hit = renderer.pick(settings, x, y);
    return hit && std::lround(hit->texCoord.x) == int(window::Part::Pane);
}

glm::dvec2 placeAt(const Image& picture, int x, int y) { return {2.0 * picture.texel(x, y)[0] - 1.0, 2.0 * picture.texel(x, y)[1] - 1.0}; }

} // namespace

TEST_F(WindowTest, ShowsWhatLiesAlongTheLineOfSight)
{
    Renderer renderer;
    for (const float depth : {0.0f, 4.0f, 1000.0f}) {
        RenderSettings settings = view(MapSpace::World);
        settings.windowDepths.x = depth;
        const Image picture = renderer.renderRadiance(settings, {.sphereMaps = {places()}});
        int compared = 0;
        for (int y = 5; y < 115; y += 7)
            for (int x = 30; x < 130; x += 7)
                if (isPane(settings, renderer, x, y)) {
                    const glm::dvec3 position = renderer.pick(settings, x, y)->position;
                    const glm::dvec3 sight = glm::normalize(position - glm::dvec3(settings.camera.eye()));
                    ASSERT_LT(glm::distance(placeAt(picture, x, y), windowPlace(position, sight, depth)), 4e-3);
                    ++compared;
                }
        EXPECT_GT(compared, 20);
    }
}

// The eye stays, the camera turns: a real window shows the same (003 section 4 deplores that a sphere map does not). Its roll is cancelled
// in either form.
TEST_F(WindowTest, TurningTheCameraChangesNothingOutside)
{
    Renderer renderer;
    const auto placeOf = [&](const RenderSettings& settings, const glm::vec3& point) { // on the pane
        const Image picture = renderer.renderRadiance(settings, {.sphereMaps = {places()}});
        const glm::mat4 toClip = settings.camera.worldToClip(160.0f / 120.0f, 6.0f);
        const glm::vec4 clip = toClip * glm::vec4(point, 1.0f);
        const double px = (0.5 + 0.5 * clip.x / clip.w) * 160.0 - 0.5, py = (0.5 - 0.5 * clip.y / clip.w) * 120.0 - 0.5;
        const int x = int(std::floor(px)), y = int(std::floor(py));
        const double fx = px - x, fy = py - y;
        return (1 - fx) * ((1 - fy) * placeAt(picture, x, y) + fy * placeAt(picture, x, y + 1)) +
               fx * ((1 - fy) * placeAt(picture, x + 1, y) + fy * placeAt(picture, x + 1, y + 1));
    };
    const glm::vec3 point(0.25f, 0.0f, 0.0f);
    RenderSettings settings = view(MapSpace::World);
    const glm::dvec2 before = placeOf(settings, point);
    RenderSettings turned = settings;
    // The same eye, looking elsewhere: the target moves about it.
    turned.camera.yaw = 0.05f;
    turned.camera.pitch = 0.0f;
    turned.camera.target = settings.camera.eye() - 3.0f * turned.camera.cameraToWorld()[2];
    EXPECT_LT(glm::distance(placeOf(turned, point), before), 0.01);
    for (const MapSpace space : {MapSpace::Eye, MapSpace::World}) {
        RenderSettings upright = view(space), rolled = upright;
        rolled.camera.roll = 0.5f;
        EXPECT_LT(glm::distance(placeOf(rolled, point), placeOf(upright, point)), 0.01) << int(space);
    }
    turned.material.paint.space = settings.material.paint.space = MapSpace::Eye; // the form of 1999 shifts
    EXPECT_GT(glm::distance(placeOf(turned, point), placeOf(settings, point)), 0.03);
}

// As the eye steps aside a far layer shifts across the pane, a layer on the pane does not, one between them shifts by less.
TEST_F(WindowTest, LayersShiftByTheirDepth)
{
    const glm::dvec3 point(0.2, 0.1, 0.0);
    const auto shift = [&](double depth) {
        const glm::dvec3 a(0.0, 0.2, 3.0), b(0.5, 0.2, 3.0);
        return glm::distance(windowPlace(point, glm::normalize(point - a), depth), windowPlace(point, glm::normalize(point - b), depth));
    };
    EXPECT_LT(shift(0.0), 1e-12);
    EXPECT_LT(shift(0.5), 0.5 * shift(5.0));
    EXPECT_LT(shift(5.0), shift(1e6));
    // For an eye at the reference all depths show the same place.
    const glm::dvec3 sight = glm::normalize(point - windowReference);
    EXPECT_LT(glm::distance(windowPlace(point, sight, 0.5), windowPlace(point, sight, 1e6)), 1e-6);
}

TEST_F(WindowTest, NearLayersCoverFarOnesByTheirOpacity)
{
    Renderer renderer;
    const auto constant = [](const glm::vec4& c) {
        Image image(4, 4, 4);
        for (size_t i = 0; i < image.texels.size(); ++i)
            image.texels[i] = c[int(i % 4)];
        return std::make_shared<const SphereMapTexels>(SphereMapTexels{.levels = {image}});
    };
    const RenderSettings settings = view(MapSpace::World);
    const RenderMaps maps{.sphereMaps = {constant({0.2f, 0, 0, 0.2f}), constant({0, 0.5f, 0, 0.5f}), constant({0, 0, 1, 1})}};
    int x = 80, y = 55;
    ASSERT_TRUE(isPane(settings, renderer, x, y) || isPane(settings, renderer, x += 6, y));
    const Image picture = renderer.renderRadiance(settings, maps);
    EXPECT_NEAR(picture.texel(x, y)[0], 0.2, 1e-3);
    EXPECT_NEAR(picture.texel(x, y)[1], 0.8 * 0.5, 1e-3);
    EXPECT_NEAR(picture.texel(x, y)[2], 0.8 * 0.5 * 1.0, 1e-3);
    EXPECT_THROW(renderer.renderRadiance(settings, {}), InvalidArgument);
}
