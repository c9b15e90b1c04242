// How a probe's file is to be read, said on the command line and in scenes. What the readers themselves do is in tests/core/image.

#include "core/image/image_io.h"
#include "core/image/map_file.h"
#include "core/image/probe_file.h"
#include "program.h"
#include "support/exr_builders.h"
#include "support/field.h"

#include <algorithm>
#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace mirrorball {
namespace {

using test::mirrorballRuns;
using test::ProgramRun;
using testing::HasSubstr;

constexpr MapLayout latlong{Parameterization::Latlong, 32, 0};

struct ReadingOptionsTest : testing::Test {
    test::TemporaryFolder folder{};

    std::string file(const std::string& name) const { return (folder / name).string(); }
    /// The field, its X exchanged, as a file that was written from outside the sphere.
    std::string mirroredProbe() const
    {
        const EnvironmentMap map = test::fieldMap(latlong);
        Image mirrored = map.image;
        for (int y = 0; y < mirrored.height; ++y)
            for (int x = 0; x < mirrored.width; ++x)
                std::copy_n(map.image.texel(mirrored.width - 1 - x, y), 3, mirrored.texel(x, y));
        writeImage(folder / "mirrored.exr", mirrored);
        return file("mirrored.exr");
    }
    nlohmann::json info(const std::string& words) const
    {
        const ProgramRun run = mirrorballRuns("info " + words + " --json");
        EXPECT_EQ(run.status, 0) << run.err;
        return nlohmann::json::parse(run.out);
    }
    double distanceOf(const std::string& name, const ProbeReading& reading = {}) const
    {
        return test::distanceFromField(readProbe(file(name), {.reading = reading}).map);
    }
};

TEST_F(ReadingOptionsTest, EveryCommandThatTakesAProbeHasThem)
{
    for (const char* command : {"info", "convert", "filter", "report", "render", "doctor", "export"}) {
        const std::string help = mirrorballRuns(std::string(command) + " --help").out;
        for (const char* option : {"--from", "--part", "--layer", "--window", "--color-space", "--fit", "--horizontal-angle",
                                   "--vertical-angle", "--beyond", "--faces", "--mirror", "--rotate"})
            EXPECT_THAT(help, HasSubstr(option)) << command;
    }
}

TEST_F(ReadingOptionsTest, InfoAnswersEveryQuestionAboutEveryKindOfFile)
{
    const std::string source = mirroredProbe();
    ASSERT_EQ(mirrorballRuns("convert " + source + " -o " + file("a.hdr") + " --to latlong --size 16").status, 0);
    ASSERT_EQ(mirrorballRuns("convert " + source + " -o " + file("a.png") + " --to latlong --size 16").status, 0);
    ASSERT_EQ(mirrorballRuns("convert " + source + " -o " + file("a.ktx") + " --to cube --size 16").status, 0);
    ASSERT_EQ(mirrorballRuns("convert " + source + " -o '" + file("f_%s.exr") + "' --to cube --size 16").status, 0);
    ASSERT_EQ(mirrorballRuns("convert " + source + " -o '" + file("p_%s.exr") + "' --to paraboloid --size 16").status, 0);
    for (const char* name : {"mirrored.exr", "a.hdr", "a.png", "a.ktx", "f_%s.exr", "p_%s.exr"}) {
        const nlohmann::json assumed = info("'" + file(name) + "'").at("assumed");
        for (const char* topic : {"part", "layer", "windows", "encoding", "orientation", "parameterization", "handedness", "alpha"}) {
            ASSERT_TRUE(assumed.contains(topic)) << name << " " << topic;
            EXPECT_FALSE(assumed[topic].at("value").get<std::string>().empty()) << name << " " << topic;
            EXPECT_FALSE(assumed[topic].at("why").get<std::string>().empty()) << name << " " << topic;
            EXPECT_THAT(assumed[topic].at("certainty").get<std::string>(), testing::AnyOf("certain", "likely", "guess"));
            EXPECT_TRUE(assumed[topic].at("others").is_array());
        }
    }
    EXPECT_EQ(info(source)["assumed"]["handedness"]["certainty"], "likely");
    EXPECT_EQ(info(source + " --mirror x")["assumed"]["handedness"]["why"], "asked for");
    EXPECT_EQ(info("'" + file("f_%s.exr") + "'")["assumed"]["handedness"]["certainty"], "certain") << "Mirrorball wrote them";
    EXPECT_EQ(info("'" + file("p_%s.exr") + "'")["assumed"]["parameterization"]["value"], "paraboloid");
    EXPECT_EQ(info(file("a.ktx"))["assumed"]["handedness"]["certainty"], "likely") << "engines store mirrored ones";
}

TEST_F(ReadingOptionsTest, ConvertMirrorsTurnsAndYaws)
{
    const std::string source = mirroredProbe();
    const auto convert = [&](const std::string& words) {
        const ProgramRun run = mirrorballRuns("convert " + source + " -o " + file("out.exr") + " --to latlong --size 32 " + words);
        EXPECT_EQ(run.status, 0) << run.err;
    };
    convert("--mirror x");
    EXPECT_LT(distanceOf("out.exr"), 1e-6);
    convert("--mirror x --rotate 90,0,0"); // a turn about Y is what --yaw is
    const Image turned = readImage(folder / "out.exr");
    convert("--mirror x --yaw 90");
    EXPECT_EQ(readImage(folder / "out.exr"), turned);
    EXPECT_GT(distanceOf("out.exr"), 0.5);
    EXPECT_LT(distanceOf("out.exr", {.rotateDeg = {-90.0, 0.0, 0.0}}), 1e-6);
    // Half a turn about the view axis: x and y change their signs.
    convert("--mirror x --rotate 0,0,180");
    const EnvironmentMap upsideDown = readProbe(file("out.exr")).map;
    const glm::dvec3 d = glm::normalize(glm::dvec3(0.3, 0.5, 0.8));
    const glm::vec3 seen = upsideDown.radiance(d);
    const glm::dvec3 wanted = test::fieldAt({-d.x, -d.y, d.z});
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(seen[c], wanted[c], 2e-3); // bilinear between texels of 5.6 degrees
}

TEST_F(ReadingOptionsTest, FilteringReadsAsConvertingDoes)
{
    const std::string source = mirroredProbe();
    const std::string lobe = " --lobe phong --exponent 20 --to latlong --size 16 ";
    ASSERT_EQ(mirrorballRuns("convert " + source + " -o " + file("mended.exr") + " --to latlong --size 32 --mirror x").status, 0);
    ASSERT_EQ(mirrorballRuns("filter " + source + " -o " + file("a.exr") + lobe + "--mirror x --rotate 40,0,0").status, 0);
    ASSERT_EQ(mirrorballRuns("filter " + file("mended.exr") + " -o " + file("b.exr") + lobe + "--yaw 40").status, 0);
    const Image a = readImage(folder / "a.exr"), b = readImage(folder / "b.exr");
    ASSERT_EQ(a.texels.size(), b.texels.size());
    for (size_t i = 0; i < a.texels.size(); ++i)
        ASSERT_NEAR(a.texels[i], b.texels[i], 1e-5);
}

TEST_F(ReadingOptionsTest, ExportsForEnginesReadAProbeAsAskedAndSaySo)
{
    const std::string source = mirroredProbe();
    const auto exported = [&](const std::string& probe, const std::string& words) {
        const ProgramRun run = mirrorballRuns("export " + probe + " --for blender -o " + file("blender") + " --size 32 " + words);
        EXPECT_EQ(run.status, 0) << run.err;
        return nlohmann::json::parse(test::readBytes(folder / "blender/blender.json"));
    };
    const auto latlongOf = [&](const nlohmann::json& described) {
        return readImage(folder / "blender" / described.at("files").at(0).at("file").get<std::string>());
    };
    EXPECT_FALSE(exported(source, "").contains("probe"));
    ASSERT_EQ(mirrorballRuns("convert " + source + " -o " + file("mended.exr") + " --to latlong --size 32 --mirror x").status, 0);
    const Image mended = latlongOf(exported(file("mended.exr"), ""));

    const nlohmann::json described = exported(source, "--mirror x --rotate 360,0,0 --color-space linear");
    EXPECT_EQ(described.at("probe").dump(), R"({"color_space":"linear","mirror":"x","rotate":[360.0,0.0,0.0]})");
    const Image asked = latlongOf(described);
    ASSERT_EQ(asked.texels.size(), mended.texels.size());
    for (size_t i = 0; i < asked.texels.size(); ++i)
        ASSERT_NEAR(asked.texels[i], mended.texels[i], 2e-3);

    EXPECT_FAILS(mirrorballRuns("export " + source + " --for blender -o " + file("none") + " --mirror w"), 2, "--mirror");
    EXPECT_FALSE(std::filesystem::exists(folder / "none"));
}

TEST_F(ReadingOptionsTest, ScenesHaveThemToo)
{
    const std::string source = mirroredProbe();
    const auto write = [&](const std::string& mirror) {
        test::writeBytes(folder / "scene.mirrorball",
                         R"({"version": 1, "probe": {"source": "mirrored.exr", "rotate": [0, 0, 0], "mirror": ")" + mirror +
                             R"("}, "exports": [{"name": "env", "kind": "source", "parameterization": "latlong", "size": 32}]})");
    };
    write("x");
    const ProgramRun run = mirrorballRuns("export " + file("scene.mirrorball") + " -o " + file("out"));
    ASSERT_EQ(run.status, 0) << run.err;
    EXPECT_LT(distanceOf("out/env.exr"), 1e-5);
    const nlohmann::json described = nlohmann::json::parse(test::readBytes(folder / "out/env.json"));
    EXPECT_EQ(described.at("probe").at("mirror"), "x");
    EXPECT_FALSE(described.at("probe").contains("rotate")) << "nothing was turned";
    write("none");
    ASSERT_EQ(mirrorballRuns("export " + file("scene.mirrorball") + " -o " + file("out2")).status, 0);
    EXPECT_GT(distanceOf("out2/env.exr"), 0.5);
    EXPECT_LT(distanceOf("out2/env.exr", {.mirror = MirrorAxis::X}), 1e-5);
    ASSERT_EQ(mirrorballRuns("export " + file("scene.mirrorball") + " -o " + file("out3") + " --mirror x").status, 0);
    EXPECT_EQ(readImage(folder / "out3/env.exr"), readImage(folder / "out/env.exr")) << "options go before the scene's own words";
    write("w");
    EXPECT_FAILS(mirrorballRuns("export " + file("scene.mirrorball") + " -o " + file("out3")), 2, "probe.mirror");
}

