#include "png_picture.h"
#include "program.h"

#include "core/image/image_io.h"
#include "core/spheremap/document/presets.h"
#include "core/spheremap/document/sphere_map_file.h"
#include "core/spheremap/evaluation/evaluate.h"

#include <gtest/gtest.h>

#include <array>
#include <fstream>

#include <sys/stat.h>

namespace mirrorball {
namespace {

using test::mirrorballRuns;
using test::PngPicture;
using test::ProgramRun;
using test::TemporaryFolder;

std::string quoted(const std::filesystem::path& path) { return "'" + path.string() + "'"; }

// IEC 61966-2-1: light of 0.2, 0.05, 0.6 is 124, 63, 203 of 255.
TEST(PaintCommand, APngHasTheSameColorsHoweverTransparent)
{
    const TemporaryFolder folder;
    for (const auto& [opacity, alpha] : {std::pair{"1", 255}, {"0.5", 128}, {"0.1", 26}}) {
        std::ofstream(folder / "fill.spheremap")
            << R"({"version": 1, "layers": [{"opacity": )" << opacity << R"(, "content": {"kind": "fill", "color": [0.2, 0.05, 0.6]}}]})";
        ASSERT_EQ(mirrorballRuns("paint " + quoted(folder / "fill.spheremap") + " -o " + quoted(folder / "fill.png") + " --size 8").status,
                  0);
        const PngPicture picture(folder / "fill.png");
        ASSERT_EQ(picture.width, 8);
        for (const auto& pixel : picture.pixels)
            ASSERT_EQ(pixel, (std::array<std::uint8_t, 4>{124, 63, 203, static_cast<std::uint8_t>(alpha)}));
    }
}

// Along an outline a ball of one color keeps that color, as far as 8 bits that were multiplied by the opacity can say.
TEST(RenderCommand, APngWithoutBackgroundKeepsItsColorsAtTheOutline)
{
    const TemporaryFolder folder;
    std::ofstream(folder / "fill.spheremap") << R"({"version": 1, "layers": [{"content": {"kind": "fill", "color": [0.2, 0.05, 0.6]}}]})";
    const ProgramRun run = mirrorballRuns("render --geometry sphere --size 64x64 --background none --sphere-map " +
                                          quoted(folder / "fill.spheremap") + " --tone none -o " + quoted(folder / "ball.png"));
    ASSERT_EQ(run.status, 0) << run.err;
    const PngPicture picture(folder / "ball.png");
    int atTheOutline = 0;
    for (const auto& pixel : picture.pixels)
        if (pixel[3] > 0) {
            atTheOutline += pixel[3] < 255;
            const std::array<int, 3> expected{124, 63, 203};
            for (size_t c = 0; c < 3; ++c)
                ASSERT_NEAR(pixel[c], expected[c], 0.5 + 0.5 * 255.0 / pixel[3]) << int(pixel[3]);
        }
    EXPECT_GT(atTheOutline, 50);
}

TEST(PaintCommand, IsRefusedAPipeAndLeavesNoDocumentWhenItFails)
{
    const TemporaryFolder folder;
    const std::string pipe = (folder / "pipe.spheremap").string();
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    EXPECT_FAILS(mirrorballRuns("paint " + pipe + " -o " + quoted(folder / "a.png") + " --size 8"), 2, "not a regular file");
    std::ofstream(folder / "bad.spheremap") << R"({"version": 1, "layers": [{"content": {"kind": "image", "source": "missing.png"}}]})";
    EXPECT_FAILS(mirrorballRuns("paint " + quoted(folder / "bad.spheremap") + " -o " + quoted(folder / "a.png") +
                                " --size 8 --save-document " + quoted(folder / "saved.spheremap")),
                 2, "missing.png");
    EXPECT_FALSE(std::filesystem::exists(folder / "saved.spheremap"));
}

TEST(PresetsCommand, NamesTheGeometriesThatASheetCanShow)
{
    const TemporaryFolder folder;
    EXPECT_FAILS(mirrorballRuns("presets --sheet " + quoted(folder / "s.png") + " --geometry foo"), 2, "torus");
}

TEST(PaintCommand, PaintsAPresetAsCoreEvaluatesIt)
{
    const TemporaryFolder folder;
    const ProgramRun run = mirrorballRuns("paint cold-warm -o " + quoted(folder / "map.exr") + " --size 64");
    ASSERT_EQ(run.status, 0) << run.err;
    EXPECT_EQ(run.out + run.err, "");
    const Image map = readImage(folder / "map.exr"), expected = evaluate(findSphereMapPreset("cold-warm")->document, {.size = 64});
    ASSERT_EQ(map.width, 64);
    for (int i = 0; i < 64 * 64; ++i)
        for (int c = 0; c < 3; ++c)
            ASSERT_EQ(map.texels[static_cast<size_t>(3 * i + c)], expected.texels[static_cast<size_t>(4 * i + c)]);
}

TEST(PaintCommand, GivesTheSameBytesOnOneAndTwoThreads)
{
    const TemporaryFolder folder;
    for (const char* threads : {"1", "2"})
        ASSERT_EQ(
            mirrorballRuns("paint hatching -o " + quoted(folder / (std::string(threads) + ".exr")) + " --size 100 --threads " + threads)
                .status,
            0);
    EXPECT_EQ(test::readBytes(folder / "1.exr"), test::readBytes(folder / "2.exr"));
}

TEST(PaintCommand, WritesHandMadeLevelsIntoOneFileOrOneFileEach)
{
    const TemporaryFolder folder;
    ASSERT_EQ(mirrorballRuns("paint silhouette -o " + quoted(folder / "s.exr") + " --size 64 --levels").status, 0);
    EXPECT_EQ(openImage(folder / "s.exr")->info().levels, 7);
    // A ring of three pixels is in every level: in that of 16 texels the third texel from the left is still dark.
    EXPECT_LT(readLevel(folder / "s.exr", 2).texel(1, 8)[0], 0.05f);
    EXPECT_GT(readLevel(folder / "s.exr", 2).texel(8, 8)[0], 0.95f);
    ASSERT_EQ(mirrorballRuns("paint silhouette -o " + quoted(folder / "s.png") + " --size 8 --levels").status, 0);
    for (int level = 0; level < 4; ++level)
        EXPECT_EQ(readImage(folder / ("s." + std::to_string(level) + ".png")).width, 8 >> level);
}

// What one file holds and what numbered files hold is the same chain.
TEST(PaintCommand, WritesOneFileALevelOfAnyFormatWhereTheNameAsksForIt)
{
    const TemporaryFolder folder;
    ASSERT_EQ(mirrorballRuns("paint silhouette -o " + quoted(folder / "all.exr") + " --size 16 --levels").status, 0);
    for (const char* extension : {".exr", ".tif"}) {
        ASSERT_EQ(mirrorballRuns("paint silhouette -o " + quoted(folder / "s_%d") + extension + " --size 16 --levels").status, 0);
        for (int level = 0; level < 5; ++level) {
            const std::filesystem::path file = folder / ("s_" + std::to_string(level) + extension);
            EXPECT_EQ(openImage(file)->info().levels, 1) << file;
            EXPECT_EQ(readImage(file).texels, readLevel(folder / "all.exr", level).texels) << file;
        }
    }
    EXPECT_FALSE(std::filesystem::exists(folder / "s_%d.exr"));
    ASSERT_EQ(mirrorballRuns("paint silhouette -o " + quoted(folder / "one_%d.png") + " --size 16").status, 0);
    EXPECT_TRUE(std::filesystem::exists(folder / "one_0.png"));
    EXPECT_FAILS(mirrorballRuns("paint silhouette -o " + quoted(folder / "f_%s.exr") + " --size 16 --levels"), 2,
                 "'%d' for one file a level");
    EXPECT_FALSE(std::filesystem::exists(folder / "f_%s.exr"));
}

TEST(PaintCommand, StartsADocumentFromAPreset)
{
    const TemporaryFolder folder;
    ASSERT_EQ(
        mirrorballRuns("paint toon-hero -o " + quoted(folder / "a.exr") + " --size 32 --save-document " + quoted(folder / "mine.spheremap"))
            .status,
        0);
    ASSERT_EQ(mirrorballRuns("paint " + quoted(folder / "mine.spheremap") + " -o " + quoted(folder / "b.exr") + " --size 32").status, 0);
    EXPECT_EQ(test::readBytes(folder / "a.exr"), test::readBytes(folder / "b.exr"));
}

// Blender reads passes named "diffuse" and "specular"; what they add up to is the map where the specular layers only add light.
TEST(PaintCommand, WritesBlendersTwoPasses)
{
    const TemporaryFolder folder;
    std::ofstream(folder / "d.spheremap") << R"({"version": 1, "layers": [
        {"name": "Matt", "content": {"kind": "gradient"}},
        {"name": "Shine", "blend": "add", "content": {"kind": "phong-lights"}}]})";
    const std::string document = quoted(folder / "d.spheremap");
    ASSERT_EQ(mirrorballRuns("paint " + document + " -o " + quoted(folder / "whole.exr") + " --size 32").status, 0);
    for (const char* half : {"", " --half"}) {
        const ProgramRun run =
            mirrorballRuns("paint " + document + " -o " + quoted(folder / "two.exr") + " --size 32 --specular Shine" + half);
        ASSERT_EQ(run.status, 0) << run.err;
        const auto pass = [&](ImagePass which) {
            SphereMapDocument alone;
            alone.layers = {{.content = ImageLayer{.source = (folder / "two.exr").string(), .pass = which, .inset = 0.0}}};
            return evaluate(alone, {.size = 32});
        };
        const Image diffuse = pass(ImagePass::Diffuse), specular = pass(ImagePass::Specular), whole = readImage(folder / "whole.exr");
        for (int c = 0; c < 3; ++c) { // at a texel's center an image layer reads that texel
            EXPECT_NEAR(diffuse.texel(20, 9)[c] + specular.texel(20, 9)[c], whole.texel(20, 9)[c], 2e-3f);
            EXPECT_NEAR(diffuse.texel(12, 12)[c] + specular.texel(12, 12)[c], whole.texel(12, 12)[c], 2e-3f);
        }
        EXPECT_GT(specular.texel(10, 9)[0], 0.05f);
        EXPECT_LT(specular.texel(24, 24)[0], 1e-3f);
    }
    EXPECT_FAILS(mirrorballRuns("paint " + document + " -o " + quoted(folder / "x.exr") + " --size 8 --specular Gleam"), 2, "Gleam");
    EXPECT_FAILS(mirrorballRuns("paint " + document + " -o " + quoted(folder / "x.png") + " --size 8 --specular Shine"), 2, ".exr");
}

