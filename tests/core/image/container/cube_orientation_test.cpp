#include "core/image/container/cube_orientation.h"

#include "core/sphere/cube_map.h"
#include "core/sphere/parameterization.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace mirrorball {
namespace {

constexpr int n = 5;

/// A cube whose texels hold the point of the cube that they stand for.
Image pointsOf()
{
    Image image(n, 6 * n, 3);
    for (int face = 0; face < 6; ++face)
        for (int y = 0; y < n; ++y)
            for (int x = 0; x < n; ++x) {
                const glm::vec3 p(cube_map::facePoint(face, (2.0 * x + 1.0) / n - 1.0, (2.0 * y + 1.0) / n - 1.0));
                std::copy_n(&p.x, 3, image.texel(x, face * n + y));
            }
    return image;
}

std::vector<CubeOrientation> allOrientations()
{
    std::vector<CubeOrientation> all;
    for (int permutation = 0; permutation < 6; ++permutation)
        for (int signs = 0; signs < 8; ++signs)
            for (const bool bottomUp : {false, true}) {
                const int first = permutation % 3, second = (first + 1 + permutation / 3) % 3, third = 3 - first - second;
                glm::dmat3 axes(0.0);
                axes[0][first] = (signs & 1) != 0 ? -1.0 : 1.0;
                axes[1][second] = (signs & 2) != 0 ? -1.0 : 1.0;
                axes[2][third] = (signs & 4) != 0 ? -1.0 : 1.0;
                all.push_back({axes, bottomUp});
            }
    return all;
}

TEST(CubeOrientation, EveryStoredTexelHoldsTheDirectionThatTheDefinitionNames)
{
    const Image points = pointsOf();
    for (const CubeOrientation& orientation : allOrientations()) {
        const Image stored = toStored(points, orientation);
        for (int face = 0; face < 6; ++face)
            for (int y = 0; y < n; ++y)
                for (int x = 0; x < n; ++x) {
                    const double s = (2.0 * x + 1.0) / n - 1.0, t = (2.0 * y + 1.0) / n - 1.0;
                    const glm::vec3 expected(orientation.axes * cube_map::facePoint(face, s, orientation.bottomUp ? -t : t));
                    const float* held = stored.texel(x, face * n + y);
                    EXPECT_LT(glm::distance(expected, glm::vec3(held[0], held[1], held[2])), 1e-6f);
                }
        EXPECT_EQ(fromStored(stored, orientation), points);
    }
}

TEST(CubeOrientation, MirroringInXSwapsTheSideFacesAndFlopsAllOfThem)
{
    const Image points = pointsOf(), stored = toStored(points, mirroredInX());
    for (int y = 0; y < n; ++y)
        for (int x = 0; x < n; ++x)
            for (int c = 0; c < 3; ++c) {
                EXPECT_EQ(stored.texel(x, y)[c], points.texel(n - 1 - x, n + y)[c]) << "+X shows -X";
                EXPECT_EQ(stored.texel(x, 4 * n + y)[c], points.texel(n - 1 - x, 4 * n + y)[c]) << "+Z shows itself";
            }
}

TEST(CubeOrientation, ASingleTexelPerFaceIsMovedToo)
{
    Image ours(1, 6, 3);
    for (int face = 0; face < 6; ++face)
        ours.texel(0, face)[0] = static_cast<float>(face);
    const Image stored = toStored(ours, mirroredInX());
    EXPECT_EQ(stored.texel(0, 0)[0], 1.0f);
    EXPECT_EQ(stored.texel(0, 4)[0], 4.0f);
}

} // namespace
} // namespace mirrorball
