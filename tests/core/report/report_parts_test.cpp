#include "core/base/error.h"
#include "core/image/image_io.h"
#include "core/report/conclusions.h"
#include "core/report/make_report.h"
#include "core/report/method_comparison.h"
#include "core/report/parameterization_study.h"
#include "core/report/published_paraboloid.h"
#include "support/probe_builders.h"
#include "support/temporary_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace mirrorball {
namespace {

/// Counts pictures; knows what it was handed last, as a graphics card does.
class CountingDrawer : public MapDrawer {
public:
    void draw(const std::shared_ptr<const std::vector<EnvironmentMap>>& levels) override
    {
        ++pictures;
        uploads += levels != m_last;
        m_last = levels;
    }
    std::string description() override { return "a counter"; }

    int pictures = 0, uploads = 0;

private:
    std::shared_ptr<const std::vector<EnvironmentMap>> m_last{};
};

TEST(ReportParts, AreReadFromWordsOnceEachAndInOrder)
{
    EXPECT_THAT(reportPartsFromWords("growth,methods,growth"), testing::ElementsAre(ReportPart::Methods, ReportPart::Growth));
    for (const char* wrong : {"", "methods,", "magic"})
        EXPECT_THROW(reportPartsFromWords(wrong), InvalidArgument) << wrong;
}

TEST(ReportParts, OnlyTheOnesAskedForAreMeasured)
{
    const Report report = makeReport({.lobes = {phongLobe(50)}, .parts = {ReportPart::Distortion}});
    EXPECT_TRUE(report.complete);
    EXPECT_FALSE(report.distortion.empty());
    EXPECT_TRUE(report.cases.empty() && report.growth.empty() && report.parameterizations.empty() && report.stability.empty());
    ASSERT_EQ(report.parts.size(), 1u);
    EXPECT_EQ(report.parts[0].part, ReportPart::Distortion);
    EXPECT_THROW(validate({.lobes = {phongLobe(50)}, .parts = {ReportPart::Kernels}}), InvalidArgument) << "that looks at a probe";
}

TEST(ReportForecast, IsToldBeforeAnythingIsMeasuredAndNamesItsParts)
{
    std::stop_source stop;
    ReportForecast told;
    ReportOptions options{.probes = {"builtin:studio"}, .lobes = {phongLobe(50), diffuseLobe()}, .growthTo = 512};
    options.foretell = [&](const ReportForecast& forecast) {
        told = forecast;
        stop.request_stop();
    };
    const Report report = makeReport(options, {.stop = stop.get_token()});
    EXPECT_FALSE(report.complete);
    EXPECT_TRUE(report.cases.empty());
    ASSERT_EQ(told.parts.size(), 3u);
    for (const ReportForecast::Part& part : told.parts)
        EXPECT_GT(part.seconds, 0.0);
    EXPECT_THAT(describe(told), testing::MatchesRegex("about .* \\(methods .*, parameterizations .*, growth .*\\)"));
    options.foretell = [](const ReportForecast&) { FAIL() << "the probe is missing"; };
    options.probes = {"missing.hdr"};
    EXPECT_THROW(makeReport(options), FileError);
}

TEST(ReportForecast, GrowsWithProbesLobesAndDetailAndFollowsThePace)
{
    const ReportOptions quick = quickReport({.probes = {"builtin:studio"}, .lobes = {phongLobe(50)}});
    const auto seconds = [](const ReportOptions& options, double slowness = 0.5) { return forecastReport(options, {slowness}).seconds(); };
    ReportOptions two = quick, lobes = quick;
    two.probes.push_back("builtin:sky");
    lobes.lobes.push_back(diffuseLobe());
    EXPECT_GT(seconds(two), 1.2 * seconds(quick));
    EXPECT_GT(seconds(lobes), 1.2 * seconds(quick));
    EXPECT_GT(seconds({.probes = {"builtin:studio"}, .lobes = {phongLobe(50)}}), 4.0 * seconds(quick));
    EXPECT_GT(seconds(quick, 1.0), 1.3 * seconds(quick)); // repeats end sooner where they take longer
}

TEST(ReportForecast, IsSaidAsFinelyAsItDeserves)
{
    EXPECT_EQ(durationText(0.34), "0.3 s");
    EXPECT_EQ(durationText(4.26), "4.3 s");
    EXPECT_EQ(durationText(42.4), "42 s");
    EXPECT_EQ(durationText(59.9), "1 min");
    EXPECT_EQ(durationText(128.0), "2 min 10 s");
    EXPECT_EQ(durationText(1500.0), "25 min");
}

/// 000 section 3.2.5 prints sizes and shrink factors; both columns of the table must agree.
TEST(KernelTable, HasThePublishedSizesAndDrawsEveryFrameAnew)
{
    const auto drawer = std::make_shared<CountingDrawer>();
    const KernelTable table = measureKernelTable(FilterSource(test::noiseProbe(32, 2)), {.repeats = 1, .drawer = drawer});
    ASSERT_EQ(table.rows.size(), 5u);
    for (const KernelTableRow& row : table.rows) {
        EXPECT_EQ(row.sizes, row.publishedSizes) << row.exponent;
        EXPECT_GT(row.blendedSeconds, 0.0);
        EXPECT_GT(row.exactSeconds, 0.0);
        EXPECT_GT(row.autoSeconds, 0.0);
        EXPECT_NE(row.autoRan, Method::Auto);
    }
    EXPECT_EQ(drawer->pictures, 5 * 3 * 2);
    EXPECT_EQ(drawer->uploads, drawer->pictures) << "each frame has a map of its own";
    EXPECT_EQ(table.drawnBy, "a counter");
}

/// "The distortion goes up to 25% for large radii"; a circle about the middle of the map has none.
TEST(DistortionCurves, EndWhereThePaperSays)
{
    double largest = 0.0;
    for (const DistortionCurve& curve : distortionCurves()) {
        ASSERT_EQ(curve.distortion.size(), static_cast<size_t>(distortionSteps));
        EXPECT_NEAR(curve.distortion.front(), 0.0, 1e-12);
        // Small circles: tan(t/2) has the slope (1 + d^2)/2 and the curvature of that, d: the middle moves by r d / (1 + d^2).
        if (curve.radius <= 0.1) {
            EXPECT_NEAR(curve.distortion.back(), curve.radius / 2.0, 0.05 * curve.radius);
        }
        for (const double v : curve.distortion)
            largest = std::max(largest, v);
    }
    EXPECT_GT(largest, 0.2);
    EXPECT_LE(largest, 0.26);
}

TEST(MethodComparison, ShowsFourMapsOfWhichTheTreeIsNearestToTheClassicOne)
{
    const MethodComparison comparison = compareMethods(test::noiseProbe(32, 4), {.size = 32, .border = 4});
    ASSERT_EQ(comparison.maps.size(), 4u);
    EXPECT_EQ(comparison.maps[0].label, "unfiltered");
    EXPECT_EQ(comparison.maps[0].seconds, 0.0);
    EXPECT_LE(comparison.maps[2].error.relRms, 1e-2) << "the tolerance of the hierarchical sum";
    EXPECT_GT(comparison.maps[3].error.relRms, comparison.maps[2].error.relRms) << "kernels cut off at a tenth of the lobe's peak";
    const test::TemporaryFolder folder;
    for (const ComparedMap& map : comparison.maps) {
        test::writeBytes(folder / "m.png", map.picture);
        const Image picture = readImage(folder / "m.png");
        EXPECT_EQ(picture.width, 64) << map.label;
        EXPECT_EQ(picture.height, 32) << map.label;
    }
}

TEST(ParameterizationStudy, TimesPicturesOfTheMapsOnceTheyAreHandedOver)
{
    const auto drawer = std::make_shared<CountingDrawer>();
    const ParameterizationStudy study =
        studyParameterizations(FilterSource(test::noiseProbe(32, 2)),
                               {.lobe = phongLobe(10), .texels = 1536, .referenceDirections = 50, .repeats = 3, .drawer = drawer});
    for (const ParameterizationRow& row : study.rows)
        EXPECT_TRUE(row.drawSeconds) << name(row.layout.kind);
    EXPECT_EQ(drawer->uploads, 6);
    EXPECT_EQ(drawer->pictures, 6 * (1 + 3));
}

/// Equal areas are no merit by themselves: the sentence that names them says what they cost.
TEST(Conclusions, SayWhatEvenTexelsAreStretchedAndLose)
{
    Report report;
    ParameterizationRow cube{.layout = {Parameterization::Cube, 64, 0}, .texels = 24576, .mirrorError = 0.01, .filteredError = 0.004};
    cube.densityRatio = 5.2;
    cube.lookupSeconds = 40e-9;
    ParameterizationRow sphere = cube;
    sphere.layout = {Parameterization::Sphere, 157, 0};
    sphere.densityRatio = 1.0;
    sphere.anisotropyP99 = 100.0;
    sphere.filteredError = 0.02;
    sphere.lookupSeconds = 30e-9;
    report.parameterizations.push_back({.lobe = phongLobe(50), .rows = {cube, sphere}});
    const std::vector<std::string> sentences = conclusions(report);
    EXPECT_THAT(sentences, testing::Contains(testing::AllOf(testing::HasSubstr("most even in area in the sphere map"),
                                                            testing::HasSubstr("stretched by 100 to 1"),
                                                            testing::HasSubstr("lose 5 times what those of the cube map do"))));
    EXPECT_THAT(sentences, testing::Contains(testing::AllOf(testing::HasSubstr("least in the cube map (4e-3)"),
                                                            testing::HasSubstr("most in the sphere map (0.02)"))));
    EXPECT_THAT(sentences, testing::Contains(testing::HasSubstr("30 ns in the sphere map to 40 ns in the cube map")));
}

} // namespace
} // namespace mirrorball