// Blender's lookup, 0.496 n.xy + 0.5, meets the rim of a disc that has two texels around it at 512.
TEST(PaintCommand, PutsTheRimWhereBlenderLooksForIt)
{
    const TemporaryFolder folder;
    const auto ink = [&](const std::string& options) { // of a line of three pixels, along the middle row, within Blender's radius
        EXPECT_EQ(mirrorballRuns("paint silhouette -o " + quoted(folder / "s.exr") + " --size 512" + options).status, 0);
        const Image map = readImage(folder / "s.exr");
        EXPECT_EQ(map.width, 512);
        double sum = 0.0;
        for (int x = 256; x < 256 + 254; ++x)
            sum += 1.0 - map.texel(x, 256)[0];
        return sum;
    };
    EXPECT_LT(ink(""), 1.1);
    EXPECT_NEAR(ink(" --border 2"), 3.0, 0.1);
    EXPECT_FAILS(mirrorballRuns("paint silhouette -o " + quoted(folder / "x.exr") + " --size 8 --border 4"), 2, "--border");
}

TEST(PaintCommand, RefusesBadDocumentsInOneLineAndWritesNothing)
{
    const TemporaryFolder folder;
    const std::string rest = " -o " + quoted(folder / "o.exr") + " --size 8";
    const auto document = [&](const std::string& text) {
        std::ofstream(folder / "d.spheremap") << text;
        return "paint " + quoted(folder / "d.spheremap") + rest;
    };
    EXPECT_FAILS(mirrorballRuns("paint mona-lisa" + rest), 2, "cold-warm");
    EXPECT_FAILS(mirrorballRuns("paint " + quoted(folder / "missing.spheremap") + rest), 2, "missing.spheremap");
    EXPECT_FAILS(mirrorballRuns(document("{\"version\": 1, \"layers\": [{\"content\": {\"kind\": \"plasma\"}}]}")), 2, "plasma");
    EXPECT_FAILS(mirrorballRuns(document("{\"version\": 1, \"layers\": [{\"opacity\": NaN}]}")), 2, "line 1");
    EXPECT_FAILS(mirrorballRuns(document("{\"version\": 1, \"layers\": [{\"content\": {\"kind\": \"image\", \"source\": \"gone.exr\"}}]}")),
                 2, "gone.exr");
    EXPECT_FAILS(mirrorballRuns("paint jade -o " + quoted(folder / "o.exr") + " --size 99999"), 2, "size");
    EXPECT_FALSE(std::filesystem::exists(folder / "o.exr"));
}

