#include "core/scene/surface_picture.h"

#include "flat_square.h"
#include "gl_fixture.h"
#include "test_environments.h"

#include "core/preview/picture_file.h"
#include "core/preview/renderer.h"
#include "tests/support/temporary_folder.h"

#include <cmath>

using namespace mirrorball;
using namespace mirrorball::preview;
using namespace mirrorball::test;

using SurfacePictures = mirrorball::test::GlTest;

namespace {

constexpr int edge = squareEdge;

RenderSettings diffuseSquare(float repeats = 1.0f)
{
    RenderSettings settings = squareSettings(repeats);
    settings.material.diffuse = glm::vec3(0.5f, 1.0f, 2.0f);
    settings.material.hasDiffusePicture = true;
    return settings;
}

MapLevels lightOf(const glm::vec3& radiance)
{
    return asLevels(environmentFrom({Parameterization::Cube, 4, 0}, [&](const glm::dvec3&) { return radiance; }));
}

template <class Color>
Image pictureOf(int size, const Color& color)
{
    Image image(size, size, 3);
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            const glm::vec3 c = color(x, y);
            std::copy(&c.x, &c.x + 3, image.texel(x, y));
        }
    return image;
}

PictureLevels levelsOf(Image image) { return std::make_shared<const std::vector<Image>>(pictureLevels(std::move(image))); }

/// Squares of 8 texels in two colors, and in the upper left one a third, so that no turn of it is the same.
glm::vec3 checker(int x, int y)
{
    if (x < 8 && y < 8)
        return {0.0f, 1.0f, 0.25f};
    return (x / 8 + y / 8) % 2 == 0 ? glm::vec3(1.0f, 0.5f, 0.125f) : glm::vec3(0.25f, 0.25f, 1.0f);
}

/// A sphere map in which every place has a color of its own.
SphereMapChain places()
{
    Image image(128, 128, 4);
    for (int y = 0; y < 128; ++y)
        for (int x = 0; x < 128; ++x) {
            const glm::vec4 c((float(x) + 0.5f) / 128.0f, (float(y) + 0.5f) / 128.0f, 0.5f, 1.0f);
            std::copy(&c.x, &c.x + 4, image.texel(x, y));
        }
    return std::make_shared<const SphereMapTexels>(SphereMapTexels{.levels = {std::move(image)}});
}

RenderSettings fleckedSquare(float size = 0.05f)
{
    RenderSettings settings = squareSettings();
    settings.material.paint = {.use = SphereMapUse::Replace, .flecks = {.density = 0.6f, .size = size, .spread = 0.5f}};
    return settings;
}

/// With a pattern that is this share everywhere.
Image flecked(Renderer& renderer, RenderSettings settings, const Image& share)
{
    settings.material.paint.hasFleckPattern = true;
    return renderer.renderRadiance(settings, {.sphereMaps = {places()}, .fleckPattern = levelsOf(share)});
}

double difference(const Image& a, const Image& b)
{
    double most = 0.0;
    for (size_t i = 0; i < a.texels.size(); ++i)
        most = std::max(most, std::abs(double(a.texels[i]) - double(b.texels[i])));
    return most;
}

} // namespace

// Texels on pixels: each shows its texel times color and light. The picture's upper left corner is that of u = 0, v = 1.
TEST_F(SurfacePictures, ACheckerOnASquareHasItsColorsAtItsPixels)
{
    Renderer renderer;
    const RenderSettings settings = diffuseSquare();
    const glm::vec3 light(2.0f, 1.0f, 0.5f);
    const Image drawn =
        renderer.renderRadiance(settings, {.diffuse = lightOf(light), .diffusePicture = levelsOf(pictureOf(edge, checker))});
    for (int y = 0; y < edge; ++y)
        for (int x = 0; x < edge; ++x)
            for (int c = 0; c < 3; ++c)
                ASSERT_NEAR(drawn.texel(x, y)[c], checker(x, y)[c] * light[c] * settings.material.diffuse[c], 1e-3f) << x << ' ' << y;
}

