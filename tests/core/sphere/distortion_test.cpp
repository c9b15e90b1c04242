#include "core/sphere/distortion.h"
#include "core/sphere/map_sheet.h"

#include <gtest/gtest.h>

#include <random>

namespace mirrorball {
namespace {

/// Positions well inside the charts of a layout.
template <typename Check>
void atInnerPositions(const MapLayout& layout, const Check& check)
{
    std::mt19937 random(5);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    for (int i = 0; i < 500; ++i) {
        const glm::dvec2 p(unit(random) * layout.width(), unit(random) * layout.height());
        if (density(layout, p) > 0.0 && seamDistance(layout, p) > 0.5)
            check(p);
    }
}

TEST(Distortion, HasTheSolidAngleOfTheClosedFormInEveryParameterization)
{
    for (const Parameterization kind : allParameterizations) {
        const MapLayout layout{kind, 64, kind == Parameterization::Paraboloid ? 3 : 0};
        atInnerPositions(layout, [&](const glm::dvec2& p) {
            if (kind == Parameterization::Octahedral && std::abs(std::abs(p.x / 32.0 - 1.0) + std::abs(p.y / 32.0 - 1.0) - 1.0) < 1e-3)
                return; // on the fold the derivative has two values
            EXPECT_NEAR(distortion(layout, p).solidAngle() / density(layout, p), 1.0, 1e-4) << name(kind) << " at " << p.x << ", " << p.y;
        });
    }
}

// A stereographic projection is conformal; lines of latitude are cos(lat) as long as the equator; a sphere map keeps area, so what it gains
// along the rim, 1/cos(theta/2) radially against its inverse, squares.
TEST(Distortion, KnowsTheAnisotropyOfTheClassicalMaps)
{
    const MapLayout paraboloid{Parameterization::Paraboloid, 64, 3}, latlong{Parameterization::Latlong, 64, 0},
        sphere{Parameterization::Sphere, 64, 0};
    atInnerPositions(paraboloid, [&](const glm::dvec2& p) { EXPECT_NEAR(distortion(paraboloid, p).anisotropy(), 1.0, 1e-5); });
    atInnerPositions(latlong, [&](const glm::dvec2& p) {
        EXPECT_NEAR(distortion(latlong, p).anisotropy() * std::sqrt(1.0 - std::pow(direction(latlong, p).y, 2.0)), 1.0, 1e-5);
    });
    atInnerPositions(sphere, [&](const glm::dvec2& p) {
        const double cosHalf2 = 0.5 * (1.0 + direction(sphere, p).z); // cos^2(theta/2)
        EXPECT_NEAR(distortion(sphere, p).anisotropy() * cosHalf2, 1.0, 1e-3);
    });
}

TEST(MapSheet, LeadsEveryImagePositionThereAndBack)
{
    for (const Parameterization kind : allParameterizations) {
        const MapLayout layout{kind, 16, 0};
        for (int y = 0; y < layout.height(); ++y)
            for (int x = 0; x < layout.width(); ++x) {
                const glm::dvec2 p(x + 0.25, y + 0.75);
                const auto back = imageFromSheet(layout, sheetFromImage(layout, p));
                ASSERT_TRUE(back.has_value());
                EXPECT_NEAR(glm::length(*back - p), 0.0, 1e-12);
            }
    }
}

// Across each of the five inner edges of the cross the directions run on without a jump: none of its faces is turned.
TEST(MapSheet, UnfoldsTheCubeWithoutAJumpInDirection)
{
    const MapLayout cube{Parameterization::Cube, 64, 0};
    const auto at = [&](double x, double y) { return direction(cube, imageFromSheet(cube, {x, y}).value()); };
    for (const double along : {10.0, 32.0, 60.0}) {
        for (const double edge : {64.0, 128.0, 192.0})
            EXPECT_LT(glm::length(at(edge - 0.01, 64.0 + along) - at(edge + 0.01, 64.0 + along)), 1e-3);
        for (const double edge : {64.0, 128.0})
            EXPECT_LT(glm::length(at(64.0 + along, edge - 0.01) - at(64.0 + along, edge + 0.01)), 1e-3);
    }
    EXPECT_FALSE(imageFromSheet(cube, {10.0, 10.0}).has_value());
    EXPECT_FALSE(imageFromSheet(cube, {-1.0, 70.0}).has_value());
}

TEST(MapSheet, MeasuresSeamsFromTheRimOfADisc)
{
    const MapLayout paraboloid{Parameterization::Paraboloid, 64, 4};
    EXPECT_NEAR(seamDistance(paraboloid, {32.0, 4.0}), 0.0, 1e-12);
    EXPECT_NEAR(seamDistance(paraboloid, {96.0, 32.0}), 28.0, 1e-12);
    EXPECT_NEAR(seamDistance({Parameterization::Cube, 64, 0}, {32.0, 64.0 + 5.0}), 5.0, 1e-12);
}

} // namespace
} // namespace mirrorball
