#include "core/image/map_picture.h"

#include "core/base/error.h"
#include "core/image/builtin_probes.h"
#include "core/image/color_scale.h"
#include "core/image/reproject.h"
#include "core/sphere/map_sheet.h"

#include "support/probe_builders.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace mirrorball {
namespace {

MipPyramid pyramidOf(const EnvironmentMap& map) { return buildMipPyramid(map); }

/// The whole sheet of a layout in `width` pixels.
MapWindow wholeSheet(const MapLayout& layout, int width)
{
    const SheetSize sheet = sheetSize(layout);
    const double scale = static_cast<double>(width) / sheet.width;
    return {.layout = layout, .scale = scale, .width = width, .height = static_cast<int>(std::lround(sheet.height * scale))};
}

TEST(MapPicture, ShowsTheTexelsThemselvesWhenEnlarged)
{
    const EnvironmentMap map = test::noiseProbe(8, 3);
    const Image window = mapWindow(pyramidOf(map), {.layout = map.layout, .origin = {2.0, 1.0}, .scale = 4.0, .width = 16, .height = 12});
    for (int y = 0; y < 12; ++y)
        for (int x = 0; x < 16; ++x)
            for (int c = 0; c < 3; ++c)
                EXPECT_EQ(window.texel(x, y)[c], map.image.texel(2 + x / 4, 1 + y / 4)[c]);
}

// Enlarged, a pixel asks the map for the direction that lies under it, in whatever layout that is.
TEST(MapPicture, LooksUpTheDirectionUnderEachPixelInAnotherParameterization)
{
    const EnvironmentMap map = test::noiseProbe(32, 5);
    for (const Parameterization kind : allParameterizations) {
        const MapWindow window{.layout = {kind, 64, 0}, .origin = {3.0, 70.0}, .scale = 3.0, .width = 120, .height = 90};
        const Image picture = mapWindow(pyramidOf(map), window);
        for (int y = 0; y < window.height; y += 7)
            for (int x = 0; x < window.width; x += 7) {
                const auto p = imageFromSheet(window.layout, sheetPosition(window, {x + 0.5, y + 0.5}));
                if (picture.texel(x, y)[3] < 1.0f)
                    continue;
                const glm::vec3 expected = map.radiance(direction(window.layout, p.value()));
                for (int c = 0; c < 3; ++c)
                    EXPECT_NEAR(picture.texel(x, y)[c], expected[c], 1e-6f) << name(kind);
            }
    }
}

// A reduced picture neither loses nor makes light: the mean over a latlong's rows, weighted by their solid angle, stays.
TEST(MapPicture, KeepsTheMeanOfAMapThatIsReduced)
{
    const EnvironmentMap map = test::sunProbe(256, 5000.0f, 200, 90);
    const MapWindow reduced = wholeSheet(map.layout, 32);
    const Image window = mapWindow(pyramidOf(map), reduced);
    const MapLayout small{Parameterization::Latlong, 16, 0};
    double sum = 0.0;
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 32; ++x)
            sum += texelSolidAngle(small, x, y) * window.texel(x, y)[0];
    EXPECT_NEAR(sum / (4.0 * pi) / meanRadiance(map).r, 1.0, 0.15); // bilinear lookups of the pyramid's levels are no box average
}

TEST(MapPicture, IsTransparentBesideTheMap)
{
    const MapLayout angular{Parameterization::Angular, 32, 0}, cube{Parameterization::Cube, 16, 0};
    const MipPyramid one = pyramidOf(test::constantProbe(16));
    EXPECT_EQ(mapWindow(one, wholeSheet(angular, 64)).texel(0, 0)[3], 0.0f);
    EXPECT_EQ(mapWindow(one, wholeSheet(angular, 64)).texel(32, 32)[3], 1.0f);
    EXPECT_EQ(mapWindow(one, wholeSheet(cube, 64)).texel(2, 2)[3], 0.0f);
    EXPECT_EQ(mapWindow(one, wholeSheet(cube, 64)).texel(20, 20)[3], 1.0f);
    const Image beside = mapWindow(one, {.layout = cube, .origin = {-500.0, -500.0}, .width = 4, .height = 4});
    EXPECT_THAT(beside.texels, testing::Each(0.0f));
}