TEST_F(ReadingOptionsTest, SixFilesAndTwoHalvesComeBack)
{
    ASSERT_EQ(mirrorballRuns("convert " + mirroredProbe() + " --mirror x -o " + file("field.exr") + " --to cube --size 32").status, 0);
    ASSERT_EQ(mirrorballRuns("convert " + file("field.exr") + " -o '" + file("s_%s.hdr") + "' --to cube --size 32").status, 0);
    EXPECT_LT(distanceOf("s_%s.hdr"), 0.02); // rgbe, and bilinear
    for (const char* extension : {"exr", "tif", "png"}) {
        const std::string name = std::string("h_%s.") + extension;
        const std::string encode = std::string(extension) == "png" ? " --encode srgb" : "";
        ASSERT_EQ(mirrorballRuns("convert " + file("field.exr") + " -o '" + file(name) + "' --to paraboloid --size 64 --border 4" + encode)
                      .status,
                  0);
        EXPECT_TRUE(std::filesystem::exists(folder / (std::string("h_front.") + extension)));
        ASSERT_EQ(mirrorballRuns("convert '" + file(name) + "' -o " + file("back.exr") + " --to latlong --size 32").status, 0) << name;
        EXPECT_LT(distanceOf("back.exr"), 0.03) << name;
    }
    EXPECT_FAILS(mirrorballRuns("info '" + file("none_%s.exr") + "'"), 2, "px nx py ny pz nz");
    EXPECT_FAILS(mirrorballRuns("convert " + file("field.exr") + " -o '" + file("o_%s.exr") + "' --to octahedral --size 32"), 2, "%s");
}

