#include "png_picture.h"
#include "program.h"

#include "core/image/image_io.h"
#include "core/image/picture_grid.h"

#include <gtest/gtest.h>

#include <fstream>

namespace mirrorball {
namespace {

using test::mirrorballRuns;
using test::PngPicture;
using test::ProgramRun;
using test::TemporaryFolder;

/// Renders into a folder of its own.
class Variants : public testing::Test {
protected:
    std::string in(const std::string& name) const { return "'" + (folder / name).string() + "'"; }
    ProgramRun render(const std::string& options, const std::string& name) const
    {
        return mirrorballRuns("render --probe builtin:studio --geometry sphere --size 48x32 --map-size 32 " + options + " -o " + in(name));
    }
    PngPicture picture(const std::string& options) const
    {
        const ProgramRun run = render(options, "one.png");
        EXPECT_EQ(run.status, 0) << run.err;
        return PngPicture(folder / "one.png");
    }

    TemporaryFolder folder;
};

TEST_F(Variants, AreThePicturesThatEachSceneGivesAlone)
{
    const ProgramRun run =
        render("--set material.specular.lobe=ggx --grid material.specular.roughness=0.1,0.4,0.8 --grid probe.yaw=0,90", "grid.png");
    ASSERT_EQ(run.status, 0) << run.err;
    EXPECT_EQ(run.err, "");
    const PngPicture grid(folder / "grid.png");
    const PictureGrid layout{
        .columns = {"roughness 0.1", "roughness 0.4", "roughness 0.8"}, .rows = {"yaw 0", "yaw 90"}, .cellWidth = 48, .cellHeight = 32};
    ASSERT_EQ(grid.width, sizeOf(layout).width);
    ASSERT_EQ(grid.height, sizeOf(layout).height);
    // The last cell ends in the lower right corner, the first in its row begins two cells and two equal gaps before.
    const char* const roughness[] = {"0.1", "0.4", "0.8"};
    const char* const yaw[] = {"0", "90"};
    for (int row = 0; row < 2; ++row)
        for (int column = 0; column < 3; ++column) {
            const PngPicture alone = picture(std::string("--roughness ") + roughness[column] + " --yaw " + yaw[row]);
            const int left = grid.width - 48 - (2 - column) * (48 + 4), top = grid.height - 32 - (1 - row) * (32 + 4);
            for (int y = 0; y < 32; ++y)
                for (int x = 0; x < 48; ++x)
                    ASSERT_EQ(grid.at(left + x, top + y), alone.at(x, y)) << row << " " << column << " " << x << " " << y;
        }
}

TEST_F(Variants, TakeVectorsAndValuesWithCommas)
{
    ASSERT_EQ(render("--use multiply --background color --grid 'view.background.color=[1,0,0];[0,0,1]'", "grid.png").status, 0);
    const PngPicture grid(folder / "grid.png");
    const auto red = grid.at(grid.width - 96 - 4 + 1, grid.height - 2), blue = grid.at(grid.width - 48 + 1, grid.height - 2);
    EXPECT_GT(red[0], 200);
    EXPECT_EQ(red[2], 0);
    EXPECT_GT(blue[2], 200);
    EXPECT_EQ(blue[0], 0);
}

TEST_F(Variants, OfRadianceAreFiles)
{
    ASSERT_EQ(render("--grid material.specular.weight=1,2", "grid.exr").status, 0);
    const Image grid = readImage(folder / "grid.exr");
    const float* one = grid.texel(grid.width - 48 - 4 - 24, grid.height - 16);
    const float* two = grid.texel(grid.width - 24, grid.height - 16);
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(two[c], 2.0f * one[c], 2e-3f * two[c]); // halves
}

TEST_F(Variants, AreRefusedInOneLineBeforeAnyWork)
{
    const auto refused = [&](const std::string& options, const std::string& word) {
        EXPECT_FAILS(render(options, "grid.png"), 2, word);
        EXPECT_FALSE(std::filesystem::exists(folder / "grid.png")) << options;
    };
    refused("--grid material.shine=1,2", "--grid material.shine: \"material.shine\": the scene has no such field");
    refused("--grid material.specular.roughness=0.1,2", "--grid material.specular.roughness: must be");
    refused("--grid material.specular.roughness", "--grid: must be FIELD=VALUE,VALUE");
    refused("--grid probe.yaw=1,,2", "--grid probe.yaw: a value is empty");
    refused("--grid probe.yaw=1,2 --grid probe.yaw=3,4", "--grid: probe.yaw is given for columns and rows");
    refused("--grid probe.yaw=1,2 --grid probe.exposure=3,4 --grid view.exposure=1,2", "--grid: given 3 times");
    refused("--grid view.width=16,32", "--size");
    refused("--grid probe.source=builtin:studio,missing.exr", "missing.exr");
    refused("--grid probe.yaw=1,2 --save-scene " + in("s.mirrorball"), "--save-scene");
    std::string many = "0";
    for (int i = 1; i < 17; ++i)
        many += "," + std::to_string(i);
    refused("--grid probe.yaw=" + many + " --grid view.camera.yaw=" + many, "--grid: 289 cells; one picture has at most 256");
    refused("--grid probe.yaw=1,2,3 --set view.width=8000", "at most 16384 along a side");
}

TEST_F(Variants, ThatAllLookTheSameSaySo)
{
    const ProgramRun run = render("--grid material.specular.roughness=0.1,0.9", "grid.png");
    EXPECT_EQ(run.status, 0);
    EXPECT_EQ(test::lines(run.err), 1u) << run.err;
    EXPECT_NE(run.err.find("all pictures are the same"), std::string::npos) << run.err;
}

TEST_F(Variants, OfATurntableAreThePicturesOfTheirAngles)
{
    for (const auto& [turn, field] : {std::pair<std::string, std::string>{"", "view.camera.yaw"}, {"--turn environment", "probe.yaw"}}) {
        const ProgramRun run = render("--roughness 0.3 --set " + field + "=30 --turntable 3 " + turn, "turn.##.png");
        ASSERT_EQ(run.status, 0) << run.err;
        const char* const angles[] = {"30", "150", "270"};
        for (int frame = 1; frame <= 3; ++frame) {
            ASSERT_EQ(render("--roughness 0.3 --set " + field + "=" + angles[frame - 1], "one.png").status, 0);
            EXPECT_EQ(test::readBytes(folder / ("turn.0" + std::to_string(frame) + ".png")), test::readBytes(folder / "one.png"))
                << turn << frame;
        }
        EXPECT_FALSE(std::filesystem::exists(folder / "turn.00.png"));
        EXPECT_FALSE(std::filesystem::exists(folder / "turn.04.png"));
    }
}

TEST_F(Variants, OfATurntableNeedANumberInTheirNames)
{
    EXPECT_FAILS(render("--turntable 4", "turn.png"), 2, "--turntable: every frame would be written to");
    EXPECT_FAILS(render("--turntable 4 --frames 1-4", "turn.####.png"), 2, "--turntable");
    EXPECT_FAILS(render("--turn camera", "turn.####.png"), 2, "--turn: ");
    EXPECT_EQ(render("--turntable 0", "turn.####.png").status, 2);
    EXPECT_EQ(render("--turntable 4 --turn both", "turn.####.png").status, 2);
    for (const auto& entry : std::filesystem::directory_iterator(folder.path()))
        ADD_FAILURE() << entry.path();
}

TEST_F(Variants, SayHowVectorsAreWritten)
{
    const ProgramRun help = mirrorballRuns("render --help");
    EXPECT_NE(help.out.find("[1,0.5,0.2]"), std::string::npos);
}

} // namespace
} // namespace mirrorball
