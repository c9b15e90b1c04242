#include "core/report/make_report.h"
#include "core/report/report_files.h"

#include "core/base/error.h"
#include "core/image/image_io.h"
#include "core/report/cost_growth.h"
#include "core/report/error_time.h"
#include "core/report/html_page.h"
#include "core/report/parameterization_study.h"
#include "core/report/thumbnails.h"
#include "support/probe_builders.h"
#include "support/temporary_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace mirrorball {
namespace {

const MapLayout cube8{Parameterization::Cube, 8, 0};

ErrorTimeOptions smallOptions() { return {.target = cube8, .sweep = Sweep::Few, .repeats = 2, .longest = 60.0, .directions = 10000}; }

const Measurement* find(const ReportCase& c, Method method, double tolerance = -1.0)
{
    for (const Measurement& m : c.measurements)
        if (m.setting.method == method && (tolerance < 0.0 || m.setting.tolerance == tolerance))
            return &m;
    return nullptr;
}

TEST(ErrorTime, MeasuresEveryMethodOrSaysWhyNot)
{
    const FilterSource probe(test::noiseProbe(32, 5));
    const ReportCase c = measureCase(probe, "noise.exr", phongLobe(20), smallOptions());
    EXPECT_TRUE(c.referenceComplete);
    for (const Method method : allMethods) {
        const Measurement* m = find(c, method);
        ASSERT_TRUE(m) << name(method);
        EXPECT_TRUE(m->state == MeasurementState::Measured || !m->why.empty()) << name(method);
    }
    const Measurement* spectral = find(c, Method::Spectral, 1e-5);
    ASSERT_TRUE(spectral);
    EXPECT_EQ(spectral->state, MeasurementState::Measured);
    EXPECT_LE(spectral->error.relRms, 1e-5);
    EXPECT_EQ(spectral->times.seconds.size(), 2u);
    EXPECT_EQ(spectral->nextLobe.seconds.size(), 2u);
    EXPECT_NEAR(spectral->energy, 1.0, 0.01);   // the map's 384 texels sample its own mean
    EXPECT_EQ(spectral->seamRatios.size(), 2u); // 8 and 4 texels
    EXPECT_EQ(std::count_if(c.measurements.begin(), c.measurements.end(),
                            [](const Measurement& m) { return m.setting.method == Method::Spectral && !m.errorPicture.empty(); }),
              1);
    EXPECT_LE(c.standInError, 1e-5);
    const Measurement* reference = find(c, Method::Reference);
    EXPECT_FALSE(reference->scaled);
    EXPECT_EQ(reference->error.relRms, 0.0);
    EXPECT_NE(find(c, Method::Auto)->ran, Method::Auto);
}

TEST(ErrorTime, AStopKeepsWhatWasMeasured)
{
    const FilterSource probe(test::noiseProbe(32, 5));
    std::stop_source stop;
    int steps = 0;
    const JobControl job{.stop = stop.get_token(), .progress = [&](float) {
                             if (++steps == 3) // the reference and two settings
                                 stop.request_stop();
                         }};
    ErrorTimeOptions options = smallOptions();
    options.methods = {Method::Spectral, Method::Direct, Method::Auto};
    const ReportCase c = measureCase(probe, "noise.exr", phongLobe(20), options, job);
    ASSERT_EQ(c.measurements.size(), 6u);
    for (size_t i = 0; i < 6; ++i)
        EXPECT_EQ(c.measurements[i].state, i < 2 ? MeasurementState::Measured : MeasurementState::LeftOut) << i;
    EXPECT_THAT(c.measurements[5].why, testing::HasSubstr("stopped"));
}

TEST(ErrorTime, LeavesOutWhatWouldTakeTooLong)
{
    const FilterSource probe(test::noiseProbe(64, 5));
    ErrorTimeOptions options = smallOptions();
    options.methods = {Method::Direct};
    options.longest = 1e-9;
    options.directions = 16;
    const ReportCase c = measureCase(probe, "noise.exr", phongLobe(2), options);
    for (const Measurement& m : c.measurements) {
        EXPECT_EQ(m.state, MeasurementState::LeftOut);
        EXPECT_THAT(m.why, testing::HasSubstr("predicted to take"));
    }
}

TEST(ParameterizationStudy, FindsNoErrorInAConstantAndTheKnownDensities)
{
    const FilterSource probe(test::constantProbe(32, 0.5f));
    const ParameterizationStudy study = studyParameterizations(probe, {.lobe = phongLobe(10), .texels = 1536, .referenceDirections = 50});
    ASSERT_EQ(study.rows.size(), allParameterizations.size());
    for (const ParameterizationRow& row : study.rows) {
        EXPECT_NEAR(row.texels, 1536.0, 0.06 * 1536) << name(row.layout.kind);
        EXPECT_LE(row.mirrorError, 1e-6) << name(row.layout.kind);
        EXPECT_LE(row.filteredError, 2e-6) << name(row.layout.kind);
    }
    const auto row = [&](Parameterization kind) -> const ParameterizationRow& { return study.rows[static_cast<size_t>(kind)]; };
    for (const ParameterizationRow& r : study.rows) {
        EXPECT_GT(r.lookupSeconds, 0.0);
        EXPECT_FALSE(r.drawSeconds) << "nobody draws";
    }
    // A sphere map is stretched by 1 / cos^2(t/2) = 2 / (1 + cos t) at the angle t from its middle: by 2 on the half of the sphere that is
    // nearer than 90 degrees, by 100 on all but the hundredth of it with 1 + cos t below 0.02, as far as texels resolve that.
    EXPECT_NEAR(row(Parameterization::Sphere).anisotropyMedian, 2.0, 0.05);
    EXPECT_GT(row(Parameterization::Sphere).anisotropyP99, 50.0); // a hundredth is a dozen texels of 39 x 39
    EXPECT_LT(row(Parameterization::Sphere).anisotropyP99, 200.0);
    EXPECT_NEAR(row(Parameterization::Paraboloid).anisotropyP99, 1.0, 1e-4) << "circles stay circles";
    EXPECT_NEAR(row(Parameterization::Sphere).densityRatio, 1.0, 1e-9); // equal areas
    // 000 section 3.1: outer pixels of a paraboloid cover a quarter of a central one's solid angle.
    const auto& paraboloid = row(Parameterization::Paraboloid).solidAngle;
    EXPECT_NEAR(paraboloid[0] / paraboloid[90], 4.0, 0.01);
    // A cube face's d omega / dA goes with cos^3 of the angle: 2 sqrt 2 from its center to the middle of an edge.
    const auto& cube = row(Parameterization::Cube).solidAngle;
    EXPECT_NEAR(cube[0] / cube[45], 2.0 * std::sqrt(2.0), 0.05);
}

TEST(CostGrowth, HasAPointForEveryMethodExponentAndWidth)
{
    const FilterSource probe(test::noiseProbe(32, 1));
    const auto points = measureGrowth(probe, {.methods = {Method::Reference, Method::Auto, Method::Spectral},
                                              .lobe = phongLobe(20),
                                              .target = cube8,
                                              .tolerance = 1e-2,
                                              .largestWidth = 512,
                                              .repeats = 1,
                                              .longest = 5.0});
    int widths = 0, exponents = 0;
    for (const GrowthPoint& p : points) {
        EXPECT_NE(p.method, Method::Reference);
        (p.axis == GrowthAxis::ProbeWidth ? widths : exponents) += 1;
        EXPECT_EQ(p.state, MeasurementState::Measured) << p.why;
        EXPECT_GT(p.times.median(), 0.0);
    }
    EXPECT_EQ(widths, 2 * 2);
    EXPECT_EQ(exponents, 2 * 7);
}

TEST(Thumbnails, DataUrisAreThoseOfRfc4648)
{
    const std::pair<const char*, const char*> vectors[] = {
        {"", ""}, {"f", "Zg=="}, {"fo", "Zm8="}, {"foo", "Zm9v"}, {"foobar", "Zm9vYmFy"}};
    for (const auto& [bytes, text] : vectors)
        EXPECT_EQ(dataUri(bytes), "data:image/png;base64," + std::string(text));
}

TEST(Thumbnails, TheSignedErrorIsRedWhereTooBrightAndBlueWhereTooDark)
{
    const EnvironmentMap reference = test::constantProbe(32, 1.0f);
    EnvironmentMap map = reference;
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 64; ++x)
            for (int c = 0; c < 3; ++c)
                map.image.texel(x, y)[c] += x < 32 ? 0.009f : -0.009f;
    const ErrorPicture picture = errorPicture(map, reference, {Parameterization::Latlong, 32, 0});
    EXPECT_NEAR(picture.limit, 0.01, 1e-12); // 0.009 rounded up to 1, 2 or 5
    const test::TemporaryFolder folder;
    test::writeBytes(folder / "e.png", picture.png);
    const Image image = readImage(folder / "e.png");
    EXPECT_GT(image.texel(16, 16)[0], 2.0f * image.texel(16, 16)[2]);
    EXPECT_GT(image.texel(48, 16)[2], 2.0f * image.texel(48, 16)[0]);
}

