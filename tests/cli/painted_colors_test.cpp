#include "png_picture.h"
#include "program.h"

#include "core/image/image.h"
#include "support/picture_builders.h"

#include <gtest/gtest.h>

#include <fstream>

namespace mirrorball {
namespace {

using test::mirrorballRuns;
using test::PngPicture;
using test::ProgramRun;
using test::TemporaryFolder;

constexpr std::array<int, 3> orange{237, 153, 97};

/// A folder with a picture of an orange ball, as any painting program writes it.
class PaintedColors : public testing::Test {
protected:
    PaintedColors()
    {
        Image ball(32, 32, 3);
        for (int i = 0; i < 32 * 32; ++i)
            for (int c = 0; c < 3; ++c)
                ball.texels[static_cast<size_t>(3 * i + c)] = static_cast<float>(orange[static_cast<size_t>(c)]) / 255.0f;
        test::writePng(folder / "orange.png", ball, 8);
    }
    std::string in(const std::string& name) const { return "'" + (folder / name).string() + "'"; }
    PngPicture rendered(const std::string& options) const
    {
        const ProgramRun run = mirrorballRuns("render --geometry sphere --size 64x64 " + options + " -o " + in("ball.png"));
        EXPECT_EQ(run.status, 0) << run.err;
        return PngPicture(folder / "ball.png");
    }
    std::string bytes(const std::string& options) const
    {
        rendered(options);
        return test::readBytes(folder / "ball.png");
    }

    TemporaryFolder folder;
};

TEST_F(PaintedColors, AreTheColorsOfTheModelWhereTheMapReplacesTheMaterial)
{
    std::ofstream(folder / "linked.mirrorball")
        << R"({"version": 1, "material": {"sphere_map": {"source": "orange.png"}}, "view": {"background": {"kind": "none"}}})";
    const PngPicture picture = rendered(in("linked.mirrorball"));
    int inside = 0;
    for (const auto& pixel : picture.pixels)
        if (pixel[3] == 255) {
            ++inside;
            for (size_t c = 0; c < 3; ++c)
                ASSERT_NEAR(pixel[c], orange[c], 1);
        }
    EXPECT_GT(inside, 500);
}

// What stands behind keeps the curve that it has without a map.
TEST_F(PaintedColors, AreNoMatterOfTheBackground)
{
    const std::string corner = "--camera 0,0,6 --background color --set 'view.background.color=[0.6, 0.3, 2]'";
    const PngPicture painted = rendered(corner + " --sphere-map " + in("orange.png")), plain = rendered(corner);
    EXPECT_EQ(painted.at(1, 1), plain.at(1, 1));
    EXPECT_NE(painted.at(32, 32), plain.at(32, 32));
}

TEST_F(PaintedColors, OfASceneThatNamesItsCurveStay)
{
    for (const std::string tone : {"none", "reinhard", "filmic"}) {
        std::ofstream(folder / "says.mirrorball")
            << R"({"version": 1, "material": {"sphere_map": {"source": "orange.png"}}, "view": {"tone": ")" << tone << "\"}}";
        std::ofstream(folder / "silent.mirrorball") << R"({"version": 1, "material": {"sphere_map": {"source": "orange.png"}}})";
        EXPECT_EQ(bytes(in("says.mirrorball")), bytes(in("silent.mirrorball") + " --tone " + tone)) << tone;
        const auto pixel = PngPicture(folder / "ball.png").at(32, 32);
        EXPECT_EQ(pixel[0] == orange[0] && pixel[1] == orange[1], tone == "none") << tone;
    }
}

TEST_F(PaintedColors, LeaveEveryOtherSceneAsItWas)
{
    for (const std::string scene :
         {"--probe builtin:studio", "--probe builtin:sky --use over --sphere-map ", "--probe builtin:sky --use multiply --sphere-map "}) {
        const std::string options = scene + (scene.ends_with(' ') ? in("orange.png") : "");
        EXPECT_EQ(bytes(options), bytes(options + " --tone filmic")) << options;
    }
}

} // namespace
} // namespace mirrorball
