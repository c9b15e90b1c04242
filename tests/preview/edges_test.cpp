#include "core/preview/renderer.h"

#include "gl_fixture.h"
#include "test_environments.h"

#include <cmath>

using namespace mirrorball;
using namespace mirrorball::preview;
using namespace mirrorball::test;

using Edges = mirrorball::test::GlTest;

namespace {

constexpr double slope = 0.15; ///< of the edge: a staircase has a step every seventh row

/// A disc that is dark on one side of a line through its middle and so bright on the other.
SphereMapChain halves(float bright)
{
    constexpr int size = 1024;
    Image image(size, size, 4);
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            const float light = x + 0.5 - 0.5 * size > slope * (y + 0.5 - 0.5 * size) ? bright : 0.01f;
            for (int c = 0; c < 3; ++c)
                image.texel(x, y)[c] = light;
            image.texel(x, y)[3] = 1.0f;
        }
    return std::make_shared<const SphereMapTexels>(SphereMapTexels{.levels = {image}, .index = SphereMapIndex::Normal});
}

RenderSettings ball()
{
    RenderSettings settings;
    settings.width = settings.height = 400;
    settings.geometry = {.kind = GeometryKind::Sphere, .level = 24};
    settings.background.kind = Backdrop::None;
    settings.camera = Camera{.distance = 3.0f, .projection = Projection::Orthographic};
    settings.material.paint.use = SphereMapUse::Replace;
    settings.toneCurve = ToneCurve::None;
    return settings;
}

/// How many of the rows through the middle of the picture show something between both sides, at the edge.
int smoothRows(const Image& picture, int rows)
{
    int smooth = 0;
    for (int y = (picture.height - rows) / 2; y < (picture.height + rows) / 2; ++y) {
        bool between = false;
        for (int x = picture.width / 2 - 40; x < picture.width / 2 + 40; ++x)
            between = between || (picture.texel(x, y)[0] > 0.25f && picture.texel(x, y)[0] < 0.95f);
        smooth += between;
    }
    return smooth;
}

} // namespace

// A straight edge crosses the pixels of nearly every row. Four samples of a pixel span 0.79 of its width, measured across this edge: in so
// many of the rows some lie on either side. The texels, 0.4 pixels wide, make the edge itself a little rough, so that two thirds must be
// found.
TEST_F(Edges, OfHighlightsAreAsSmoothAsOutlinesHoweverBright)
{
    constexpr int rows = 100;
    RenderSettings settings = ball();
    Renderer renderer;
    for (const float bright : {1.0f, 100.0f, 1e4f}) {
        const RenderMaps maps{.sphereMaps = {halves(bright)}};
        settings.samples = 4;
        const Image picture = renderer.renderDisplay(settings, maps);
        EXPECT_GE(smoothRows(picture, rows), 2 * rows / 3) << bright;
        EXPECT_LT(picture.texel(170, 200)[0], 0.2f);
        EXPECT_EQ(picture.texel(230, 200)[0], 1.0f);
    }
    settings.samples = 1; // the staircase that a lookup a pixel makes
    EXPECT_LT(smoothRows(renderer.renderDisplay(settings, {.sphereMaps = {halves(1e4f)}}), rows), rows / 10);
}

// What has no edges is what it was with one sample: nothing but edges is shaded again.
TEST_F(Edges, AreAllThatChangesWithMoreSamples)
{
    RenderSettings settings = ball();
    const SphereMapChain map = halves(1e4f);
    Renderer renderer;
    const Image four = renderer.renderDisplay(settings, {.sphereMaps = {map}});
    settings.samples = 1;
    const Image one = renderer.renderDisplay(settings, {.sphereMaps = {map}});
    for (int y = 150; y < 250; ++y)
        for (int x = 100; x < 300; ++x)
            if (std::abs(x - 200 - slope * (y - 200)) > 6.0) {
                ASSERT_EQ(four.texel(x, y)[0], one.texel(x, y)[0]) << x << " " << y;
            }
}

TEST_F(Edges, AreNoMatterOfRadiance)
{
    RenderSettings settings = ball();
    settings.samples = 4;
    const Image picture = Renderer().renderRadiance(settings, {.sphereMaps = {halves(1e4f)}});
    EXPECT_NEAR(picture.texel(230, 200)[0], 1e4f, 1.0f); // weights of a lookup are of 8 bits or more
}