/// A report with awkward words in it.
Report smallReport()
{
    Report report{.version = "0", .command = "mirrorball report </script><script>alert(1)</script>", .threads = 1, .target = cube8};
    report.probes = {{.name = "a, \"b\".hdr"}};
    ReportCase& c = report.cases.emplace_back();
    c.lobe = phongLobe(50);
    c.measurements.resize(2);
    Measurement &good = c.measurements[0], &refused = c.measurements[1];
    good.setting.method = good.ran = Method::Spectral;
    good.setting.label = "tolerance 1e-3";
    good.times.seconds = {0.5, 0.25};
    good.seamRatios = {1.0, HUGE_VAL};
    refused.setting.method = Method::Sh9;
    refused.state = MeasurementState::Refused;
    refused.why = "only diffuse";
    return report;
}

TEST(ReportFiles, JsonHoldsWhatWasMeasured)
{
    const nlohmann::json json = nlohmann::json::parse(reportJson(smallReport(), Pictures::LeftOut));
    const auto& m = json.at("cases").at(0).at("measurements").at(0);
    EXPECT_EQ(m.at("seconds").at("median"), 0.375);
    EXPECT_EQ(m.at("method"), "spectral");
    EXPECT_TRUE(m.at("seam_ratios").at(1).is_null()); // infinite
    EXPECT_TRUE(m.at("peak_bytes").is_null());
    EXPECT_EQ(json.at("cases").at(0).at("measurements").at(1).at("why"), "only diffuse");
}