// Beyond an edge of a face lie the texels of its neighbor: those that the same directions have there.
TEST_F(ReadingOptionsTest, ABorderHasTheNeighborsTexels)
{
    ASSERT_EQ(mirrorballRuns("convert " + mirroredProbe() + " --mirror x -o " + file("plain.exr") + " --to cube --size 16").status, 0);
    ASSERT_EQ(mirrorballRuns("convert " + file("plain.exr") + " -o " + file("b.exr") + " --to cube --size 16 --border 2").status, 0);
    const Image plain = readImage(folder / "plain.exr"), bordered = readImage(folder / "b.exr");
    ASSERT_EQ(bordered.width, 20);
    ASSERT_EQ(bordered.height, 120);
    int copied = 0;
    for (int face = 0; face < 6; ++face)
        for (int y = 0; y < 20; ++y)
            for (int x = 0; x < 20; ++x) {
                const float* texel = bordered.texel(x, 20 * face + y);
                const bool acrossX = x < 2 || x >= 18, acrossY = y < 2 || y >= 18;
                if (!acrossX && !acrossY) {
                    ASSERT_TRUE(std::equal(texel, texel + 3, plain.texel(x - 2, 16 * face + y - 2)));
                    continue;
                }
                if (acrossX && acrossY)
                    continue; // no face is there
                // A texel of the plain cube, on another face, no further from this face than the border is wide.
                bool found = false;
                for (int i = 0; i < 6 * 256 && !found; ++i)
                    found = i / 256 != face && std::equal(texel, texel + 3, plain.texels.begin() + 3 * i);
                ASSERT_TRUE(found) << face << " " << x << " " << y;
                ++copied;
            }
    EXPECT_EQ(copied, 6 * 4 * 16 * 2);
    EXPECT_EQ(readProbe(file("b.exr")).map.image, plain) << "read back, the border is cut away";
    EXPECT_FAILS(mirrorballRuns("convert " + file("plain.exr") + " -o " + file("x.exr") + " --to cube --size 16 --border 17"), 2,
                 "--border");
}

