#include "core/sphere/octahedral.h"

#include "support/directions.h"

#include <gtest/gtest.h>

namespace mirrorball {
namespace {

TEST(Octahedral, HasPlusYInTheMiddlePlusXRightPlusZBelowAndMinusYInTheCorners)
{
    const auto at = [](double u, double v) { return octahedral::direction(10, {10 * u, 10 * v}); };
    EXPECT_LT(glm::distance(at(0.5, 0.5), {0, 1, 0}), 1e-15);
    EXPECT_LT(glm::distance(at(1.0, 0.5), {1, 0, 0}), 1e-15);
    EXPECT_LT(glm::distance(at(0.0, 0.5), {-1, 0, 0}), 1e-15);
    EXPECT_LT(glm::distance(at(0.5, 1.0), {0, 0, 1}), 1e-15);
    EXPECT_LT(glm::distance(at(0.5, 0.0), {0, 0, -1}), 1e-15);
    for (const double u : {0.0, 1.0})
        for (const double v : {0.0, 1.0})
            EXPECT_LT(glm::distance(at(u, v), {0, -1, 0}), 1e-15);
}

TEST(Octahedral, AnOctantHasHalfPi)
{
    // The inner triangle of a quadrant is the octant y >= 0, the outer one y <= 0.
    EXPECT_NEAR(octahedral::solidAngle(2, {1, 1}, {2, 2}), pi, 1e-14);
    EXPECT_NEAR(octahedral::solidAngle(1, {0, 0}, {1, 1}), 4.0 * pi, 1e-13);
}

TEST(Octahedral, EveryTexelIsTheSumOfItsQuarters)
{
    // Odd sizes cut texels by the fold lines in every way; quarters are cut differently.
    for (const int n : {3, 5, 7, 8})
        for (int y = 0; y < n; ++y)
            for (int x = 0; x < n; ++x) {
                double parts = 0.0;
                for (int j = 0; j < 2; ++j)
                    for (int i = 0; i < 2; ++i)
                        parts += octahedral::solidAngle(n, {x + 0.5 * i, y + 0.5 * j}, {x + 0.5 * (i + 1), y + 0.5 * (j + 1)});
                EXPECT_NEAR(octahedral::solidAngle(n, {x, y}, {x + 1, y + 1}), parts, 1e-14) << n << ": " << x << " " << y;
            }
}

TEST(Octahedral, IsContinuousOverItsEdges)
{
    constexpr int n = 16;
    for (double v = 0.01; v < 1.0; v += 0.07) {
        const glm::dvec3 inside = octahedral::direction(n, {n - 1e-9, n * v}), outside = octahedral::direction(n, {n + 1e-9, n * v});
        EXPECT_LT(glm::distance(inside, outside), 1e-8);
    }
    for (int i = 0; i < n; ++i) {
        const Texel t = octahedral::acrossSeam(n, n, i);
        EXPECT_EQ(t, (Texel{n - 1, n - 1 - i}));
        EXPECT_LT(glm::distance(octahedral::direction(n, {n + 0.5, i + 0.5}), octahedral::direction(n, {t.x + 0.5, t.y + 0.5})), 1e-14);
    }
}

} // namespace
} // namespace mirrorball
