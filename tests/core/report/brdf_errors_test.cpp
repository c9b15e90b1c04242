#include "core/report/brdf_errors.h"

#include "core/base/error.h"
#include "core/filter/brdf_sum.h"
#include "core/report/curve_picture.h"
#include "support/probe_builders.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace mirrorball {
namespace {

const Brdf rough{GgxBrdf{0.25}};

TEST(BrdfErrors, AreNoneWhereTheMethodIsTheTruth)
{
    const EnvironmentMap probe = test::noiseProbe(32, 3);
    const BrdfFrames frames(probe, rough, 0.8);
    EXPECT_EQ(frames.relRms([&](double azimuth) { return filterBrdfSum(probe, rough, {0.8, azimuth}, frames.layout(), 0.0); }), 0.0);
    // Twice the light is an error of 1, in every frame.
    EXPECT_NEAR(frames.relRms([&](double azimuth) {
        EnvironmentMap map = filterBrdfSum(probe, rough, {0.8, azimuth}, frames.layout(), 0.0);
        for (float& value : map.image.texels)
            value *= 2.0f;
        return map;
    }),
                1.0, 1e-12);
}

// In constant light each choice shows its sum of weights: the split sum and the fitted lookups the albedo E, three and Filament 1.
TEST(BrdfErrors, InAFurnaceAreTheEnergyThatAnEngineAdds)
{
    const BrdfErrors errors = measureBrdfErrors(test::constantProbe(32, 1.0f), rough, {.viewsDeg = {0.0, 60.0}});
    ASSERT_EQ(errors.relRms.size(), 5u);
    for (size_t v = 0; v < 2; ++v) {
        const double added = 1.0 / directionalAlbedo(rough, v == 0 ? 0.0 : pi / 3).g - 1.0;
        EXPECT_GT(added, 0.01);
        for (size_t c = 0; c < 3; ++c)
            EXPECT_NEAR(errors.relRms[c][v], 0.0, 2e-4) << describe(errors.choices[c]);
        for (size_t c = 3; c < 5; ++c)
            EXPECT_NEAR(errors.relRms[c][v], added, 2e-3) << describe(errors.choices[c]);
    }
}

TEST(BrdfErrors, StandInTableCsvAndJsonAlike)
{
    const BrdfErrors errors{.model = "ggx:alpha=0.25,ior=1.5",
                            .viewsDeg = {0.0, 75.0},
                            .choices = {{LookupKind::Fitted, 5}, {LookupKind::SplitSum}},
                            .relRms = {{0.0125, 0.05}, {0.1, 0.5}}};
    EXPECT_EQ(brdfErrorsText(errors), "view  lookups:5  split-sum\n0        0.0125     0.1000\n75       0.0500     0.5000\n");
    EXPECT_EQ(brdfErrorsCsv(errors), "model,lookups,view_degrees,rel_rms\r\n"
                                     "\"ggx:alpha=0.25,ior=1.5\",lookups:5,0,0.0125\r\n\"ggx:alpha=0.25,ior=1.5\",lookups:5,75,0.05\r\n"
                                     "\"ggx:alpha=0.25,ior=1.5\",split-sum,0,0.1\r\n\"ggx:alpha=0.25,ior=1.5\",split-sum,75,0.5\r\n");
    const auto json = nlohmann::json::parse(brdfErrorsJson(errors));
    EXPECT_EQ(json["curves"][1]["lookups"], "split-sum");
    EXPECT_EQ(json["curves"][1]["rel_rms"][1], 0.5);
    EXPECT_EQ(json["view_degrees"][1], 75.0);
}

TEST(BrdfErrors, RefuseAViewAlongTheSurface)
{
    EXPECT_THROW(measureBrdfErrors(test::constantProbe(16, 1.0f), rough, {.viewsDeg = {90.0}}), InvalidArgument);
    EXPECT_THROW(measureBrdfErrors(test::constantProbe(16, 1.0f), rough, {.viewsDeg = {}}), InvalidArgument);
}

/// Rows from the top of the first pixel of a column that is nearly a color; -1 without one.
int rowOf(const Image& picture, int x, const glm::vec3& color)
{
    for (int y = 0; y < picture.height; ++y) {
        const float* texel = picture.texel(x, y);
        if (glm::distance(glm::vec3(texel[0], texel[1], texel[2]), color) < 0.02f)
            return y;
    }
    return -1;
}

TEST(CurvePicture, DrawsALineOfADecadeOverADecade)
{
    CurvePlot plot{.title = "t", .xTitle = "x", .yTitle = "y", .xTicks = {0.0, 10.0}};
    plot.curves = {{.label = "falls", .color = curveColor(0), .points = {{0.0, 1.0}, {10.0, 0.01}}},
                   {.label = "level", .color = curveColor(2), .points = {{0.0, 0.1}, {10.0, 0.1}}}};
    const Image picture = curvePicture(plot);
    // A straight line in decades: where it crosses the level one, half way, both stand in one row.
    int crossing = -1;
    for (int x = 0; x < picture.width && crossing < 0; ++x) {
        const int falls = rowOf(picture, x, curveColor(0)), level = rowOf(picture, x, curveColor(2));
        if (falls >= 0 && level >= 0 && falls >= level - 1)
            crossing = x;
    }
    int first = picture.width, last = 0;
    for (int x = 0; x < picture.width - 14 - 6 * 5 - 8; ++x)
        if (rowOf(picture, x, curveColor(0)) >= 0) {
            first = std::min(first, x);
            last = std::max(last, x);
        }
    EXPECT_NEAR(crossing, (first + last) / 2, 6);
    EXPECT_LT(rowOf(picture, first + 4, curveColor(0)), rowOf(picture, last - 4, curveColor(0))) << "smaller values lie lower";
}

TEST(CurvePicture, LeavesOutWhatHasNoLogarithmAndRefusesToDrawNothing)
{
    CurvePlot plot{.xTicks = {0.0}};
    plot.curves = {{.label = "none", .points = {{0.0, 0.0}}}};
    EXPECT_THROW(curvePicture(plot), InvalidArgument);
    plot.curves[0].points.emplace_back(1.0, 0.5);
    EXPECT_EQ(curvePicture(plot).width, 640);
    plot.width = 100;
    EXPECT_THROW(curvePicture(plot), InvalidArgument);
}

} // namespace
} // namespace mirrorball