// A small output is resampled while the file is read, a large one from memory: the faces' order counts in both.
TEST_F(ReadingOptionsTest, FacesAreInTheOrderThatIsSaidAtEverySize)
{
    const EnvironmentMap cube = test::fieldMap({Parameterization::Cube, 64, 0});
    Image shuffled(64, 384, 3);
    const int order[]{5, 2, 0, 1, 3, 4}; // nz py px nx ny pz
    for (int i = 0; i < 6; ++i)
        std::copy_n(cube.image.row(order[i] * 64), 64 * 64 * 3, shuffled.row(i * 64));
    writeImage(folder / "shuffled.exr", shuffled);
    writeImage(folder / "straight.exr", cube.image);
    for (const std::string size : {"4", "16", "64"}) {
        const auto converted = [&](const std::string& words) {
            const ProgramRun run = mirrorballRuns("convert " + words + " -o " + file("out.exr") + " --to latlong --size " + size);
            EXPECT_EQ(run.status, 0) << run.err;
            return readImage(folder / "out.exr");
        };
        const Image wanted = converted(file("straight.exr")), got = converted(file("shuffled.exr") + " --faces 'nz py px nx ny pz'");
        ASSERT_EQ(got.texels.size(), wanted.texels.size());
        for (size_t i = 0; i < got.texels.size(); ++i)
            ASSERT_NEAR(got.texels[i], wanted.texels[i], 1e-4) << size; // sums of floats in another order; a wrong face is off by 0.2
    }
}

