#include "core/sphere/mapping.h"

#include "core/sphere/disc.h"
#include "core/sphere/distortion.h"
#include "support/directions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>

namespace mirrorball {
namespace {

using test::describe;
using test::layoutsOfSize;

TEST(Mapping, EachKindFindsItsOwnRow)
{
    for (const Parameterization kind : allParameterizations)
        EXPECT_EQ(mapping(kind).kind, kind) << name(kind);
}

// Functions of shaders begin with them, so they are letters; the command line tells them apart.
TEST(Mapping, NamesAreWordsAndDiffer)
{
    for (const Mapping& row : mappings) {
        EXPECT_TRUE(std::all_of(row.name.begin(), row.name.end(), [](unsigned char c) { return std::islower(c) != 0; })) << row.name;
        EXPECT_EQ(std::count_if(mappings.begin(), mappings.end(), [&](const Mapping& other) { return other.name == row.name; }), 1);
        EXPECT_FALSE(row.axes.empty()) << row.name;
        EXPECT_FALSE(row.seen.empty()) << row.name;
    }
}

TEST(Mapping, TexelsOfARowAreAlikeWhereItSaysSo)
{
    for (const MapLayout& layout : layoutsOfSize(8)) {
        bool alike = true;
        for (int y = 0; y < layout.height(); ++y)
            for (int x = 1; x < layout.width(); ++x)
                alike = alike && std::abs(texelSolidAngle(layout, x, y) - texelSolidAngle(layout, 0, y)) < 1e-14;
        EXPECT_EQ(mapping(layout.kind).rowsAreAlike, alike) << describe(layout);
    }
}

// The longer axis of a texel's ellipse by differences, which are good to 1e-6.
TEST(Mapping, LongestSideIsTheOneOfEveryTexel)
{
    for (const MapLayout& layout : layoutsOfSize(32)) {
        const double longest = mapping(layout.kind).longestSide / layout.size;
        if (longest == 0.0)
            continue;
        for (const glm::dvec3& d : test::randomDirections(200)) {
            if (std::abs(d.y) < 0.99 && d.z > -0.99) { // away from poles and rim
                EXPECT_NEAR(distortion(layout, coordinate(layout, d)).major / longest, 1.0, 1e-4) << describe(layout);
            }
        }
    }
}

// The way down the middle of the first chart is part of a great circle in every mapping.
TEST(Mapping, QuarterTurnsAreThoseThatAChartSpans)
{
    for (const Parameterization kind : allParameterizations) {
        const MapLayout layout{kind, 64, 0};
        constexpr int steps = 4000;
        double angle = 0.0;
        const auto at = [&](int i) { return direction(layout, {0.5 * layout.chartWidth(), layout.size * (i + 0.5) / steps}); };
        for (int i = 1; i < steps; ++i)
            angle += 2.0 * std::asin(std::min(1.0, 0.5 * glm::distance(at(i - 1), at(i))));
        // The half steps at both ends are missing: little but for the sphere map, which at its rim runs as a square root.
        EXPECT_NEAR(angle / (0.5 * pi), mapping(kind).quarterTurns, 0.07) << name(kind);
    }
}

TEST(Mapping, TheRimOfASingleDiscIsMinusZ)
{
    for (const MapLayout& layout : layoutsOfSize(16)) {
        if (mapping(layout.kind).charts != Charts::Disc)
            continue;
        const disc::Disc disc = disc::at(layout, 0.0);
        for (int i = 0; i < 16; ++i) {
            const glm::dvec2 q{std::cos(i * pi / 8.0), std::sin(i * pi / 8.0)};
            EXPECT_LT(glm::distance(direction(layout, disc.toImage(q)), glm::dvec3(0.0, 0.0, -1.0)), 1e-7) << describe(layout);
        }
    }
}

} // namespace
} // namespace mirrorball