TEST_F(SurfacePictures, RepeatBeyondTheirEdges)
{
    Renderer renderer;
    const Image drawn = renderer.renderRadiance(
        diffuseSquare(2.0f), {.diffuse = lightOf(glm::vec3(1.0f)), .diffusePicture = levelsOf(pictureOf(edge / 2, checker))});
    for (int y = 0; y < edge; ++y)
        for (int x = 0; x < edge; ++x)
            ASSERT_NEAR(drawn.texel(x, y)[1], checker(x % (edge / 2), y % (edge / 2))[1], 1e-3f) << x << ' ' << y;
}

// A pixel covers 16 x 16 texels, the whole picture: half of it one color and half the other.
TEST_F(SurfacePictures, AreTheirMeanFromAfar)
{
    Renderer renderer;
    const Image picture = pictureOf(16, [](int x, int y) { return glm::vec3((x + y) % 2 == 0 ? 1.0f : 0.25f); });
    const Image drawn =
        renderer.renderRadiance(diffuseSquare(edge), {.diffuse = lightOf(glm::vec3(1.0f)), .diffusePicture = levelsOf(picture)});
    for (int y = 0; y < edge; ++y)
        for (int x = 0; x < edge; ++x)
            ASSERT_NEAR(drawn.texel(x, y)[1], 0.625f, 1e-3f) << x << ' ' << y;
}

// Under everything that may lie over it, on a mesh with seams.
TEST_F(SurfacePictures, ThatAreWhiteChangeNothing)
{
    Renderer renderer;
    const MapLevels light = asLevels(environmentFrom({Parameterization::Cube, 16, 0}, smoothRadiance));
    for (const std::optional<SphereMapUse> use : {std::optional<SphereMapUse>{}, std::optional{SphereMapUse::Add}}) {
        RenderSettings settings;
        settings.width = 96;
        settings.height = 64;
        settings.material.diffuse = glm::vec3(0.7f, 0.3f, 0.1f);
        settings.material.fresnel = {.kind = FresnelKind::Dielectric, .index = 1.5};
        settings.material.combine = Combine::Coat;
        settings.material.paint.use = use;
        RenderMaps maps{.specular = light, .diffuse = light, .background = light, .sphereMaps = {places()}};
        const Image without = renderer.renderDisplay(settings, maps);
        settings.material.hasDiffusePicture = true;
        maps.diffusePicture = levelsOf(Image(5, 3, 3, 1.0f));
        EXPECT_EQ(renderer.renderDisplay(settings, maps), without);
        maps.diffusePicture = levelsOf(Image(5, 3, 3, 0.5f));
        EXPECT_NE(renderer.renderDisplay(settings, maps), without);
    }
}

TEST_F(SurfacePictures, ThatNothingShowsAreNeverLookedAt)
{
    Renderer renderer;
    RenderSettings settings = diffuseSquare();
    const RenderMaps maps{.diffuse = lightOf(glm::vec3(1.0f))};
    EXPECT_THROW(renderer.renderRadiance(settings, maps), InvalidArgument);
    settings.material.diffuse = glm::vec3(0.0f);
    EXPECT_NO_THROW(renderer.renderRadiance(settings, maps));
}

