#include "core/preview/picture_file.h"
#include "core/preview/renderer.h"
#include "core/scene/surface_picture.h"

#include "flat_square.h"
#include "gl_fixture.h"
#include "small_pictures.h"
#include "test_environments.h"
#include "tests/support/temporary_folder.h"

#include <algorithm>
#include <cmath>

using namespace mirrorball;
using namespace mirrorball::preview;
using namespace mirrorball::test;

using NormalMaps = mirrorball::test::GlTest;

namespace {

/// A step of 8 bits between normals: colors of Shading::Normals are half as far apart.
constexpr double byteStep = 2.0 / 255.0;

/// The same vector everywhere.
PictureLevels constantNormal(const glm::vec3& vector)
{
    Image texel(1, 1, 3);
    std::copy(&vector.x, &vector.x + 3, texel.texels.begin());
    return std::make_shared<const std::vector<Image>>(1, std::move(texel));
}

/// Dents and bumps, steep ones among them.
PictureLevels roughNormals()
{
    Image picture(64, 64, 3);
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x) {
            const glm::vec3 n = glm::normalize(glm::vec3(2.0 * std::sin(0.4 * x), 2.0 * std::sin(0.3 * y), 0.5));
            std::copy(&n.x, &n.x + 3, picture.texel(x, y));
        }
    return std::make_shared<const std::vector<Image>>(pictureLevels(std::move(picture)));
}

MapLevels smoothLight() { return asLevels(environmentFrom({Parameterization::Cube, 32, 0}, smoothRadiance)); }

/// The normals that the debug view shows.
Image shownNormals(Renderer& renderer, RenderSettings settings, const PictureLevels& map)
{
    settings.shading = Shading::Normals;
    Image normals = renderer.renderRadiance(settings, {.normalMap = map});
    for (size_t i = 0; i < normals.texels.size(); ++i)
        if (i % 4 != 3)
            normals.texels[i] = 2.0f * normals.texels[i] - 1.0f;
    return normals;
}

double difference(const Image& a, const Image& b)
{
    double most = 0.0;
    for (size_t i = 0; i < a.texels.size(); ++i)
        most = std::max(most, std::abs(double(a.texels[i]) - double(b.texels[i])));
    return most;
}

/// A coated ball that mirrors and scatters, before nothing.
RenderSettings everything(GeometryKind kind)
{
    RenderSettings settings = small(kind);
    settings.background.kind = Backdrop::None;
    settings.material.diffuse = glm::vec3(0.5f);
    settings.material.fresnel = {.kind = FresnelKind::Dielectric, .index = 1.5};
    settings.material.clearCoat = {.weight = 0.5f, .index = 1.5};
    return settings;
}

} // namespace

// A normal that is computed anew differs in its last bits; light that varies by 0.5 over the sphere does not show them.
TEST_F(NormalMaps, ThatAreFlatLeaveThePictureAsItWas)
{
    Renderer renderer;
    const MapLevels light = smoothLight();
    for (const GeometryKind kind : {GeometryKind::Sphere, GeometryKind::Torus, GeometryKind::Teapot, GeometryKind::Box}) {
        RenderSettings settings = everything(kind);
        RenderMaps maps{.specular = light, .diffuse = light, .clearCoat = light};
        const Image without = renderer.renderRadiance(settings, maps);
        settings.material.normalStrength = 1.0f;
        maps.normalMap = constantNormal({0.0f, 0.0f, 1.0f});
        EXPECT_LT(difference(renderer.renderRadiance(settings, maps), without), 1e-3) << static_cast<int>(kind);
    }
}

TEST_F(NormalMaps, OfStrengthZeroAreNeverLookedAt)
{
    Renderer renderer;
    const MapLevels light = smoothLight();
    RenderSettings settings = everything(GeometryKind::Torus);
    RenderMaps maps{.specular = light, .diffuse = light, .clearCoat = light};
    const Image without = renderer.renderRadiance(settings, maps);
    maps.normalMap = roughNormals();
    EXPECT_EQ(renderer.renderRadiance(settings, maps), without);
    settings.material.normalStrength = 1.0f;
    EXPECT_GT(difference(renderer.renderRadiance(settings, maps), without), 0.1);
    maps.normalMap = nullptr;
    EXPECT_THROW(renderer.renderRadiance(settings, maps), InvalidArgument);
}

