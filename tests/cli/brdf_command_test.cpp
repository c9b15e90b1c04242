#include "program.h"

#include "core/image/image_io.h"
#include "core/report/error_metrics.h"
#include "support/probe_builders.h"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

namespace mirrorball {
namespace {

using test::mirrorballRuns;
using test::ProgramRun;
using test::TemporaryFolder;

std::vector<double> numbers(const std::string& text)
{
    std::istringstream words(text);
    std::vector<double> values;
    for (double value = 0.0; words >> value;)
        values.push_back(value);
    return values;
}

TEST(BrdfCommand, PrintsValuesInDegrees)
{
    const ProgramRun run = mirrorballRuns("brdf ggx:alpha=0.5 --eval 0,0,0,0");
    ASSERT_EQ(run.status, 0) << run.err;
    for (const double value : numbers(run.out)) // D(0)/4 = 1/(4 pi alpha^2)
        EXPECT_NEAR(value, 1.0 / (4.0 * 3.14159265358979 * 0.25), 1e-8);
    const auto mirror = numbers(mirrorballRuns("brdf phong:exponent=50 --eval 60,0,60,180").out);
    EXPECT_NEAR(mirror.at(1), 51.0 / (2.0 * 3.14159265358979) / 0.5, 1e-6);
}

TEST(BrdfCommand, PrintsAlbedos)
{
    const auto rows = numbers(mirrorballRuns("brdf phong:exponent=1 --albedo 3").out);
    ASSERT_EQ(rows.size(), 12u);
    EXPECT_EQ(rows[4], 44.5);
    EXPECT_NEAR(rows[6], 0.5 * (1.0 + std::cos(44.5 * 3.14159265358979 / 180)), 1e-5);
    EXPECT_NEAR(numbers(mirrorballRuns("brdf phong:exponent=1 --view 60").out).at(0), 0.75, 1e-5);
}

TEST(BrdfCommand, WritesTables)
{
    const TemporaryFolder folder;
    const auto write = [&](const std::string& arguments) {
        const ProgramRun run = mirrorballRuns("brdf " + arguments + " -o " + (folder / "t.exr").string());
        EXPECT_EQ(run.status, 0) << run.err;
        return readImage(folder / "t.exr");
    };
    const Image fresnel = write("ggx:alpha=0.3,ior=1.5 --table fresnel --size 3");
    EXPECT_NEAR(fresnel.texel(2, 0)[0], 0.04f, 1e-6);
    EXPECT_NEAR(fresnel.texel(0, 0)[0], 1.0f, 1e-6);
    const Image lookups = write("ggx:alpha=0.3 --table lookups:3 --size 8");
    EXPECT_EQ(lookups.width, 8);
    EXPECT_EQ(lookups.height, 6);
    EXPECT_EQ(write("ggx:alpha=0.3 --table three --size 8").height, 4) << "one along r, one at the normal";
    EXPECT_EQ(write("ggx:alpha=0.3 --table mirror-map --size 32").width, 32);
    EXPECT_GT(write("phong:exponent=20 --table hemisphere:30 --size 33").texel(24, 16)[1], 1.0f) << "opposite of the light";
    // A + B is the albedo of F = 1; rows are roughness, so the second of four is (1.5/4)^2.
    const Image ab = write("ggx:alpha=0.3 --table ab --size 4"), albedo = write("ggx:alpha=0.140625 --table albedo --size 4");
    for (int x = 0; x < 4; ++x)
        EXPECT_NEAR(ab.texel(x, 1)[0] + ab.texel(x, 1)[1], albedo.texel(x, 0)[1], 1e-5);
}

TEST(BrdfCommand, MeasuresWhatLookupsMissByAngleOfView)
{
    const TemporaryFolder folder;
    writeImage(folder / "probe.exr", test::noiseProbe(32, 3).image);
    const std::string csv = (folder / "e.csv").string(), json = (folder / "e.json").string(), png = (folder / "e.png").string();
    const ProgramRun run = mirrorballRuns("brdf ggx:roughness=0.6 --errors " + (folder / "probe.exr").string() +
                                          " --lookups 3,split-sum --views 0,70 -o " + csv + " -o " + json + " -o " + png);
    ASSERT_EQ(run.status, 0) << run.err;
    std::istringstream lines(run.out);
    std::string titles, straight, aslant;
    std::getline(lines, titles);
    std::getline(lines, straight);
    std::getline(lines, aslant);
    EXPECT_EQ(titles, "view  lookups:3  split-sum");
    const auto row = numbers(aslant);
    ASSERT_EQ(row.size(), 3u);
    EXPECT_EQ(row[0], 70.0);
    EXPECT_LT(2.0 * row[1], row[2]);
    for (const std::string& file : {csv, json, png})
        EXPECT_TRUE(std::filesystem::exists(file)) << file;
    EXPECT_EQ(readImage(png).width, 640);
}

TEST(BrdfCommand, RefusesInOneLineAndWritesNothing)
{
    const TemporaryFolder folder;
    const std::string out = " -o " + (folder / "t.exr").string();
    EXPECT_FAILS(mirrorballRuns("brdf ggx:alpha=0.3"), 2, "give one of --eval");
    EXPECT_FAILS(mirrorballRuns("brdf ggx:alpha=7 --albedo 3"), 2, "alpha: must be a number");
    EXPECT_FAILS(mirrorballRuns("brdf ggx:alpha=0.3 --eval 1,2,3"), 2, "--eval: must be four angles");
    EXPECT_FAILS(mirrorballRuns("brdf ggx:alpha=0.3 --table bogus" + out), 2, "choose one of albedo");
    EXPECT_FAILS(mirrorballRuns("brdf phong:exponent=3 --table ab" + out), 2, "choose ggx");
    EXPECT_FAILS(mirrorballRuns("brdf phong:exponent=3 --table hemisphere:90" + out), 2, "below 90");
    EXPECT_FAILS(mirrorballRuns("brdf nowhere.brdf --albedo 3"), 2, "is not there");
    // The file that cannot be written is told first, before the material is so much as opened.
    EXPECT_FAILS(mirrorballRuns("brdf nowhere.brdf --table albedo -o " + (folder / "t.foo").string()), 2, "no image can be written");
    EXPECT_FAILS(mirrorballRuns("brdf nowhere.brdf --table domain:30" + out), 2, "write a .png");
    EXPECT_FAILS(mirrorballRuns("brdf nowhere.brdf --table albedo -o " + (folder / "none/t.exr").string()), 1, "none");
    const std::string errors = "brdf ggx:alpha=0.3 --errors builtin:sky";
    EXPECT_FAILS(mirrorballRuns(errors + out), 2, "must end in .csv");
    EXPECT_FAILS(mirrorballRuns(errors + " --lookups unity"), 2, "'unity' is none");
    EXPECT_FAILS(mirrorballRuns(errors + " --views 0,90"), 2, "below 90");
    EXPECT_FAILS(mirrorballRuns("brdf ggx:alpha=0.002 --errors builtin:sky"), 2, "narrower than a texel");
    EXPECT_FAILS(mirrorballRuns("brdf ggx:alpha=0.3 --albedo 3 --views 3"), 2, "belong to --errors");
    const std::string filter = "filter builtin:sky --to latlong --size 8" + out;
    EXPECT_FAILS(mirrorballRuns(filter + " --brdf ggx:alpha=0.3"), 2, "--view: is missing");
    EXPECT_FAILS(mirrorballRuns(filter + " --brdf ggx:alpha=0.3 --view 90"), 2, "below 90");
    EXPECT_FAILS(mirrorballRuns(filter + " --brdf ggx:alpha=0.3 --view 10 --method lookups:9"), 2, "lookups:K");
    EXPECT_FAILS(mirrorballRuns(filter + " --brdf ggx:alpha=0.3 --view 10 --lobe phong"), 2, "give one of them");
    EXPECT_FALSE(std::filesystem::exists(folder / "t.exr"));
}

TEST(FilterCommand, FiltersByABrdfInEveryWay)
{
    const TemporaryFolder folder;
    writeImage(folder / "probe.exr", test::noiseProbe(32, 3).image);
    const auto filtered = [&](const std::string& method) {
        const ProgramRun run =
            mirrorballRuns("filter " + (folder / "probe.exr").string() + " --brdf ggx:alpha=0.3,ior=1.5 --view 60 " +
                           "--azimuth 40 --to latlong --size 8 --method " + method + " -o " + (folder / "m.exr").string());
        EXPECT_EQ(run.status, 0) << run.err;
        EXPECT_EQ(run.err, "");
        return EnvironmentMap({Parameterization::Latlong, 8, 0}, readImage(folder / "m.exr"));
    };
    const EnvironmentMap truth = filtered("sum");
    const auto error = [&](const std::string& method) { return errorMetrics(filtered(method), truth).relRms; };
    EXPECT_LE(error("stack --tolerance 0.01"), 0.01);
    const double five = error("lookups:5"), engine = error("split-sum");
    EXPECT_LT(five, engine);
    EXPECT_LT(five, error("three"));
    EXPECT_LT(five, error("filament"));
    EXPECT_LT(error("stack:4"), error("round"));
    EXPECT_LT(error("warp:5"), error("warp:40"));
}

} // namespace
} // namespace mirrorball