TEST_F(ReadingOptionsTest, FacesAreRefusedWhereAProbeHasNone)
{
    const auto convert = [&](const std::string& probe, const std::string& faces) {
        return mirrorballRuns("convert " + probe + " -o " + file("out.exr") + " --to latlong --size 16 --faces '" + faces + "'");
    };
    for (const std::string& probe : {std::string("builtin:sky"), mirroredProbe()}) {
        EXPECT_FAILS(convert(probe, "upside-down"), 2, "faces: must be px nx py ny pz nz");
        EXPECT_FAILS(convert(probe, "nz py px nx ny pz"), 2, "faces: belongs to cubes whose faces lie on a sheet or in six files");
    }
}

TEST_F(ReadingOptionsTest, PartsAndLayersAreChosen)
{
    std::vector<test::ExrChannel> channels = test::exrChannels(test::fieldMap(latlong).image);
    for (const char* name : {"diffuse.R", "diffuse.G", "diffuse.B", "Z", "N.X", "N.Y", "N.Z"})
        channels.push_back({name, std::vector<float>(64 * 32, 0.25f)});
    test::writeScanlineExr(folder / "layers.exr", test::exrHeader(64, 32, channels, Imf::FLOAT), channels);
    EXPECT_EQ(info(file("layers.exr"))["assumed"]["layer"]["value"], "default");
    EXPECT_THAT(info(file("layers.exr"))["assumed"]["layer"]["others"].dump(), HasSubstr("diffuse"));
    EXPECT_NEAR(info(file("layers.exr") + " --layer diffuse")["mean_radiance"][0].get<double>(), 0.25, 1e-9);
    EXPECT_FAILS(mirrorballRuns("info " + file("layers.exr") + " --layer gone"), 2, "diffuse");
    EXPECT_FAILS(mirrorballRuns("info " + file("layers.exr") + " --part 7"), 2, "part");
    const ProgramRun explained = mirrorballRuns("filter " + file("layers.exr") + " -o " + file("f.exr") +
                                                " --lobe diffuse --to latlong --size 8 --explain --stats " + file("s.json"));
    ASSERT_EQ(explained.status, 0) << explained.err;
    EXPECT_THAT(test::readBytes(folder / "s.json"), HasSubstr("diffuse"));
}

TEST_F(ReadingOptionsTest, OddShapesAreReadWithAWord)
{
    writeImage(folder / "odd.exr", test::fieldPicture(61, 30));
    const ProgramRun odd = mirrorballRuns("convert " + file("odd.exr") + " -o " + file("o.exr") + " --to latlong --size 32");
    EXPECT_EQ(odd.status, 0);
    EXPECT_THAT(odd.err, HasSubstr("almost 2:1"));
    EXPECT_EQ(test::lines(odd.err), 1u);
    writeImage(folder / "part.exr", test::fieldPicture(60, 20, 360.0, 120.0));
    EXPECT_FAILS(mirrorballRuns("info " + file("part.exr")), 2, "--fit pad");
    const ProgramRun part = mirrorballRuns("convert " + file("part.exr") + " -o " + file("p.exr") + " --to latlong --size 30 --fit pad");
    EXPECT_EQ(part.status, 0) << part.err;
    EXPECT_THAT(part.err, HasSubstr("are black"));
    const Image padded = readImage(folder / "p.exr");
    EXPECT_EQ(padded.texel(10, 0)[1], 0.0f);
    EXPECT_EQ(padded.texel(10, 29)[1], 0.0f);
    EXPECT_NEAR(padded.texel(10, 15)[1], test::fieldAt(texelDirection({Parameterization::Latlong, 30, 0}, 10, 15)).y, 1e-5);
    EXPECT_FAILS(mirrorballRuns("info " + file("part.exr") + " --fit wide"), 2, "--fit");
    EXPECT_FAILS(mirrorballRuns("info " + file("part.exr") + " --horizontal-angle nan"), 2, "--horizontal-angle");
    EXPECT_FAILS(mirrorballRuns("info " + file("part.exr") + " --rotate 1,2"), 2, "--rotate");
    EXPECT_FAILS(mirrorballRuns("info " + file("part.exr") + " --color-space muddy"), 2, "muddy");
}

} // namespace
} // namespace mirrorball
