#include "core/spheremap/strokes/pulled_string.h"
#include "core/spheremap/strokes/stroke_recorder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace mirrorball {
namespace {

/// A hand that means a straight line and trembles across it.
glm::dvec2 trembling(int step) { return {4.0 * step, 3.0 * std::sin(1.7 * step) + 2.0 * std::sin(0.9 * step + 1.0)}; }

TEST(PulledString, KeepsTheBrushALengthBehindAPointerThatMovesStraightOn)
{
    const glm::dvec2 direction{0.6, -0.8};
    PulledString string(20.0, {5.0, 7.0});
    for (int step = 0; step <= 100; ++step) {
        const glm::dvec2 brush = string.pull(glm::dvec2(5.0, 7.0) + direction * static_cast<double>(step));
        const double gone = std::max(0.0, step - 20.0);
        EXPECT_LT(glm::distance(brush, glm::dvec2(5.0, 7.0) + direction * gone), 1e-9) << step;
    }
}

TEST(PulledString, DoesNotMoveUnderATremorShorterThanIt)
{
    PulledString string(20.0, {1.0, 2.0});
    for (int step = 0; step < 50; ++step)
        EXPECT_EQ(string.pull({1.0 + 19.0 * std::cos(step), 2.0 + 19.0 * std::sin(step)}), glm::dvec2(1.0, 2.0));
}

TEST(PulledString, MakesATremblingLineAStraighterOne)
{
    PulledString string(40.0, trembling(0));
    double steadied = 0.0, drawn = 0.0;
    for (int step = 0; step < 800; ++step) {
        const glm::dvec2 pointer = trembling(step), brush = string.pull(pointer);
        if (step < 200) // at first the string only straightens
            continue;
        drawn = std::max(drawn, std::abs(pointer.y));
        steadied = std::max(steadied, std::abs(brush.y));
    }
    EXPECT_GT(drawn, 4.5);
    // The brush draws a tractrix, dy = (p_y - b_y) / L ds: a wave across the way of length w keeps 1 / sqrt(1 + (2 pi L / w)^2) of itself.
    // The tremor's two waves are 8 pi / 1.7 and 8 pi / 0.9 long: 3 / 17 + 2 / 9 = 0.40 are left of them, for small angles.
    EXPECT_LT(steadied, 0.1 * drawn);
}

TEST(PulledString, WithoutALengthTheRecordedPointsAreThoseOfThePointerToTheLastBit)
{
    PulledString string(0.0, trembling(0));
    StrokeRecorder with({}, {}), without({}, {});
    for (int step = 0; step < 100; ++step) {
        const glm::dvec2 pointer = 0.01 * trembling(step);
        with.add({string.pull(pointer), 0.5});
        without.add({pointer, 0.5});
    }
    with.finish();
    without.finish();
    EXPECT_EQ(with.strokes(), without.strokes());
}

} // namespace
} // namespace mirrorball
