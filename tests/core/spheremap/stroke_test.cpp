#include "core/spheremap/strokes/stroke.h"

#include "core/base/error.h"
#include "core/sphere/direction.h"
#include "support/stroke_builders.h"

#include <gtest/gtest.h>

#include <limits>

namespace mirrorball {
namespace {

std::string refusal(const std::vector<Stroke>& strokes)
{
    try {
        validate(strokes);
    } catch (const InvalidArgument& error) {
        return error.what();
    }
    return {};
}

TEST(Brush, ADabHoldsAsMuchPaintOnAnyGrid)
{
    // The integral of p over the disc, with v = d^2: pi times the integral of p dv = pi (inner^2 + (outer^2 - inner^2) / 2),
    // because u^2 (3 - 2u) is symmetric about 1/2.
    for (const double hardness : {0.0, 0.5, 0.9, 1.0})
        for (const double radius : {0.4, 1.0, 3.0, 12.0, 50.0}) {
            const DabProfile dab = dabProfile(radius, hardness, 0.8);
            double sum = 0.0; // over a few offsets of the grid, which a small tip feels
            for (int offset = 0; offset < 16; ++offset) {
                const double cx = 0.25 * (offset % 4), cy = 0.25 * (offset / 4); // NOLINT: an index in two digits
                for (int y = -60; y <= 60; ++y)
                    for (int x = -60; x <= 60; ++x)
                        sum += static_cast<double>(dab.at(static_cast<float>((x - cx) * (x - cx) + (y - cy) * (y - cy)))) / 16.0;
            }
            const double inner = hardness * radius;
            const double expected = 0.8 * pi * 0.5 * (radius * radius + inner * inner);
            // Sixteen samples a texel of a bump as narrow as the smallest tip are good to half a per cent.
            EXPECT_NEAR(sum / expected, 1.0, 0.005) << "radius " << radius << " hardness " << hardness;
        }
}

TEST(Brush, PressureMakesTheTipSmallerAndWeakerAsFarAsItIsToldTo)
{
    const Brush brush{.radius = 0.1, .flow = 0.5, .pressureRadius = 0.5, .pressureFlow = 1.0};
    EXPECT_DOUBLE_EQ(radiusAt(brush, 1.0), 0.1);
    EXPECT_DOUBLE_EQ(radiusAt(brush, 0.0), 0.05);
    EXPECT_DOUBLE_EQ(strengthAt(brush, 1.0), 0.5);
    EXPECT_DOUBLE_EQ(strengthAt(brush, 0.5), 0.25);
    EXPECT_DOUBLE_EQ(strengthAt(brush, 0.0), 0.0);
}

TEST(Brush, AJetFromATiltedPenIsAnEllipseLongerByTheReciprocalCosine)
{
    const auto length = [](const glm::dvec2& lean) { return 1.0 / std::sqrt(1.0 - glm::dot(lean, lean)); };
    EXPECT_EQ(leanAt({.tilt = 0.0}, {50.0, 20.0}), glm::dvec2(0.0));
    EXPECT_EQ(leanAt({.tilt = 1.0}, {0.0, 0.0}), glm::dvec2(0.0));
    EXPECT_NEAR(length(leanAt({.tilt = 1.0}, {60.0, 0.0})), 2.0, 1e-12); // 1 / cos 60
    EXPECT_NEAR(length(leanAt({.tilt = 0.5}, {0.0, -60.0})), 1.5, 1e-12);
    const glm::dvec2 both = leanAt({.tilt = 1.0}, {45.0, 45.0});
    EXPECT_NEAR(length(both), std::sqrt(3.0), 1e-12);
    EXPECT_NEAR(both.x, both.y, 1e-15);
}

TEST(Symmetry, MapsFormAGroupThatKeepsLengths)
{
    const std::vector<glm::dmat2> maps = symmetryMaps({.radial = 5, .mirror = true, .axisDeg = 27.0});
    ASSERT_EQ(maps.size(), 10u);
    EXPECT_EQ(maps[0], glm::dmat2(1.0));
    const auto has = [&](const glm::dmat2& m) {
        for (const glm::dmat2& map : maps)
            if (glm::length(map[0] - m[0]) + glm::length(map[1] - m[1]) < 1e-14)
                return true;
        return false;
    };
    for (const glm::dmat2& a : maps)
        for (const glm::dmat2& b : maps)
            EXPECT_TRUE(has(a * b));
}

TEST(Symmetry, AVerticalAxisExchangesLeftAndRight)
{
    const std::vector<glm::dmat2> maps = symmetryMaps({.mirror = true});
    ASSERT_EQ(maps.size(), 2u);
    EXPECT_LT(glm::distance(maps[1] * glm::dvec2(0.3, 0.7), glm::dvec2(-0.3, 0.7)), 1e-15);
}

TEST(Stroke, DabsLieOneSpacingApartAlongTheWayRoundCornersToo)
{
    Stroke stroke{.brush = {.radius = 0.1, .spacing = 0.25}, .points = {{{0.0, 0.0}, 1.0}, {{0.12, 0.0}, 1.0}, {{0.12, 0.2}, 1.0}}};
    const StrokeDabs dabs = strokeDabs(stroke);
    ASSERT_EQ(dabs.dabs.size(), 7u); // a way of 0.32 in steps of 0.05
    for (size_t i = 0; i < dabs.dabs.size(); ++i) {
        const double s = 0.05 * static_cast<double>(i);
        const glm::dvec2 expected = s <= 0.12 ? glm::dvec2(s, 0.0) : glm::dvec2(0.12, s - 0.12);
        EXPECT_LT(glm::distance(dabs.dabs[i].q, expected), 1e-12) << i;
    }
}

TEST(Stroke, LengtheningItOnlyAppendsTouches)
{
    std::vector<Stroke> strokes = handDrawnStrokes(4, 7);
    for (Stroke& stroke : strokes) {
        stroke.symmetry = {.radial = 3, .mirror = true};
        const StrokeDabs whole = strokeDabs(stroke);
        stroke.points.resize(stroke.points.size() / 2);
        const StrokeDabs part = strokeDabs(stroke);
        ASSERT_LT(part.touches(), whole.touches());
        for (size_t copy = 0; copy < 6; ++copy)
            for (size_t i = 0; i < part.touches(); ++i)
                EXPECT_EQ(part.dabs[copy * part.touches() + i].q, whole.dabs[copy * whole.touches() + i].q);
    }
}

TEST(Stroke, GoesOnUnderAPenThatHardlyTouches)
{
    Stroke stroke = straightStroke({-1, 0}, {1, 0}, {.radius = 1e-3, .spacing = 0.02, .pressureRadius = 1.0});
    stroke.points[0].pressure = stroke.points[1].pressure = 0.0;
    EXPECT_EQ(strokeDabs(stroke).dabs.size(), 1600001u); // steps of 2 * 0.001 / 32 * 0.02
}

TEST(Stroke, WithoutPointsDrawsNothing)
{
    EXPECT_TRUE(strokeDabs({}).dabs.empty());
    EXPECT_EQ(refusal({Stroke{}}), "");
}

TEST(Stroke, NumbersThatAreNotFiniteOrOutOfRangeAreNamed)
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    Stroke bad = dab({0.0, nan});
    EXPECT_EQ(refusal({Stroke{}, bad}), "strokes[1].points[0]: must lie within 4 disc radii of the center, as finite numbers");
    bad = dab({0.0, 0.0});
    bad.points[0].pressure = 1.5;
    EXPECT_EQ(refusal({bad}), "strokes[0].points[0]: has a pressure outside [0, 1]; pressure is the third number of a point");
    EXPECT_EQ(refusal({dab({0, 0}, {.radius = 0.0})}), "strokes[0].brush.radius: must be from 0.001 to 2 disc radii; it is 0");
    EXPECT_EQ(refusal({dab({0, 0}, {.flow = nan})}), "strokes[0].brush.flow: must be from 0 to 1; it is nan");
    bad.points[0] = {{0.0, 0.0}, 1.0, {0.0, nan}};
    EXPECT_EQ(refusal({bad}),
              "strokes[0].points[0]: has a tilt outside [-60, 60] degrees; tilts are the fourth and fifth number of a point");
    bad = dab({0.0, 0.0});
    bad.symmetry.radial = 1000;
    EXPECT_EQ(refusal({bad}), "strokes[0].symmetry.radial: must be from 1 to 64; it is 1000");
}

TEST(Stroke, AMillionPointsThatWouldTakeBillionsOfDabsAreRefusedBeforeAnyIsMade)
{
    Stroke scribble{.brush = {.radius = 1e-3, .spacing = 0.02}};
    for (int i = 0; i < 1000000; ++i)
        scribble.points.push_back({{i % 2 ? 1.0 : -1.0, 0.0}, 1.0});
    const std::string message = refusal({scribble});
    EXPECT_NE(message.find("strokes[0]: needs more than 2097152 dabs; draw less at once"), std::string::npos) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos);
    EXPECT_THROW(strokeDabs(scribble), InvalidArgument);
    scribble.points.resize(mostStrokePoints + 1);
    EXPECT_EQ(refusal({scribble}), "strokes[0].points: are more than 1048576; thin the stroke out");
    scribble.brush.radius = 2.0;
    scribble.brush.spacing = 10.0;
    scribble.points.resize(600000);
    EXPECT_EQ(refusal({scribble}), "");
    EXPECT_EQ(refusal({scribble, scribble}),
              "strokes: hold more than 1048576 points; thin the strokes out or spread them over several layers");
}

} // namespace
} // namespace mirrorball