TEST(PaintCommand, PresetsListTheSphereMapsAndShowThemOnASheet)
{
    const std::string list = mirrorballRuns("presets").out;
    for (const SphereMapPreset& preset : sphereMapPresets())
        EXPECT_NE(list.find(preset.name + "\tsphere-map\t" + preset.description + "\n"), std::string::npos) << preset.name;
    EXPECT_GE(sphereMapPresets().size(), 20u);
    const TemporaryFolder folder;
    ASSERT_EQ(mirrorballRuns("presets --sheet " + quoted(folder / "sheet.png") + " --size 16").status, 0);
    const Image sheet = readImage(folder / "sheet.png");
    EXPECT_GE(static_cast<size_t>(sheet.width / 16 * (sheet.height / 16)), sphereMapPresets().size());
}

// On the sheet's first cell and in the first file stands the same ball.
TEST(PaintCommand, ThumbnailsAreTheCellsOfTheSheet)
{
    const TemporaryFolder folder;
    ASSERT_EQ(mirrorballRuns("presets --sheet " + quoted(folder / "sheet.png") + " --size 16").status, 0);
    ASSERT_EQ(mirrorballRuns("presets --thumbnails " + quoted(folder / "new" / "balls") + " --size 16").status, 0);
    const Image sheet = readImage(folder / "sheet.png");
    const Image first = readImage(folder / "new" / "balls" / (sphereMapPresets().front().name + ".png"));
    ASSERT_EQ(first.width, 16);
    ASSERT_EQ(first.height, 16);
    for (int y = 0; y < 16; ++y)
        EXPECT_TRUE(std::equal(first.row(y), first.row(y) + 3 * 16, sheet.row(y))) << y;
    for (const auto presets : {sphereMapPresets(), windowViewPresets()})
        for (const SphereMapPreset& preset : presets)
            EXPECT_TRUE(std::filesystem::exists(folder / "new" / "balls" / (preset.name + ".png"))) << preset.name;
}

} // namespace
} // namespace mirrorball
