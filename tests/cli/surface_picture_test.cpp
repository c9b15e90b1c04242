#include "png_picture.h"
#include "program.h"

#include "core/image/image_io.h"
#include "support/picture_builders.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

namespace mirrorball {
namespace {

using test::mirrorballRuns;
using test::PngPicture;
using test::ProgramRun;

constexpr int edge = 32;

/// Pictures on a square that fills what is rendered, in white light and without a tone curve: a diffuse surface shows its own color.
class SurfacePicture : public testing::Test {
protected:
    SurfacePicture()
    {
        writeImage(folder / "white.exr", Image(16, 8, 3, 1.0f));
        test::writeBytes(folder / "square.obj", "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
                                                "f 1/1 2/2 3/3 4/4\n");
        test::writeBytes(folder / "bare.stl", "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"
                                              "endloop\nendfacet\nendsolid s\n");
        stored = Image(edge, edge);
        for (int y = 0; y < edge; ++y)
            for (int x = 0; x < edge; ++x) {
                const glm::vec3 c = (x / 4 + y / 8) % 2 == 0 ? glm::vec3(0.8f, 0.2f, 0.4f) : glm::vec3(0.0f, 1.0f, 0.6f);
                std::copy_n(&c.x, 3, stored.texel(x, y));
            }
        test::writePng(folder / "checker.png", stored, 8);
        // The corners lie on the unit sphere, so that the square is sqrt(2) wide; 90 degrees show twice the distance.
        test::writeBytes(folder / "scene.mirrorball", R"({"version": 1, "probe": {"source": "white.exr"},
            "material": {"specular": {"weight": 0}, "diffuse": {"weight": 1, "color": [1, 1, 1], "picture": "checker.png"}},
            "view": {"geometry": "square.obj", "tone": "none", "width": 32, "height": 32,
                     "camera": {"yaw": 0, "pitch": 0, "distance": 0.70710678, "fov": 90, "projection": "orthographic"}}})");
    }
    ProgramRun render(const std::string& options = "", const std::string& name = "out.png") const
    {
        return mirrorballRuns("render '" + (folder / "scene.mirrorball").string() + "' " + options + " -o '" + (folder / name).string() +
                              "'");
    }
    std::string in(const std::string& name) const { return (folder / name).string(); }

    test::TemporaryFolder folder;
    Image stored{};
};

// Decoded, lit by 1 from everywhere, and encoded again: the bytes of the picture, each in its place. Along a cell's edge a pixel's samples,
// each between texels, mix both colors.
TEST_F(SurfacePicture, OfADiffuseSurfaceInWhiteLightIsWhatIsSeen)
{
    const ProgramRun run = render("--explain");
    ASSERT_EQ(run.status, 0) << run.err;
    EXPECT_NE(run.out.find("read diffuse picture"), std::string::npos) << run.out;
    const PngPicture drawn(folder / "out.png");
    for (int y = 0; y < edge; ++y)
        for (int x = 0; x < edge; ++x)
            for (size_t c = 0; c < 3 && x % 4 % 3 != 0 && y % 8 % 7 != 0; ++c)
                ASSERT_NEAR(drawn.at(x, y)[c], std::round(255.0 * stored.texel(x, y)[c]), 1) << x << ' ' << y;
}

TEST_F(SurfacePicture, IsNamedOrLeftOutByAnOption)
{
    ASSERT_EQ(render("--set material.diffuse.picture=", "plain.png").status, 0);
    const PngPicture plain(folder / "plain.png");
    EXPECT_EQ(plain.at(9, 9)[0], 255);
    const ProgramRun hidden = render("--explain --set material.diffuse.weight=0 --set material.diffuse.picture=missing.png");
    EXPECT_EQ(hidden.status, 0) << hidden.err;
    EXPECT_NE(hidden.out.find("diffuse weight is 0"), std::string::npos) << hidden.out;
}

TEST_F(SurfacePicture, ThatIsMissingOrHasNoPlaceOnTheMeshIsOneLine)
{
    EXPECT_FAILS(render("--set material.diffuse.picture=missing.png"), 2, "material.diffuse.picture: " + in("missing.png") + ": ");
    EXPECT_FAILS(render("--set material.normal_map.source=missing.png"), 2, "material.normal_map.source: " + in("missing.png") + ": ");
    EXPECT_FAILS(render("--geometry '" + in("bare.stl") + "'"), 2, "material.diffuse.picture: \"checker.png\" lies on the mesh");
    EXPECT_FAILS(render("--sphere-map jade --set material.sphere_map.flecks.density=0.5 --set material.sphere_map.flecks.pattern=gone.exr"),
                 2, "material.sphere_map.flecks.pattern: " + in("gone.exr") + ": ");
}

TEST_F(SurfacePicture, IsAnInputOfTheRecipe)
{
    writeImage(folder / "half.exr", Image(2, 1, 3, 0.5f));
    writeImage(folder / "flat.exr", Image(2, 1, 3, 0.5f));
    ASSERT_EQ(render("--recipe --sphere-map jade --use over --set material.sphere_map.flecks.density=0.5 "
                     "--set material.sphere_map.flecks.pattern=half.exr --set material.normal_map.source=flat.exr")
                  .status,
              0);
    const std::string recipe = test::readBytes(folder / "out.png.recipe.json");
    for (const char* input : {"checker.png", "half.exr", "flat.exr", "square.obj", "white.exr"})
        EXPECT_NE(recipe.find(input), std::string::npos) << input << " in " << recipe;
}

} // namespace
} // namespace mirrorball
