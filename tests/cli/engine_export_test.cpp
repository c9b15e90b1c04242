#include "program.h"

#include "core/image/container/container_file.h"
#include "core/image/map_file.h"
#include "core/image/probe_file.h"
#include "support/temporary_folder.h"

#include <gmock/gmock.h>

#include <png.h>

namespace mirrorball {
namespace {

using test::mirrorballRuns;
using test::TemporaryFolder;
using testing::HasSubstr;

std::string in(const TemporaryFolder& folder, const std::string& name) { return (folder / name).string(); }

TEST(EngineExportCommand, NamesTheFilesAfterTheFolderAndPrintsThem)
{
    const TemporaryFolder folder;
    const auto run = mirrorballRuns("export --probe builtin:axes --for filament --size 64 -o " + in(folder, "night"));
    ASSERT_EQ(run.status, 0) << run.err;
    for (const std::string file : {"night_ibl.ktx", "night_skybox.ktx", "night_sh.txt", "night_filament.js", "night.json"}) {
        EXPECT_TRUE(std::filesystem::exists(folder / "night" / file)) << file;
        EXPECT_THAT(run.out, HasSubstr(file));
    }
}

TEST(EngineExportCommand, ASceneAndItsProbeGiveTheSameBytes)
{
    const TemporaryFolder folder;
    test::writeBytes(folder / "s.mirrorball", R"({"version": 1, "probe": {"source": "builtin:axes"}})");
    ASSERT_EQ(mirrorballRuns("export " + in(folder, "s.mirrorball") + " --for three --size 32 --name l -o " + in(folder, "a")).status, 0);
    ASSERT_EQ(mirrorballRuns("export builtin:axes --for three --size 32 --name l -o " + in(folder, "b")).status, 0);
    for (const auto& entry : std::filesystem::directory_iterator(folder / "a"))
        EXPECT_EQ(test::readBytes(entry.path()), test::readBytes(folder / "b" / entry.path().filename())) << entry.path();
}

TEST(EngineExportCommand, RefusesInOneLineBeforeAnyWork)
{
    const TemporaryFolder folder;
    const std::string out = " -o " + in(folder, "out");
    EXPECT_FAILS(mirrorballRuns("export --probe builtin:axes --for quake" + out), 2, "three");
    EXPECT_FAILS(mirrorballRuns("export --probe builtin:axes --for filament --size 100" + out), 2, "--size");
    EXPECT_FAILS(mirrorballRuns("export --probe builtin:axes --for babylon --size 8192" + out), 2, "power of two");
    EXPECT_FAILS(mirrorballRuns("export --probe builtin:axes --for three -o '" + in(folder, "light_%s") + "'"), 2, "%");
    EXPECT_FAILS(mirrorballRuns("export --probe missing.hdr --for three" + out), 2, "missing.hdr");
    EXPECT_FAILS(mirrorballRuns("export --probe builtin:axes --for three --encode rgbm" + out), 2, "--encode");
    EXPECT_FAILS(mirrorballRuns("export --for three" + out), 2, "SCENE");
    EXPECT_FAILS(mirrorballRuns("convert builtin:axes --to cube --size 16 -o '" + in(folder, "m_%s.exr") + "' --for godot"), 2, "Godot");
    EXPECT_FAILS(mirrorballRuns("filter builtin:axes --lobe diffuse --to cube --size 16 -o '" + in(folder, "m_%s.ktx2") + "'"), 2,
                 "the six faces in one");
    EXPECT_FAILS(mirrorballRuns("filter builtin:axes --law godot --to cube --size 16 -o " + in(folder, "m.ktx2")), 2, "Godot");
    EXPECT_FAILS(mirrorballRuns("filter builtin:axes --law filament --levels 9 --to cube --size 16 -o " + in(folder, "m.ktx2")), 2,
                 "--levels");
    EXPECT_FAILS(mirrorballRuns("filter builtin:axes --levels 3 --lobe ggx --roughness 1 --to cube --size 16 -o " + in(folder, "m.exr")), 2,
                 "--law");
    EXPECT_FAILS(mirrorballRuns("convert builtin:axes --to latlong --size 16 --encode rgbm -o " + in(folder, "m.exr")), 2, "--encode");
    EXPECT_FAILS(mirrorballRuns("convert builtin:axes --to latlong --size 16 --encode rgbm -o " + in(folder, "m.jpg")), 2, ".png");
    EXPECT_FALSE(std::filesystem::exists(folder / "out"));
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(ContainerCommand, AChainByLawGoesIntoOneFileAndIsReadAgain)
{
    const TemporaryFolder folder;
    for (const std::string extension : {"ktx", "ktx2", "dds"}) {
        const std::string file = in(folder, "chain." + extension);
        const auto run = mirrorballRuns("filter builtin:axes --law filament --levels 3 --to cube --size 32 --half -o " + file);
        ASSERT_EQ(run.status, 0) << run.err;
        const Texture texture = readContainer(std::filesystem::path(file)).texture;
        ASSERT_EQ(texture.levels.size(), 3u);
        EXPECT_EQ(texture.format, TexelFormat::Half);
        const auto info = mirrorballRuns("info " + file + " --json");
        EXPECT_EQ(info.status, 0);
        EXPECT_THAT(info.out, HasSubstr("cube"));
    }
    const auto exr = mirrorballRuns("filter builtin:axes --lobe ggx --alpha 1 --to cube --size 8 -o " + in(folder, "last.exr"));
    ASSERT_EQ(exr.status, 0) << exr.err;
    const Image last = readContainer(folder / "chain.ktx2").texture.levels[2], exact = readImage(folder / "last.exr");
    for (size_t i = 0; i < exact.texels.size(); ++i)
        EXPECT_NEAR(last.texels[i], exact.texels[i], 1e-3) << "the last level is fully rough";
}

TEST(ContainerCommand, ConvertForAnEngineMirrorsItsCubesAndTurnsItsLatlongs)
{
    const TemporaryFolder folder;
    ASSERT_EQ(mirrorballRuns("convert builtin:axes --for three --to cube --size 64 -o '" + in(folder, "m_%s.exr") + "'").status, 0);
    ASSERT_EQ(mirrorballRuns("convert builtin:axes --to cube --size 64 -o '" + in(folder, "o_%s.exr") + "'").status, 0);
    const Image stored = readImage(folder / "m_px.exr"), ours = readImage(folder / "o_nx.exr");
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x)
            EXPECT_EQ(stored.texel(x, y)[1], ours.texel(63 - x, y)[1]) << "+X shows our -X, mirrored";
    ASSERT_EQ(mirrorballRuns("convert builtin:axes --for blender --to latlong --size 64 -o " + in(folder, "a.exr")).status, 0);
    ASSERT_EQ(mirrorballRuns("convert builtin:axes --yaw -90 --to latlong --size 64 -o " + in(folder, "b.exr")).status, 0);
    EXPECT_EQ(readImage(folder / "a.exr"), readImage(folder / "b.exr"));
}

TEST(ContainerCommand, ParaboloidHalvesBecomeTheSlicesOfADdsArray)
{
    const TemporaryFolder folder;
    ASSERT_EQ(mirrorballRuns("convert builtin:axes --to paraboloid --size 32 -o " + in(folder, "dual.dds")).status, 0);
    ASSERT_EQ(mirrorballRuns("convert builtin:axes --to paraboloid --size 32 -o " + in(folder, "dual.exr")).status, 0);
    const Texture texture = readContainer(folder / "dual.dds").texture;
    EXPECT_EQ(texture.slices, 2);
    EXPECT_EQ(texture.faces, 1);
    const Probe probe = readProbe(in(folder, "dual.dds"));
    EXPECT_EQ(probe.map.layout.kind, Parameterization::Paraboloid);
    EXPECT_EQ(probe.map.image, readImage(folder / "dual.exr"));
}

/// A picture as libpng reads it: straight bytes.
std::vector<unsigned char> pngBytes(const std::filesystem::path& path, png_uint_32 format)
{
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    if (png_image_begin_read_from_file(&image, path.c_str()) == 0)
        return {};
    image.format = format;
    std::vector<unsigned char> bytes(PNG_IMAGE_SIZE(image));
    png_image_finish_read(&image, nullptr, bytes.data(), 0, nullptr);
    return bytes;
}

TEST(EncodeOption, SrgbIsPlainAndWithoutItThePictureIsToneMappedAsBefore)
{
    const TemporaryFolder folder;
    ASSERT_EQ(mirrorballRuns("convert builtin:axes --to cube --size 32 --encode srgb -o " + in(folder, "s.png")).status, 0);
    ASSERT_EQ(mirrorballRuns("convert builtin:axes --to cube --size 32 --encode filmic -o " + in(folder, "f.png")).status, 0);
    ASSERT_EQ(mirrorballRuns("convert builtin:axes --to cube --size 32 -o " + in(folder, "d.png")).status, 0);
    ASSERT_EQ(mirrorballRuns("convert builtin:axes --to cube --size 32 -o " + in(folder, "l.exr")).status, 0);
    EXPECT_EQ(test::readBytes(folder / "f.png"), test::readBytes(folder / "d.png"));
    const std::vector<unsigned char> bytes = pngBytes(folder / "s.png", PNG_FORMAT_RGB);
    const Image linear = readImage(folder / "l.exr");
    ASSERT_EQ(bytes.size(), linear.texels.size());
    for (size_t i = 0; i < bytes.size(); ++i) {
        const double x = std::clamp<double>(linear.texels[i], 0.0, 1.0); // IEC 61966-2-1
        EXPECT_NEAR(bytes[i], 255.0 * (x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1.0 / 2.4) - 0.055), 0.51);
    }
}

TEST(EncodeOption, PackedRadianceComesBackByTheEnginesDecoders)
{
    const TemporaryFolder folder;
    ASSERT_EQ(mirrorballRuns("convert builtin:axes --to cube --size 32 -o " + in(folder, "l.exr")).status, 0);
    const Image linear = readImage(folder / "l.exr");
    // Straight from the engines' shaders: decodeRGBM, decodeRGBP (PlayCanvas), fromRGBD (Babylon.js), Ward's RGBE.
    const auto decoded = [](const std::string& form, double c, double a) {
        if (form == "rgbm")
            return std::pow(8.0 * a * c, 2.0);
        if (form == "rgbp")
            return std::pow(c * (-a * 7.0 + 8.0), 2.0);
        if (form == "rgbd")
            return std::pow(c, 2.2) / a;
        return a == 0.0 ? 0.0 : 255.0 * c * std::exp2(255.0 * a - 136.0);
    };
    for (const std::string form : {"rgbm", "rgbp", "rgbd", "rgbe"}) {
        const std::filesystem::path file = folder / (form + ".png");
        const auto run = mirrorballRuns("convert builtin:axes --to cube --size 32 --encode " + form + " -o " + file.string());
        ASSERT_EQ(run.status, 0) << run.err;
        const std::vector<unsigned char> bytes = pngBytes(file, PNG_FORMAT_RGBA);
        ASSERT_EQ(bytes.size(), linear.texels.size() / 3 * 4);
        for (size_t i = 0; i < linear.texels.size(); ++i)
            EXPECT_NEAR(decoded(form, bytes[i / 3 * 4 + i % 3] / 255.0, bytes[i / 3 * 4 + 3] / 255.0), linear.texels[i], 0.01) << form;
    }
}

} // namespace
} // namespace mirrorball
