#include "core/preview/renderer.h"

#include "flat_square.h"
#include "gl_fixture.h"
#include "small_pictures.h"
#include "test_environments.h"

#include "core/image/picture_levels.h"

#include <algorithm>
#include <cmath>

using namespace mirrorball;
using namespace mirrorball::preview;
using namespace mirrorball::test;

using Dithering = mirrorball::test::GlTest;

namespace {

float linearOf(double step) { return decodeSrgb(static_cast<float>(step / 255.0)); }

/// Steps of 8 bits.
double stepsOf(const float* texel) { return 255.0 * texel[0]; }

/// Nothing but the background, all over.
RenderSettings backgroundOf(double step)
{
    RenderSettings settings = squareSettings();
    settings.width = settings.height = 16;
    settings.camera.target = {1000.0f, 0.0f, 0.0f};
    settings.background = {.kind = Backdrop::Color, .color = glm::vec3(linearOf(step))};
    settings.toneCurve = ToneCurve::None;
    return settings;
}

Image drawn(Renderer& renderer, RenderSettings settings, bool dither, const RenderMaps& maps = {})
{
    settings.dither = dither;
    return renderer.renderDisplay(settings, maps);
}

/// Of a block of 8 x 8 pixels: the pattern's period.
double blockMean(const Image& image, int x0, int y0)
{
    double sum = 0.0;
    for (int y = y0; y < y0 + 8; ++y)
        for (int x = x0; x < x0 + 8; ++x)
            sum += stepsOf(image.texel(x, y));
    return sum / 64.0;
}

} // namespace

// 64 thresholds 0.84 / 64 apart miss a value by half of that, and those at the pattern's ends, 0.84 apart and not 1, by 0.08: 0.082 at
// most.
TEST_F(Dithering, KeepsTheMeanOfWhatRoundingMoves)
{
    Renderer renderer;
    double mostWithout = 0.0;
    for (double step = 20.0; step < 23.0; step += 0.0625) {
        const Image with = drawn(renderer, backgroundOf(step), true), without = drawn(renderer, backgroundOf(step), false);
        for (const int x : {0, 8})
            for (const int y : {0, 8})
                ASSERT_NEAR(blockMean(with, x, y), step, 0.085) << step;
        mostWithout = std::max(mostWithout, std::abs(blockMean(without, 0, 0) - step));
    }
    EXPECT_GT(mostWithout, 0.4);
}

// On the object: a ramp of two steps from the left to the right. Within a block of 8 pixels it rises by a quarter of a step, and the means
// of pattern and ramp differ by 0.088 at most; two halves on the way may take 0.01 each.
TEST_F(Dithering, OfARampFollowsItWhereRoundingMakesBands)
{
    Renderer renderer;
    const auto ramp = [](int x) { return 12.0 + 2.0 * (x + 0.5) / squareEdge; };
    Image picture(squareEdge, squareEdge, 3);
    for (int y = 0; y < squareEdge; ++y)
        for (int x = 0; x < squareEdge; ++x)
            std::fill_n(picture.texel(x, y), 3, linearOf(ramp(x)));
    RenderSettings settings = squareSettings();
    settings.toneCurve = ToneCurve::None;
    settings.material.diffuse = glm::vec3(1.0f);
    settings.material.hasDiffusePicture = true;
    const RenderMaps maps{.diffuse =
                              asLevels(environmentFrom({Parameterization::Cube, 4, 0}, [](const glm::dvec3&) { return glm::vec3(1.0f); })),
                          .diffusePicture = std::make_shared<const std::vector<Image>>(pictureLevels(std::move(picture)))};
    const Image with = drawn(renderer, settings, true, maps), without = drawn(renderer, settings, false, maps);
    double mostWithout = 0.0;
    for (int y = 0; y < squareEdge; y += 8)
        for (int x = 0; x < squareEdge; x += 8) {
            const double mean = 0.5 * (ramp(x) + ramp(x + 7));
            ASSERT_NEAR(blockMean(with, x, y), mean, 0.11) << x << ' ' << y;
            mostWithout = std::max(mostWithout, std::abs(blockMean(without, x, y) - mean));
        }
    EXPECT_GT(mostWithout, 0.3);
}