// On the square u runs along +X and v along +Y, and the surface looks to +Z: the map's vectors are the world's. Strength multiplies x and
// y.
TEST_F(NormalMaps, TiltTheNormalsOfASquareAsTheySay)
{
    Renderer renderer;
    RenderSettings settings = squareSettings(3.0f);
    for (const glm::vec3 vector : {glm::vec3(0.3f, 0.0f, 0.954f), glm::vec3(0.0f, 0.25f, 0.968f), glm::vec3(-0.2f, -0.1f, 0.975f)})
        for (const float strength : {0.5f, 1.0f, 2.0f}) {
            settings.material.normalStrength = strength;
            const Image shown = shownNormals(renderer, settings, constantNormal(vector));
            const glm::vec3 expected = glm::normalize(glm::vec3(strength * vector.x, strength * vector.y, vector.z));
            for (int y = 0; y < squareEdge; y += 7)
                for (int x = 0; x < squareEdge; x += 7)
                    for (int c = 0; c < 3; ++c)
                        ASSERT_NEAR(shown.texel(x, y)[c], expected[c], byteStep) << x << ' ' << y << ' ' << strength;
        }
}

// The side of the ball that looks to +Z has u = 1/2 + atan(x / z) 2 / pi, and v so of y. Their gradients on the unit ball are
// (z, 0, -x) / (x^2 + z^2) and (0, z, -y) / (y^2 + z^2), times 2 / pi each; both are divided by the longer.
TEST_F(NormalMaps, TiltTheNormalsOfABallAlongItsTextureCoordinates)
{
    Renderer renderer;
    RenderSettings settings = squareSettings();
    settings.width = settings.height = 160;
    settings.geometry = {.kind = GeometryKind::Sphere, .level = 128};
    const Image own = shownNormals(renderer, settings, nullptr);
    settings.material.normalStrength = 1.0f;
    const glm::dvec3 tilt(0.2, 0.1, 0.97);
    const Image shown = shownNormals(renderer, settings, constantNormal(tilt));
    int compared = 0;
    for (int y = 1; y < own.height - 1; ++y)
        for (int x = 1; x < own.width - 1; ++x) {
            const glm::dvec3 n = at(own, x, y);
            if (!isInterior(own, x, y) || std::max(std::abs(n.x), std::abs(n.y)) > 0.9 * n.z)
                continue;
            const glm::dvec3 u = glm::dvec3(n.z, 0.0, -n.x) / (n.x * n.x + n.z * n.z);
            const glm::dvec3 v = glm::dvec3(0.0, n.z, -n.y) / (n.y * n.y + n.z * n.z);
            const double longer = std::max(glm::length(u), glm::length(v));
            const glm::dvec3 expected = glm::normalize(tilt.z * n + (tilt.x * u + tilt.y * v) / longer);
            for (int c = 0; c < 3; ++c)
                ASSERT_NEAR(shown.texel(x, y)[c], expected[c], byteStep) << x << ' ' << y;
            ++compared;
        }
    EXPECT_GT(compared, 1000);
}

// The mirror direction is that of the tilted normal: nothing is mirrored into the surface, however steep the map.
TEST_F(NormalMaps, MirrorNothingIntoTheSurface)
{
    Renderer renderer;
    const MapLevels light = smoothLight();
    RenderSettings settings = squareSettings();
    settings.material.specular = glm::vec3(1.0f);
    settings.material.normalStrength = 4.0f;
    for (const float yaw : {0.0f, 0.7f, 1.3f, 1.5f}) {
        settings.camera.yaw = yaw;
        renderer.renderRadiance(settings, {.specular = light, .normalMap = roughNormals()});
        const GeometryBuffers buffers = renderer.renderBuffers(settings);
        const glm::dvec3 v(settings.camera.viewer());
        int tilted = 0;
        for (int y = 0; y < squareEdge; ++y)
            for (int x = 0; x < squareEdge; ++x) {
                if (!isObject(buffers.normal, x, y))
                    continue;
                const glm::dvec3 n = at(buffers.normal, x, y);
                EXPECT_GT(glm::dot(n, v), 0.0) << x << ' ' << y << ' ' << yaw;
                EXPECT_GT(at(buffers.direction, x, y).z, -1e-4) << x << ' ' << y << ' ' << yaw;
                tilted += n.z < 0.9;
            }
        EXPECT_TRUE(tilted > 20 || yaw > 1.0f) << yaw;
    }
}

