#include "core/sphere/cube_map.h"

#include <gtest/gtest.h>

namespace mirrorball {
namespace {

constexpr MapLayout cube{Parameterization::Cube, 16, 0};

TEST(CubeMap, FaceAxesAreThoseOfOpenGL)
{
    // Table 8.19 by its definition: which direction has s, t = 0 or 1 in which face.
    const auto s = [](const glm::dvec3& d) { return cube_map::facePosition(d).s; };
    const auto t = [](const glm::dvec3& d) { return cube_map::facePosition(d).t; };
    EXPECT_DOUBLE_EQ(s({1, 0, 0.5}), -0.5);  // +X: sc = -rz
    EXPECT_DOUBLE_EQ(t({1, 0.5, 0}), -0.5);  //     tc = -ry
    EXPECT_DOUBLE_EQ(s({-1, 0, 0.5}), 0.5);  // -X: sc = +rz
    EXPECT_DOUBLE_EQ(t({-1, 0.5, 0}), -0.5); //     tc = -ry
    EXPECT_DOUBLE_EQ(s({0.5, 1, 0}), 0.5);   // +Y: sc = +rx
    EXPECT_DOUBLE_EQ(t({0, 1, 0.5}), 0.5);   //     tc = +rz
    EXPECT_DOUBLE_EQ(s({0.5, -1, 0}), 0.5);  // -Y: sc = +rx
    EXPECT_DOUBLE_EQ(t({0, -1, 0.5}), -0.5); //     tc = -rz
    EXPECT_DOUBLE_EQ(s({0.5, 0, 1}), 0.5);   // +Z: sc = +rx
    EXPECT_DOUBLE_EQ(t({0, 0.5, 1}), -0.5);  //     tc = -ry
    EXPECT_DOUBLE_EQ(s({0.5, 0, -1}), -0.5); // -Z: sc = -rx
    EXPECT_DOUBLE_EQ(t({0, 0.5, -1}), -0.5); //     tc = -ry
}

TEST(CubeMap, FacesAreStackedInOpenGLsOrder)
{
    const glm::dvec3 axes[] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    for (int face = 0; face < 6; ++face)
        EXPECT_LT(glm::distance(direction(cube, {8.0, 16.0 * face + 8.0}), axes[face]), 1e-15);
}

TEST(CubeMap, SolidAngleAgreesWithTheFourCornerFormula)
{
    const auto corner = [](double s, double t) { return std::atan2(s * t, std::sqrt(s * s + t * t + 1.0)); };
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 16; ++x) {
            const double s0 = x / 8.0 - 1.0, s1 = (x + 1) / 8.0 - 1.0, t0 = y / 8.0 - 1.0, t1 = (y + 1) / 8.0 - 1.0;
            EXPECT_NEAR(texelSolidAngle(cube, x, y), corner(s1, t1) - corner(s0, t1) - corner(s1, t0) + corner(s0, t0), 1e-15);
        }
}

TEST(CubeMap, DensityAtTheCenterIsThreeRootThreeTimesThatAtACorner)
{
    EXPECT_NEAR(cube_map::density(16, {8, 8}) / cube_map::density(16, {0, 0}), 3.0 * std::sqrt(3.0), 1e-14);
    const MapLayout large{Parameterization::Cube, 2048, 0};
    EXPECT_NEAR(texelSolidAngle(large, 1024, 1024) / texelSolidAngle(large, 0, 0), 3.0 * std::sqrt(3.0), 0.01);
}

TEST(CubeMap, AStepOverAnEdgeMeetsTheTexelThatMeetsIt)
{
    // For every border texel of every face: the neighbor shares the middle of the edge, and stepping back returns.
    constexpr int n = 16;
    for (int face = 0; face < 6; ++face)
        for (int i = 0; i < n; ++i) {
            const int top = face * n;
            const Texel from[] = {{0, top + i}, {n - 1, top + i}, {i, top}, {i, top + n - 1}};
            const Texel to[] = {{-1, top + i}, {n, top + i}, {i, top - 1}, {i, top + n}};
            const glm::dvec2 edge[] = {{0.0, i + 0.5}, {n, i + 0.5}, {i + 0.5, 0.0}, {i + 0.5, n}};
            for (size_t k = 0; k < 4; ++k) {
                const Texel t = acrossSeam(cube, from[k], to[k].x, to[k].y);
                EXPECT_NE(t.y / n, face);
                const glm::dvec3 shared = glm::normalize(cube_map::facePoint(face, 2 * edge[k].x / n - 1, 2 * edge[k].y / n - 1));
                const double a = glm::distance(shared, texelDirection(cube, t.x, t.y));
                const double b = glm::distance(shared, texelDirection(cube, from[k].x, from[k].y));
                EXPECT_NEAR(a, b, 1e-14);
                bool returns = false;
                for (const Texel& back : {Texel{t.x - 1, t.y}, Texel{t.x + 1, t.y}, Texel{t.x, t.y - 1}, Texel{t.x, t.y + 1}})
                    returns = returns || acrossSeam(cube, t, back.x, back.y) == from[k];
                EXPECT_TRUE(returns);
            }
        }
}

TEST(CubeMap, ADiagonalStepOverACornerFindsOneOfTheCornersOtherTexels)
{
    constexpr int n = 16;
    for (int face = 0; face < 6; ++face)
        for (const int x : {0, n - 1})
            for (const int y : {0, n - 1}) {
                const Texel from{x, face * n + y};
                const Texel t = acrossSeam(cube, from, x == 0 ? -1 : n, face * n + (y == 0 ? -1 : n));
                const glm::dvec3 corner = glm::normalize(cube_map::facePoint(face, x == 0 ? -1 : 1, y == 0 ? -1 : 1));
                EXPECT_NE(t.y / n, face);
                EXPECT_NEAR(glm::distance(corner, texelDirection(cube, t.x, t.y)),
                            glm::distance(corner, texelDirection(cube, from.x, from.y)), 1e-14);
            }
}

} // namespace
} // namespace mirrorball