TEST_F(Dithering, LeavesWhatAByteHoldsAsItIs)
{
    Renderer renderer;
    for (int step = 0; step <= 255; ++step) {
        const Image with = drawn(renderer, backgroundOf(step), true);
        for (int y = 0; y < with.height; ++y)
            for (int x = 0; x < with.width; ++x)
                ASSERT_EQ(std::lround(stepsOf(with.texel(x, y))), step) << x << ' ' << y;
    }
}

// The same on the object, whose samples are halves.
TEST_F(Dithering, LeavesWhatAByteHoldsAsItIsOnTheObject)
{
    Renderer renderer(TexelFormat::Float);
    RenderSettings settings = squareSettings();
    settings.width = settings.height = 8;
    settings.toneCurve = ToneCurve::None;
    const RenderMaps maps{.diffuse =
                              asLevels(environmentFrom({Parameterization::Cube, 4, 0}, [](const glm::dvec3&) { return glm::vec3(1.0f); }))};
    for (int step = 1; step <= 255; ++step) {
        settings.material.diffuse = glm::vec3(linearOf(step));
        const Image with = drawn(renderer, settings, true, maps);
        for (int y = 0; y < 8; ++y)
            for (int x = 0; x < 8; ++x)
                ASSERT_EQ(std::lround(stepsOf(with.texel(x, y))), step) << x << ' ' << y;
    }
}

// Colors stay multiplied by an opacity that is rounded by itself: none is brighter than it.
TEST_F(Dithering, KeepsNothingTransparentAndNoColorAboveItsOpacity)
{
    Renderer renderer;
    RenderSettings settings = small(GeometryKind::Sphere);
    settings.samples = 4;
    settings.background.kind = Backdrop::None;
    settings.material.specular = glm::vec3(100.0f);
    const Image with =
        drawn(renderer, settings, true, {.specular = asLevels(environmentFrom({Parameterization::Cube, 8, 0}, smoothRadiance))});
    int beside = 0, edge = 0;
    for (int y = 0; y < with.height; ++y)
        for (int x = 0; x < with.width; ++x) {
            const float* t = with.texel(x, y);
            for (int c = 0; c < 3; ++c)
                ASSERT_LE(t[c], t[3]) << x << ' ' << y;
            beside += t[3] == 0.0f;
            edge += t[3] > 0.0f && t[3] < 1.0f;
        }
    EXPECT_GT(beside, 100);
    EXPECT_GT(edge, 10);
}

// Neither depends on where in a window the picture lies, nor touches radiance.
TEST_F(Dithering, IsOfThePicturesOwnPixelsAndOfThoseForTheDisplayAlone)
{
    Renderer renderer;
    RenderSettings settings = small(GeometryKind::Torus);
    const RenderMaps maps{.specular = asLevels(environmentFrom({Parameterization::Cube, 16, 0}, smoothRadiance))};
    settings.background.kind = Backdrop::Color;
    const Image plainLight = renderer.renderRadiance(settings, maps), plain = renderer.renderDisplay(settings, maps);
    settings.dither = true;
    EXPECT_EQ(renderer.renderRadiance(settings, maps), plainLight);
    const Image with = renderer.renderDisplay(settings, maps);
    EXPECT_NE(with, plain);
    const RenderTarget window(settings.width + 10, settings.height + 10, 1, GL_RGBA8, 1, GL_NONE);
    renderer.drawDisplay(settings, maps, {.framebuffer = window.framebuffer, .x = 3, .y = 5});
    const Image shown = readImage(window);
    for (int y = 0; y < settings.height; ++y)
        for (int x = 0; x < settings.width; ++x)
            for (int c = 0; c < 4; ++c)
                ASSERT_EQ(shown.texel(x + 3, y + 5)[c], with.texel(x, y)[c]) << x << ' ' << y;
}
