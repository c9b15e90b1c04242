#include "program.h"

#include "core/filter/prefilter.h"
#include "core/filter/reference.h"
#include "core/image/builtin_probes.h"
#include "core/image/daylight.h"
#include "core/image/image_io.h"
#include "core/report/error_metrics.h"
#include "support/probe_builders.h"
#include "support/shared_data.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
#include <sstream>

namespace mirrorball {
namespace {

using test::mirrorballRuns;
using test::ProgramRun;
using test::TemporaryFolder;

std::string quoted(const std::filesystem::path& path) { return "'" + path.string() + "'"; }

nlohmann::json parsed(const std::filesystem::path& path) { return nlohmann::json::parse(test::readBytes(path)); }

size_t filesIn(const TemporaryFolder& folder)
{
    return static_cast<size_t>(std::distance(std::filesystem::directory_iterator(folder.path()), std::filesystem::directory_iterator{}));
}

TEST(CommandLine, FiltersAProbeAsTheReferenceSays)
{
    const TemporaryFolder folder;
    const EnvironmentMap probe = test::noiseProbe(32, 3);
    writeImage(folder / "probe.exr", probe.image);
    const ProgramRun run = mirrorballRuns("filter " + quoted(folder / "probe.exr") + " -o " + quoted(folder / "out.exr") +
                                          " --lobe phong --exponent 20 --to cube --size 16 --stats " + quoted(folder / "stats.json"));
    ASSERT_EQ(run.status, 0) << run.err;
    EXPECT_EQ(run.out, "");
    EXPECT_EQ(run.err, "");
    const MapLayout cube{Parameterization::Cube, 16, 0};
    FilterSource source(probe);
    const EnvironmentMap reference = prefilter(source, {.lobe = phongLobe(20), .target = cube, .method = Method::Reference}).map;
    EXPECT_LE(errorMetrics({cube, readImage(folder / "out.exr")}, reference).relRms, 1e-5);

    const nlohmann::json stats = parsed(folder / "stats.json");
    EXPECT_EQ(stats.at("threads").get<int>() > 0, true);
    EXPECT_GT(stats.at("peak_bytes").get<double>(), 1e6);
    EXPECT_LE(stats.at("predicted_error").get<double>(), 1e-5);
    EXPECT_TRUE(stats.at("band_limit").is_number_integer());
    EXPECT_TRUE(stats.at("method").is_string());
    bool reads = false, saves = false;
    for (const auto& stage : stats.at("stages")) {
        EXPECT_TRUE(stage.at("seconds").is_number() && stage.at("left_out").is_boolean() && stage.at("why").is_string());
        reads = reads || stage.at("name").get<std::string>().find("read") != std::string::npos;
        saves = saves || stage.at("name").get<std::string>().find("save") != std::string::npos;
    }
    EXPECT_TRUE(reads && saves);
}

TEST(CommandLine, NamesTheCommandsWhenItDoesNotKnowOne)
{
    const ProgramRun run = mirrorballRuns("fliter builtin:sky");
    EXPECT_EQ(run.status, 2);
    EXPECT_EQ(run.err.find("mirrorball: 'fliter' is no command; choose one of info, convert, filter, "), 0u) << run.err;
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1);
}

TEST(CommandLine, ReachesEveryMethodAndItsKnobs)
{
    const TemporaryFolder folder;
    const EnvironmentMap probe = test::noiseProbe(32, 3);
    writeImage(folder / "probe.exr", probe.image);
    struct Call {
        const char *options, *method;
        double error; // of white noise, coarsely approximated by some
    };
    for (const Call& call : {Call{"--lobe phong --exponent 20 --method reference", "reference", 1e-6},
                             Call{"--lobe phong --exponent 20 --method direct", "direct", 1e-6},
                             Call{"--lobe phong --exponent 20 --method hierarchical --tolerance 1e-3", "hierarchical", 1e-3},
                             Call{"--lobe phong --exponent 20 --method importance --samples 4096", "importance", 0.05},
                             Call{"--lobe phong --exponent 20 --method mip", "mip", 0.5},
                             Call{"--lobe phong --exponent 20 --method mip --lambda 2.5", "mip", 0.5},
                             Call{"--lobe phong --exponent 20 --method mip --mip-filtering per-face", "mip", 0.5},
                             Call{"--lobe diffuse --method sh9", "sh9", 0.05}}) {
        const ProgramRun run = mirrorballRuns("filter " + quoted(folder / "probe.exr") + " -o " + quoted(folder / "out.exr") +
                                              " --to cube --size 8 " + call.options + " --stats " + quoted(folder / "stats.json"));
        ASSERT_EQ(run.status, 0) << run.err;
        EXPECT_EQ(parsed(folder / "stats.json").at("method").get<std::string>(), call.method);
        const MapLayout cube{Parameterization::Cube, 8, 0};
        FilterSource source(probe);
        const Lobe lobe = std::string_view(call.method) == "sh9" ? diffuseLobe() : phongLobe(20);
        const EnvironmentMap reference = prefilter(source, {.lobe = lobe, .target = cube, .method = Method::Reference}).map;
        EXPECT_LE(errorMetrics({cube, readImage(folder / "out.exr")}, reference).relRms, call.error) << call.options;
    }
}

// Nine coefficients of one hot texel are negative on the far side of it.
TEST(CommandLine, SaysWhereAMapHasNegativeLight)
{
    const TemporaryFolder folder;
    const auto run = [&](float sun, const std::string& method) {
        Image image(64, 32, 3, 1.0f);
        std::fill_n(image.texel(20, 10), 3, sun);
        writeImage(folder / "probe.exr", image);
        const ProgramRun made =
            mirrorballRuns("filter " + quoted(folder / "probe.exr") + " -o " + quoted(folder / "out.exr") +
                           " --to cube --size 8 --lobe diffuse --method " + method + " --stats " + quoted(folder / "stats.json"));
        EXPECT_EQ(made.status, 0) << made.err;
        return made.err;
    };
    const std::string said = run(1e6f, "sh9");
    const Image map = readImage(folder / "out.exr");
    const float least = *std::min_element(map.texels.begin(), map.texels.end());
    ASSERT_LT(least, 0.0f);
    std::ostringstream number;
    number.precision(3);
    number << "negative light, down to " << least;
    EXPECT_NE(said.find(number.str()), std::string::npos) << said;
    EXPECT_EQ(test::lines(said), 1u) << said;
    EXPECT_NE(parsed(folder / "stats.json").at("not_promised").at(0).get<std::string>().find(number.str()), std::string::npos);
    EXPECT_EQ(run(1.0f, "sh9").find("negative light"), std::string::npos);
    EXPECT_EQ(run(1e6f, "auto"), "");
    EXPECT_TRUE(parsed(folder / "stats.json").at("not_promised").empty());
}

TEST(CommandLine, GivesTheSameBytesOnOneAndTwoThreads)
{
    const TemporaryFolder folder;
    for (const char* threads : {"1", "2"})
        ASSERT_EQ(mirrorballRuns("filter builtin:sky -o " + quoted(folder / (std::string(threads) + ".exr")) +
                                 " --lobe ggx --roughness 0.5 --to octahedral --size 32 --threads " + threads)
                      .status,
                  0);
    EXPECT_EQ(test::readBytes(folder / "1.exr"), test::readBytes(folder / "2.exr"));
}

TEST(CommandLine, FiltersADiffuseMapOfAConstantToTheConstant)
{
    const TemporaryFolder folder;
    writeImage(folder / "white.exr", Image(64, 32, 3, 1.0f));
    for (const char* kind : {"latlong", "cube", "sphere", "angular", "paraboloid", "octahedral"}) {
        ASSERT_EQ(mirrorballRuns("filter " + quoted(folder / "white.exr") + " -o " + quoted(folder / "out.exr") +
                                 " --lobe diffuse --size 16 --to " + kind)
                      .status,
                  0);
        for (const float value : readImage(folder / "out.exr").texels)
            ASSERT_NEAR(value, 1.0f, 1e-6f) << kind;
    }
}

TEST(CommandLine, ExplainsAPlanAsATable)
{
    const TemporaryFolder folder;
    const ProgramRun run =
        mirrorballRuns("render --probe builtin:studio --geometry sphere --size 32x24 --lambda 2 --lambda-grazing 1 --explain -o " +
                       quoted(folder / "o.png"));
    ASSERT_EQ(run.status, 0) << run.err;
    std::istringstream lines(run.out);
    std::string head;
    std::getline(lines, head);
    EXPECT_EQ(head.find("stage"), 0u);
    const size_t time = head.find("time") + 4, memory = head.find("memory") + 6, why = head.find("why");
    ASSERT_NE(why, std::string::npos);
    int rows = 0, withTime = 0;
    for (std::string line; std::getline(lines, line); ++rows) {
        ASSERT_GT(line.size(), why) << line;
        EXPECT_EQ(line.substr(why - 2, 2), "  ") << line;
        EXPECT_NE(line[why], ' ') << line;
        EXPECT_TRUE(line.find("needed") != std::string::npos || line.find("left out") != std::string::npos) << line;
        EXPECT_TRUE(line[time - 1] == ' ' || line.substr(time - 2, 2) == "ms" || line.substr(time - 2, 2) == " s") << line;
        EXPECT_TRUE(line[memory - 1] == ' ' || line[memory - 1] == 'B' || line[memory - 1] == 's') << line;
        withTime += line[time - 1] == 's';
    }
    EXPECT_GT(rows, 6);
    EXPECT_GT(withTime, 2);
    EXPECT_NE(run.out.find("lambda by angle"), std::string::npos);
}

// The tests' environment has no display: the GPU's method starts its own context.
TEST(CommandLine, FiltersByParaboloidWithoutADisplay)
{
    const TemporaryFolder folder;
    const std::string filter = "filter builtin:studio --lobe phong --exponent 30 --to cube --size 16 -o ";
    ASSERT_EQ(mirrorballRuns(filter + quoted(folder / "auto.exr")).status, 0);
    ASSERT_EQ(mirrorballRuns(filter + quoted(folder / "exact.exr") + " --method paraboloid --stats " + quoted(folder / "s.json")).status,
              0);
    ASSERT_EQ(mirrorballRuns(filter + quoted(folder / "published.exr") + " --method paraboloid --paraboloid blended --paraboloid-border 64")
                  .status,
              0);
    const MapLayout cube{Parameterization::Cube, 16, 0};
    const EnvironmentMap reference(cube, readImage(folder / "auto.exr"));
    const nlohmann::json stats = nlohmann::json::parse(test::readBytes(folder / "s.json"));
    EXPECT_EQ(stats.at("method"), "paraboloid");
    EXPECT_LT(errorMetrics({cube, readImage(folder / "exact.exr")}, reference).relRms, stats.at("predicted_error").get<double>());
    const double published = errorMetrics({cube, readImage(folder / "published.exr")}, reference).relRms;
    EXPECT_GT(published, 0.01);
    EXPECT_LT(published, 0.3);
}

TEST(CommandLine, AGgxChainKeepsItsLevelsInOneFile)
{
    const TemporaryFolder folder;
    ASSERT_EQ(mirrorballRuns("filter builtin:studio -o " + quoted(folder / "chain.exr") + " --lobe ggx --to cube --size 32 --mips").status,
              0);
    EXPECT_EQ(filesIn(folder), 1u);
    const auto info = openImage(folder / "chain.exr")->info();
    EXPECT_GE(info.levels, 6);
    // The last level of the cube is fully rough: alpha = 1 is the cosine lobe.
    const EnvironmentMap studio = renderBuiltinProbe("studio");
    const MapLayout one{Parameterization::Cube, 1, 0};
    const Image level = readLevel(folder / "chain.exr", 5);
    ASSERT_EQ(level.width, 1);
    ASSERT_EQ(level.height, 6);
    FilterSource source(studio);
    const EnvironmentMap diffuse = prefilter(source, {.lobe = diffuseLobe(), .target = one, .method = Method::Reference}).map;
    EXPECT_LE(errorMetrics({one, level}, diffuse).relRms, 2e-5);
}

TEST(CommandLine, WritesOneFileALevelWhereTheFormatHoldsNone)
{
    const TemporaryFolder folder;
    ASSERT_EQ(mirrorballRuns("convert builtin:axes -o " + quoted(folder / "m.hdr") + " --to octahedral --size 8 --mips").status, 0);
    for (int level = 0; level < 4; ++level)
        EXPECT_EQ(readImage(folder / ("m." + std::to_string(level) + ".hdr")).width, 8 >> level);
    EXPECT_EQ(filesIn(folder), 4u);
}

TEST(CommandLine, WritesSixFacesForAPercentS)
{
    const TemporaryFolder folder;
    ASSERT_EQ(mirrorballRuns("convert builtin:axes -o " + quoted(folder / "face_%s.exr") + " --to cube --size 32").status, 0);
    ASSERT_EQ(mirrorballRuns("convert builtin:axes -o " + quoted(folder / "all.exr") + " --to cube --size 32").status, 0);
    const Image all = readImage(folder / "all.exr");
    const char* names[] = {"px", "nx", "py", "ny", "pz", "nz"};
    for (int f = 0; f < 6; ++f) {
        const Image one = readImage(folder / ("face_" + std::string(names[f]) + ".exr"));
        ASSERT_EQ(one.width, 32);
        EXPECT_TRUE(std::equal(one.texels.begin(), one.texels.end(), all.row(32 * f))) << names[f];
    }
    EXPECT_FAILS(mirrorballRuns("convert builtin:axes -o " + quoted(folder / "face_%s.exr") + " --to latlong --size 32"), 2, "%s");
}

TEST(CommandLine, ConvertsThereAndBack)
{
    const TemporaryFolder folder;
    ASSERT_EQ(
        mirrorballRuns("filter builtin:studio -o " + quoted(folder / "latlong.exr") + " --lobe phong --exponent 30 --to latlong --size 128")
            .status,
        0);
    const MapLayout layout{Parameterization::Latlong, 128, 0};
    const EnvironmentMap start(layout, readImage(folder / "latlong.exr"));
    for (const char* kind : {"cube", "sphere", "angular", "paraboloid", "octahedral"}) {
        const std::string there = quoted(folder / (std::string(kind) + ".exr"));
        ASSERT_EQ(mirrorballRuns("convert " + quoted(folder / "latlong.exr") + " -o " + there + " --size 256 --to " + kind).status, 0);
        // No --from: the file says what it is.
        ASSERT_EQ(mirrorballRuns("convert " + there + " -o " + quoted(folder / "back.exr") + " --to latlong --size 128").status, 0);
        // The lobe is 0.43 wide at half maximum, 17 texels: two bilinear resamplings cost little, a mirrored or turned map all.
        EXPECT_LT(errorMetrics({layout, readImage(folder / "back.exr")}, start).relRms, 0.01) << kind;
    }
}

TEST(CommandLine, TellsWhatAProbeHolds)
{
    const TemporaryFolder folder;
    Image image(64, 32, 3, 0.5f);
    image.texel(10, 10)[0] = std::numeric_limits<float>::quiet_NaN();
    image.texel(11, 12)[1] = std::numeric_limits<float>::infinity();
    image.texel(12, 12)[2] = -0.25f;
    writeImage(folder / "p.exr", image);
    const ProgramRun run = mirrorballRuns("info --json " + quoted(folder / "p.exr"));
    ASSERT_EQ(run.status, 0) << run.err;
    const auto json = nlohmann::json::parse(run.out);
    EXPECT_EQ(json.at("width"), 64);
    EXPECT_EQ(json.at("parameterization"), "latlong");
    EXPECT_EQ(json.at("nan"), 1);
    EXPECT_EQ(json.at("inf"), 1);
    EXPECT_EQ(json.at("negative"), 1);
    const auto sun = nlohmann::json::parse(mirrorballRuns("info --json builtin:sky").out);
    const glm::dvec3 direction(sun.at("brightest_direction")[0], sun.at("brightest_direction")[1], sun.at("brightest_direction")[2]);
    EXPECT_GT(glm::dot(direction, skySunDirection()), 0.999);
    EXPECT_GT(sun.at("sun_share").get<double>(), 0.3);
}

TEST(CommandLine, ExplainsWhatItDoesAndLeavesOut)
{
    const TemporaryFolder folder;
    const ProgramRun run =
        mirrorballRuns("filter builtin:sky -o " + quoted(folder / "o.exr") + " --lobe phong --exponent 1e9 --to cube --size 8 --explain");
    ASSERT_EQ(run.status, 0) << run.err;
    EXPECT_NE(run.out.find("left out"), std::string::npos);
    EXPECT_NE(run.out.find("bilinear"), std::string::npos);
}

TEST(CommandLine, ListsPresetsALineEach)
{
    const ProgramRun run = mirrorballRuns("presets");
    ASSERT_EQ(run.status, 0);
    for (const char* probe : {"studio", "sky", "cube-room", "axes"})
        EXPECT_NE(run.out.find("builtin:" + std::string(probe) + "\tprobe\t"), std::string::npos);
    const auto json = nlohmann::json::parse(mirrorballRuns("presets --json").out);
    EXPECT_EQ(json.size(), test::lines(run.out));
}

TEST(CommandLine, RendersSphereMapsAndNamesTheOneThatIsMissing)
{
    const TemporaryFolder folder;
    const std::string out = " --size 32x32 -o " + (folder / "a.png").string();
    EXPECT_EQ(mirrorballRuns("render --sphere-map silhouette --use multiply --set material.sphere_map.size=64" + out).status, 0);
    EXPECT_EQ(mirrorballRuns("render --sphere-map silhouette --geometry window --set material.sphere_map.size=64" + out).status, 0);
    EXPECT_FAILS(mirrorballRuns("render --sphere-map silouette" + out), 2, "material.sphere_map.source: \"silouette\" is neither a preset");
    EXPECT_FAILS(mirrorballRuns("render --sphere-map none.spheremap" + out), 2, "none.spheremap");
    EXPECT_FAILS(mirrorballRuns("render --geometry window" + out), 2, "material.sphere_map.source: a window shows");
    EXPECT_FAILS(mirrorballRuns("render --set view.display.config=none.ocio" + out), 2, "view.display.config: ");
}

TEST(CommandLine, RendersAMeshFileAndSavesASceneThatFindsItAgain)
{
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder / "meshes");
    test::writeBytes(folder / "meshes/t.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    const std::string size = " --size 32x32 ";
    const auto run =
        mirrorballRuns("render --geometry " + (folder / "meshes/t.obj").string() + size + "-o " + (folder / "a.png").string() +
                       " --shading normals --set view.background.kind=none --save-scene " + (folder / "s.mirrorball").string());
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_EQ(mirrorballRuns("render " + (folder / "s.mirrorball").string() + " -o " + (folder / "b.png").string()).status, 0);
    EXPECT_EQ(test::readBytes(folder / "a.png"), test::readBytes(folder / "b.png"));
    EXPECT_FAILS(mirrorballRuns("render --geometry teapott -o " + (folder / "c.png").string()), 2, "--geometry: 'teapott' is neither");
    EXPECT_FAILS(mirrorballRuns("render --geometry nothing.obj -o " + (folder / "c.png").string()), 2, "nothing.obj: does not exist");
    EXPECT_FALSE(std::filesystem::exists(folder / "c.png"));
}

TEST(CommandLine, RefusesBadArgumentsInOneLine)
{
    const TemporaryFolder folder;
    const std::string out = quoted(folder / "o.exr");
    const std::string filter = "filter builtin:studio -o " + out + " --to cube --size 8 ";
    EXPECT_FAILS(mirrorballRuns(""), 2, "subcommand");
    EXPECT_FAILS(mirrorballRuns("paint-it-black"), 2, "mirrorball");
    EXPECT_FAILS(mirrorballRuns("filter builtin:nowhere -o " + out + " --lobe diffuse --to cube --size 8"), 2, "studio");
    EXPECT_FAILS(mirrorballRuns(filter + "--lobe velvet"), 2, "--lobe");
    EXPECT_FAILS(mirrorballRuns(filter + "--lobe phong"), 2, "--exponent");
    EXPECT_FAILS(mirrorballRuns(filter + "--lobe phong --exponent -1"), 2, "--exponent");
    EXPECT_FAILS(mirrorballRuns(filter + "--lobe phong --exponent nan"), 2, "--exponent");
    EXPECT_FAILS(mirrorballRuns(filter + "--lobe phong --exponent 5 --alpha 0.1"), 2, "--alpha");
    EXPECT_FAILS(mirrorballRuns(filter + "--lobe ggx --roughness 1.5"), 2, "--roughness");
    EXPECT_FAILS(mirrorballRuns(filter + "--lobe ggx"), 2, "--roughness");
    EXPECT_FAILS(mirrorballRuns(filter + "--lobe diffuse --method magic"), 2, "--method");
    EXPECT_FAILS(mirrorballRuns(filter + "--lobe diffuse --tolerance 0"), 2, "--tolerance");
    EXPECT_FAILS(mirrorballRuns(filter + "--lobe diffuse --samples 16"), 2, "--samples");
    EXPECT_FAILS(mirrorballRuns(filter + "--lobe diffuse --method importance --samples 0"), 2, "samples");
    EXPECT_FAILS(mirrorballRuns(filter + "--lobe diffuse --method importance --lambda 2"), 2, "--lambda");
    EXPECT_FAILS(mirrorballRuns(filter + "--lobe diffuse --method mip --lambda -1"), 2, "lambda");
    EXPECT_FAILS(mirrorballRuns(filter + "--lobe diffuse --method mip --mip-filtering sideways"), 2, "--mip-filtering");
    EXPECT_FAILS(mirrorballRuns(filter + "--lobe phong --exponent 20 --method sh9"), 2, "sh9");
    EXPECT_FAILS(mirrorballRuns(filter + "--lobe diffuse --paraboloid-kernel 9"), 2, "--paraboloid-kernel");
    const std::string paraboloid = filter + "--lobe phong --exponent 50 --method paraboloid ";
    EXPECT_FAILS(mirrorballRuns(paraboloid + "--paraboloid round"), 2, "blended or exact");
    EXPECT_FAILS(mirrorballRuns(paraboloid + "--paraboloid-kernel 9.5"), 2, "whole number");
    EXPECT_FAILS(mirrorballRuns(paraboloid + "--paraboloid-kernel 2"), 2, "paraboloid_kernel");
    EXPECT_FAILS(mirrorballRuns(paraboloid + "--paraboloid-clamp much"), 2, "--paraboloid-clamp");
    EXPECT_FAILS(mirrorballRuns(paraboloid + "--paraboloid-half 5000"), 2, "--paraboloid-half");
    EXPECT_FAILS(mirrorballRuns(filter + "--lobe phong --exponent 20000 --method paraboloid --paraboloid-kernel 255"), 2, "use direct");
    EXPECT_FAILS(mirrorballRuns(filter + "--lobe diffuse --threads -3"), 2, "--threads");
    EXPECT_FAILS(mirrorballRuns("convert builtin:studio -o " + out + " --to ball --size 8"), 2, "--to");
    EXPECT_FAILS(mirrorballRuns("convert builtin:studio -o " + out + " --to cube --size 0"), 2, "size");
    EXPECT_FAILS(mirrorballRuns("convert builtin:studio -o " + out + " --to cube --size 99999999"), 2, "size");
    EXPECT_FAILS(mirrorballRuns("convert builtin:studio -o " + out + " --to cube --size eight"), 2, "--size");
    EXPECT_FAILS(mirrorballRuns("convert builtin:studio -o " + quoted(folder / "o.xyz") + " --to cube --size 8"), 2, "xyz");
    EXPECT_EQ(filesIn(folder), 0u); // nothing half written
}

TEST(CommandLine, RefusesBadFilesInOneLine)
{
    const TemporaryFolder folder;
    const std::string rest = " -o " + quoted(folder / "o.exr") + " --lobe diffuse --to cube --size 8";
    EXPECT_FAILS(mirrorballRuns("filter " + quoted(folder / "missing.exr") + rest), 2, "missing.exr");
    std::ofstream(folder / "empty.hdr").flush();
    EXPECT_FAILS(mirrorballRuns("filter " + quoted(folder / "empty.hdr") + rest), 2, "empty.hdr");
    std::ofstream(folder / "text.exr") << "this is no picture, but it is long enough to look at";
    EXPECT_FAILS(mirrorballRuns("filter " + quoted(folder / "text.exr") + rest), 2, "text.exr");
    std::ofstream(folder / "huge.hdr") << "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1000000 +X 2000000\n";
    EXPECT_FAILS(mirrorballRuns("filter " + quoted(folder / "huge.hdr") + rest), 2, "huge.hdr");
    writeImage(folder / "odd.exr", Image(31, 17));
    EXPECT_FAILS(mirrorballRuns("filter " + quoted(folder / "odd.exr") + rest), 2, "odd.exr");
    EXPECT_FALSE(std::filesystem::exists(folder / "o.exr"));
}

TEST(CommandLine, FailsWithOneWhenTheOutputCannotBeWritten)
{
    EXPECT_FAILS(mirrorballRuns("convert builtin:axes -o /nonexistent/folder/o.exr --to cube --size 8"), 1, "/nonexistent/folder");
}

TEST(CommandLine, KeepsAnExistingFileWhenTheWorkFails)
{
    const TemporaryFolder folder;
    std::ofstream(folder / "o.exr") << "precious";
    EXPECT_EQ(
        mirrorballRuns("convert " + quoted(folder / "missing.exr") + " -o " + quoted(folder / "o.exr") + " --to cube --size 8").status, 2);
    EXPECT_EQ(test::readBytes(folder / "o.exr"), "precious");
}

/// 16384 x 8192 texels would be 1.6 GB as floats; truncated row by row they are some 60 MB.
TEST(CommandLine, StreamsAProbeOf16kInLittleMemory)
{
    const TemporaryFolder folder;
    {
        // Flat RGBE: every row the same, 16384 texels of one value, with one bright row. Run-length coded it is a small file.
        std::ofstream file(folder / "16k.hdr", std::ios::binary);
        file << "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 8192 +X 16384\n";
        for (int y = 0; y < 8192; ++y) {
            std::string row{'\2', '\2', '\x40', '\0'};
            for (int c = 0; c < 4; ++c)
                for (int left = 16384; left > 0; left -= 127) {
                    row += static_cast<char>(128 + std::min(left, 127));
                    row += static_cast<char>(c == 3 ? (y == 3000 ? 136 : 128) : 128);
                }
            file << row;
        }
    }
    const ProgramRun run = mirrorballRuns("filter " + quoted(folder / "16k.hdr") + " -o " + quoted(folder / "o.exr") +
                                          " --lobe phong --exponent 50 --to latlong --size 16 --stats " + quoted(folder / "s.json"));
    ASSERT_EQ(run.status, 0) << run.err;
    const auto stats = parsed(folder / "s.json");
    EXPECT_LT(stats.at("peak_bytes").get<double>(), 1024.0 * 1024 * 1024);
    // Closed form: 0.5 everywhere, and a thin ring of 128 at colatitude t0 whose share follows from k summed around it.
    const double t0 = pi * 3000.5 / 8192, ring = 2.0 * std::sin(t0) * std::sin(0.5 * pi / 8192), n = 50.0;
    const Image map = readImage(folder / "o.exr");
    for (int y = 0; y < 16; ++y) {
        const double t = pi * (y + 0.5) / 16;
        double around = 0.0;
        for (int i = 0; i < 3600; ++i) {
            const double c = std::cos(t) * std::cos(t0) + std::sin(t) * std::sin(t0) * std::cos(2.0 * pi * (i + 0.5) / 3600);
            around += std::pow(std::max(c, 0.0), n) * 2.0 * pi / 3600;
        }
        const double expected = 0.5 + (128.0 - 0.5) * ring * around * (n + 1.0) / (2.0 * pi);
        EXPECT_NEAR(map.texel(5, y)[1] / expected, 1.0, 1e-5) << y;
    }
}

} // namespace
} // namespace mirrorball
