#include "core/image/cube_sheet.h"

#include "core/base/error.h"
#include "core/image/image_io.h"
#include "core/image/map_file.h"
#include "core/image/probe_file.h"
#include "core/sphere/cube_map.h"
#include "support/field.h"
#include "support/temporary_folder.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace mirrorball {
namespace {

TEST(CubeSheet, FacesThatLieTurnedAreTurnedBack)
{
    constexpr int n = 5;
    const EnvironmentMap cube = test::fieldMap({Parameterization::Cube, n, 0});
    Image sheet(n, 6 * n, 3);
    const int turns[]{0, 1, 2, 3, 1, 2}; // quarters, clockwise
    for (int face = 0; face < 6; ++face)
        for (int y = 0; y < n; ++y)
            for (int x = 0; x < n; ++x) {
                int tx = x, ty = y;
                for (int i = 0; i < turns[face]; ++i) {
                    const int before = tx;
                    tx = n - 1 - ty; // the top row becomes the right column
                    ty = before;
                }
                std::copy_n(cube.image.texel(x, face * n + y), 3, sheet.texel(tx, face * n + ty));
            }
    EXPECT_EQ(cutUp(sheet, CubeSheet::Stack, 0, "px nx:90 py:180 ny:270 pz:90 nz:180").image, cube.image);
    for (const char* wrong : {"px nx py ny pz", "px nx py ny pz pz", "px nx py ny pz nz:45", "px nx py ny pz nz nz", "a b c d e f"})
        EXPECT_THROW(checkFaceOrder(wrong), InvalidArgument) << wrong;
}

TEST(CubeSheet, BordersHoldTheNeighborsTexels)
{
    constexpr int n = 8, b = 2;
    const EnvironmentMap cube = test::fieldMap({Parameterization::Cube, n, 0});
    const Image bordered = withBorders(cube, b);
    ASSERT_EQ(bordered.width, n + 2 * b);
    ASSERT_EQ(bordered.height, 6 * (n + 2 * b));
    for (int face = 0; face < 6; ++face)
        for (int y = 0; y < n + 2 * b; ++y)
            for (int x = 0; x < n + 2 * b; ++x) {
                // Where the face's plane goes on, the field is nearly what the neighbor's texel there is; a copy lies within a texel or
                // two.
                const glm::dvec3 d =
                    glm::normalize(cube_map::facePoint(face, 2.0 * (x - b + 0.5) / n - 1.0, 2.0 * (y - b + 0.5) / n - 1.0));
                for (int c = 0; c < 3; ++c)
                    EXPECT_NEAR(bordered.texel(x, face * (n + 2 * b) + y)[c], test::fieldAt(d)[c], 0.13);
            }
    // Exactly: the column beside +X's left edge is +Z's right column. Source: OpenGL 4.5, table 8.19
    for (int y = 0; y < n; ++y)
        EXPECT_EQ(bordered.texel(b - 1, b + y)[1], cube.image.texel(n - 1, 4 * n + y)[1]);
    EXPECT_EQ(cutUp(bordered, CubeSheet::Stack, b, "").image, cube.image);
}

TEST(CubeSheet, BordersSurviveTheFile)
{
    const test::TemporaryFolder folder;
    const EnvironmentMap cube = test::fieldMap({Parameterization::Cube, 8, 0});
    for (const std::string name : {"one.exr", "six_%s.exr"}) {
        writeMap(folder / name, {cube}, {.faceBorder = 3});
        const Probe probe = readProbe((folder / name).string());
        EXPECT_EQ(probe.map.layout, cube.layout) << name;
        EXPECT_EQ(probe.map.image, cube.image) << name;
    }
    EXPECT_EQ(readImage(folder / "six_nz.exr").width, 14);
    EXPECT_THROW(writeMap(folder / "a.exr", {cube}, {.faceBorder = 9}), InvalidArgument);
}

} // namespace
} // namespace mirrorball