TEST_F(SurfacePictures, WhiteHasTheFlecksThatThereWereAndBlackHasNone)
{
    Renderer renderer;
    const RenderSettings settings = fleckedSquare();
    const RenderMaps maps{.sphereMaps = {places()}};
    const Image all = renderer.renderRadiance(settings, maps);
    EXPECT_EQ(flecked(renderer, settings, Image(3, 5, 1, 1.0f)), all);
    RenderSettings none = settings;
    none.material.paint.flecks.density = 1e-8f; // less than any cell's number but 0
    const Image bare = renderer.renderRadiance(none, maps);
    EXPECT_EQ(flecked(renderer, settings, Image(3, 5, 1, 0.0f)), bare);
    EXPECT_GT(difference(all, bare), 0.1);
    none.material.paint.flecks.density = 0.0f;
    EXPECT_LT(difference(renderer.renderRadiance(none, maps), bare), 1e-3);

    // Left white, right black: each side as if the whole were.
    Image halves(edge, 1, 1, 1.0f);
    std::fill(halves.texels.begin() + edge / 2, halves.texels.end(), 0.0f);
    const Image both = flecked(renderer, settings, halves);
    for (int y = 0; y < edge; ++y)
        for (int x = 1; x < edge - 1; ++x) // the picture repeats: at the outer edges it is grey
            for (int c = 0; c < 3 && x != edge / 2 - 1 && x != edge / 2; ++c)
                ASSERT_EQ(both.texel(x, y)[c], (x < edge / 2 ? all : bare).texel(x, y)[c]) << x << ' ' << y;
}

// Flecks lie evenly about the surface's own place: how far the picture differs from one without is in proportion to how many there are, on
// the mean of some hundred cells or more, whose deviation is under 0.02. From afar, where a pixel holds two hundred, what is shown is as
// far between none and all as the pattern says.
TEST_F(SurfacePictures, GreyHasFlecksInProportion)
{
    Renderer renderer;
    const RenderSettings close = fleckedSquare();
    const Image bare = flecked(renderer, close, Image(1, 1, 1, 0.0f));
    const auto amount = [&](float share) {
        const Image drawn = flecked(renderer, close, Image(1, 1, 1, share));
        double sum = 0.0;
        for (size_t i = 0; i < drawn.texels.size(); i += 4)
            sum += std::hypot(double(drawn.texels[i] - bare.texels[i]), double(drawn.texels[i + 1] - bare.texels[i + 1]));
        return sum;
    };
    const double most = amount(1.0f);
    for (const float share : {0.25f, 0.5f})
        EXPECT_NEAR(amount(share) / most, share, 0.05);
    const RenderSettings far = fleckedSquare(0.002f);
    const Image none = flecked(renderer, far, Image(1, 1, 1, 0.0f)), all = flecked(renderer, far, Image(1, 1, 1, 1.0f)),
                some = flecked(renderer, far, Image(1, 1, 1, 0.25f));
    for (size_t i = 0; i < some.texels.size(); ++i)
        ASSERT_NEAR(some.texels[i], none.texels[i] + 0.25f * (all.texels[i] - none.texels[i]), 1e-4f);
}

// The pictures are not there: were they read first, the line would be about that.
TEST(SurfacePictureOfAScene, IsRefusedBeforeAnyWorkOnAMeshWithoutTextureCoordinates)
{
    const TemporaryFolder folder;
    const std::string corners = "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\n";
    writeBytes(folder / "bare.obj", corners + "f 1 2 3 4\n");
    Scene scene{.folder = folder.path()};
    scene.material.specular.weight = 0.0;
    scene.material.diffuse.weight = 1.0;
    scene.view = {.geometry = "bare.obj", .width = 16, .height = 16};
    const auto problem = [&] {
        try {
            drawPicture(planScene(scene), PictureLight::Radiance);
        } catch (const InvalidArgument& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    scene.material.diffuse.picture = "gone.exr";
    EXPECT_EQ(problem(), "material.diffuse.picture: \"gone.exr\" lies on the mesh by its texture coordinates, and \"bare.obj\" has none; "
                         "unwrap the mesh in a modeller, or leave the picture out");
    scene.material.diffuse.picture.clear();
    EXPECT_EQ(problem(), "");
    scene.material.sphereMap = {.source = "jade", .use = SphereMapUse::Over, .flecks = {.cells = {.density = 0.5}, .pattern = "gone.exr"}};
    EXPECT_EQ(problem().find("material.sphere_map.flecks.pattern: \"gone.exr\""), 0u) << problem();
}
