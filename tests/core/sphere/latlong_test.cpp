#include "core/sphere/latlong.h"

#include <gtest/gtest.h>

namespace mirrorball {
namespace {

TEST(Latlong, HasPlusZInTheMiddleAndPlusXAtTheLeftQuarter)
{
    const auto at = [](double u, double v) { return latlong::direction(100, {200 * u, 100 * v}); };
    EXPECT_LT(glm::distance(at(0.5, 0.5), {0, 0, 1}), 1e-15);
    EXPECT_LT(glm::distance(at(0.25, 0.5), {1, 0, 0}), 1e-15);
    EXPECT_LT(glm::distance(at(0.75, 0.5), {-1, 0, 0}), 1e-15);
    EXPECT_LT(glm::distance(at(0.0, 0.5), {0, 0, -1}), 1e-15);
    EXPECT_LT(glm::distance(at(0.3, 0.0), {0, 1, 0}), 1e-15);
    EXPECT_LT(glm::distance(at(0.3, 1.0), {0, -1, 0}), 1e-15);
}

TEST(Latlong, TexelsOfOneRowHaveTheSolidAngleOfTheirZone)
{
    // Archimedes: the zone between two latitudes has the area 2 pi times its height.
    constexpr int n = 6;
    for (int y = 0; y < n; ++y) {
        const double height = std::sin(pi / 2 - pi * y / n) - std::sin(pi / 2 - pi * (y + 1) / n);
        EXPECT_NEAR(latlong::solidAngle(n, {3, y}, {4, y + 1}), 2.0 * pi * height / (2 * n), 1e-15);
    }
}

TEST(Latlong, TheSmallestPolarTexelKeepsItsPrecision)
{
    // For h = pi/N the cap has 2 pi (1 - cos h) = pi h^2 (1 - h^2/12 ...).
    constexpr int n = 8192;
    const double h = pi / n;
    EXPECT_NEAR(latlong::solidAngle(n, {0, 0}, {1, 1}) / (pi * h * h * (1.0 - h * h / 12.0) / (2 * n)), 1.0, 1e-14);
}

TEST(Latlong, OverThePoleLiesTheSameRowHalfATurnOn)
{
    EXPECT_EQ(latlong::acrossSeam(8, 3, -1), (Texel{11, 0}));
    EXPECT_EQ(latlong::acrossSeam(8, 11, -2), (Texel{3, 1}));
    EXPECT_EQ(latlong::acrossSeam(8, 3, 8), (Texel{11, 7}));
    EXPECT_EQ(latlong::acrossSeam(8, -1, 4), (Texel{15, 4}));
    EXPECT_EQ(latlong::acrossSeam(8, 16, 4), (Texel{0, 4}));
}

} // namespace
} // namespace mirrorball