TEST(MapPicture, ColorsLuminanceOnItsScaleAndClampsBeyondIt)
{
    Image window(4, 1, 4, 1.0f);
    for (int x = 0; x < 4; ++x)
        for (int c = 0; c < 3; ++c)
            window.texel(x, 0)[c] = std::array{1e-6f, 0.25f, 1.0f, 1e9f}[static_cast<size_t>(x)];
    const Image colors = windowColors(window, {.colors = MapColors::Luminance, .low = 0.0625, .high = 1.0});
    const auto at = [&](int x) { return glm::vec3(colors.texel(x, 0)[0], colors.texel(x, 0)[1], colors.texel(x, 0)[2]); };
    EXPECT_LT(glm::length(at(0) - falseColor(0.0)), 1e-6);
    EXPECT_LT(glm::length(at(1) - falseColor(0.5)), 1e-6);
    EXPECT_LT(glm::length(at(2) - falseColor(1.0)), 1e-6);
    EXPECT_LT(glm::length(at(3) - falseColor(1.0)), 1e-6);
    EXPECT_THROW(windowColors(window, {.colors = MapColors::Luminance, .low = 1.0, .high = 1.0}), InvalidArgument);
}

TEST(ColorScale, RisesInLightnessAndIsNeutralInTheMiddle)
{
    const auto lightness = [](const glm::vec3& c) {
        return 0.2126 * decodeSrgb(c.r) + 0.7152 * decodeSrgb(c.g) + 0.0722 * decodeSrgb(c.b);
    };
    for (int i = 1; i <= 32; ++i)
        EXPECT_GT(lightness(falseColor(i / 32.0)), lightness(falseColor((i - 1) / 32.0)));
    EXPECT_EQ(signedColor(0.0).r, signedColor(0.0).g);
    EXPECT_EQ(signedColor(0.0).g, signedColor(0.0).b);
    EXPECT_NEAR(lightness(signedColor(1.0)) / lightness(signedColor(-1.0)), 1.0, 0.15);
}

// The grid's brightest lines are the planes of the axes: on a latlong of height N the equator is the row at N/2.
TEST(MapPicture, DrawsTheEquatorWhereTheLatlongHasIt)
{
    const MapLayout latlong{Parameterization::Latlong, 64, 0};
    const Image overlay = mapOverlay(wholeSheet(latlong, 256), {.grid = true});
    EXPECT_GT(overlay.texel(40, 64)[3], 0.55f); // half a pixel from it
    EXPECT_LT(overlay.texel(37, 71)[3], 0.05f); // between the lines of 15 degrees
    EXPECT_GT(overlay.texel(37, 42)[3], 0.1f);  // latitude 30: 128/6 = 21.3 pixels up
}

TEST(MapPicture, DrawsSeamsAtTheEdgesOfCharts)
{
    const MapLayout cube{Parameterization::Cube, 32, 0};
    const Image overlay = mapOverlay(wholeSheet(cube, 256), {.seams = true});
    EXPECT_GT(overlay.texel(64, 96)[3], 0.5f);
    EXPECT_EQ(overlay.texel(96, 96)[3], 0.0f);
}

TEST(MapPicture, TintsEqualAreaMapsEvenly)
{
    const MapLayout sphere{Parameterization::Sphere, 64, 0};
    const Image overlay = mapOverlay(wholeSheet(sphere, 64), {.tint = MapTint::SolidAngle});
    for (const auto& [x, y] : {std::pair{32, 32}, {10, 32}, {32, 55}})
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(overlay.texel(x, y)[c], signedColor(0.0)[c], 0.02);
}

TEST(MapPicture, DifferenceOfAMapWithItselfIsNothing)
{
    const EnvironmentMap probe = test::noiseProbe(16, 9);
    EXPECT_THAT(difference(probe, probe).image.texels, testing::Each(0.0f));
    const EnvironmentMap constant = test::constantProbe(16, 2.0f);
    const EnvironmentMap elsewhere = reproject(constant, {.target = {Parameterization::Paraboloid, 32, 0}});
    for (const float value : difference(elsewhere, constant).image.texels)
        EXPECT_NEAR(value, 0.0f, 1e-5f);
}

TEST(MapPicture, FindsARangeThatHoldsAlmostAllTexels)
{
    const LuminanceRange range = luminanceRange(test::sunProbe(64, 1e6f, 60, 20));
    EXPECT_GT(range.high / range.low, 2.0);
    EXPECT_LT(range.low, 1e-2);
    const LuminanceRange black = luminanceRange(EnvironmentMap(MapLayout{Parameterization::Latlong, 8, 0}));
    EXPECT_GT(black.low, 0.0);
    EXPECT_GT(black.high, black.low);
}

TEST(MapPicture, RefusesWindowsThatShowNothing)
{
    const MipPyramid one = pyramidOf(test::constantProbe(4));
    EXPECT_THROW(mapWindow(one, {.layout = {Parameterization::Cube, 4, 0}, .scale = 0.0}), InvalidArgument);
    EXPECT_THROW(mapWindow(one, {.layout = {Parameterization::Cube, 4, 0}, .width = 0}), InvalidArgument);
    EXPECT_THROW(mapOverlay({.layout = {Parameterization::Cube, 4, 0}}, {.gridStepDeg = 0.0}), InvalidArgument);
}

} // namespace
} // namespace mirrorball