TEST_F(NormalMaps, AreSeenByEveryPartOfTheMaterial)
{
    Renderer renderer;
    const MapLevels light = smoothLight();
    Image places(64, 64, 4);
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x) {
            const glm::vec4 c((float(x) + 0.5f) / 64.0f, (float(y) + 0.5f) / 64.0f, 0.5f, 1.0f);
            std::copy(&c.x, &c.x + 4, places.texel(x, y));
        }
    RenderMaps maps{.specular = light,
                    .diffuse = light,
                    .sphereMaps = {std::make_shared<const SphereMapTexels>(SphereMapTexels{.levels = {std::move(places)}})},
                    .clearCoat = light,
                    .normalMap = constantNormal({0.5f, 0.2f, 0.84f})};
    const auto change = [&](MaterialSettings material) {
        RenderSettings settings = squareSettings();
        settings.material = std::move(material);
        const Image without = renderer.renderRadiance(settings, maps);
        settings.material.normalStrength = 1.0f;
        return difference(renderer.renderRadiance(settings, maps), without);
    };
    const glm::vec3 none(0.0f);
    EXPECT_GT(change({.specular = glm::vec3(1.0f)}), 0.1);
    EXPECT_GT(change({.specular = none, .diffuse = glm::vec3(1.0f)}), 0.1);
    EXPECT_GT(change({.specular = none, .clearCoat = {.weight = 1.0f, .index = 3.0}}), 0.02);
    EXPECT_GT(change({.specular = none, .paint = {.use = SphereMapUse::Replace}}), 0.1);
}

// What is picked is what was drawn.
TEST_F(NormalMaps, AreThoseThatAPickFinds)
{
    Renderer renderer;
    RenderSettings settings = squareSettings();
    settings.material.normalStrength = 1.0f;
    const glm::vec3 vector(0.3f, 0.1f, 0.949f);
    shownNormals(renderer, settings, constantNormal(vector));
    const auto hit = renderer.pick(settings, 20, 30);
    ASSERT_TRUE(hit);
    EXPECT_LT(glm::distance(hit->normal, glm::normalize(vector)), 1e-3f);
    EXPECT_NEAR(hit->texCoord.x, 20.5f / squareEdge, 1e-3f);
    settings.material.normalStrength = 0.0f;
    EXPECT_LT(glm::distance(renderer.pick(settings, 20, 30)->normal, glm::vec3(0.0f, 0.0f, 1.0f)), 1e-5f);
}

// The picture is not there: were it read first, the line would be about that.
TEST(NormalMapOfAScene, IsRefusedBeforeAnyWorkOnAMeshWithoutTextureCoordinates)
{
    const TemporaryFolder folder;
    writeBytes(folder / "bare.obj", "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nf 1 2 3 4\n");
    Scene scene{.folder = folder.path()};
    scene.view = {.geometry = "bare.obj", .width = 16, .height = 16};
    scene.material.normalMap.source = "gone.exr";
    const auto problem = [&] {
        try {
            drawPicture(planScene(scene), PictureLight::Radiance);
        } catch (const InvalidArgument& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    EXPECT_EQ(problem(), "material.normal_map.source: \"gone.exr\" lies on the mesh by its texture coordinates, and \"bare.obj\" has none; "
                         "unwrap the mesh in a modeller, or leave the picture out");
    scene.material.normalMap.strength = 0.0;
    EXPECT_EQ(problem(), "");
}