TEST(ReportFiles, CsvHasAsManyCellsInEveryRow)
{
    const std::string csv = measurementsCsv(smallReport());
    std::vector<int> cells;
    int count = 1;
    bool inQuotes = false;
    for (const char c : csv) {
        inQuotes = inQuotes != (c == '"');
        if (c == ',' && !inQuotes)
            ++count;
        if (c == '\n' && !inQuotes) {
            cells.push_back(count);
            count = 1;
        }
    }
    ASSERT_EQ(cells.size(), 3u);
    EXPECT_EQ(cells[1], cells[0]);
    EXPECT_EQ(cells[2], cells[0]);
    EXPECT_THAT(csv, testing::HasSubstr("\"a, \"\"b\"\".hdr\",phong:50,spectral,tolerance 1e-3,measured,"));
}

TEST(HtmlPage, HoldsEverythingAndAsksForNothing)
{
    const std::string page = htmlPage(reportJson(smallReport(), Pictures::Embedded));
    EXPECT_THAT(page, testing::HasSubstr("default-src 'none'"));
    EXPECT_THAT(page, testing::HasSubstr("Chart.js v3"));
    EXPECT_THAT(page, testing::HasSubstr("The MIT License"));
    for (const char* asks : {"src=\"http", "href=\"http", "@import", "<link", "sourceMappingURL", "@REPORT@", "@SCRIPT@", "@STYLE@"})
        EXPECT_THAT(page, testing::Not(testing::HasSubstr(asks)));
    EXPECT_THAT(page, testing::Not(testing::HasSubstr("<script>alert"))); // what a user typed stays text
}

TEST(MakeReport, StopsBetweenProbesAndSaysSo)
{
    std::stop_source stop;
    stop.request_stop();
    const Report report = makeReport({.probes = {"builtin:studio"}, .lobes = {phongLobe(50)}}, {.stop = stop.get_token()});
    EXPECT_FALSE(report.complete);
    EXPECT_TRUE(report.cases.empty());
    EXPECT_FALSE(htmlPage(reportJson(report, Pictures::Embedded)).empty());
}

TEST(MakeReport, RefusesNumbersOutOfRangeByName)
{
    const ReportOptions good{.probes = {"builtin:studio"}, .lobes = {phongLobe(50)}};
    EXPECT_NO_THROW(validate(good));
    const auto refuses = [&](auto change, const char* field) {
        ReportOptions options = good;
        change(options);
        try {
            validate(options);
            FAIL() << field;
        } catch (const InvalidArgument& error) {
            EXPECT_THAT(error.what(), testing::StartsWith(field));
        }
    };
    refuses([](ReportOptions& o) { o.repeats = 0; }, "repeats:");
    refuses([](ReportOptions& o) { o.growthTo = 100; }, "growth-to:");
    refuses([](ReportOptions& o) { o.growthTo = 32768; }, "growth-to:");
    refuses([](ReportOptions& o) { o.tolerance = 0.0; }, "tolerance:");
    refuses([](ReportOptions& o) { o.longest = std::nan(""); }, "longest:");
    refuses([](ReportOptions& o) { o.lobes.clear(); }, "lobes:");
    refuses([](ReportOptions& o) { o.probes.clear(); }, "PROBE:");
}

} // namespace
} // namespace mirrorball
