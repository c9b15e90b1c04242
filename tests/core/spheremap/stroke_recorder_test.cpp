#include "core/spheremap/strokes/stroke_recorder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace mirrorball {
namespace {

TEST(StrokeRecorder, AClickIsOneDab)
{
    StrokeRecorder recorder({}, {});
    recorder.add({{0.123456789, -0.5}, 0.7});
    recorder.finish();
    ASSERT_EQ(recorder.strokes().size(), 1u);
    EXPECT_EQ(recorder.strokes()[0].points, (std::vector<StrokePoint>{{{0.12346, -0.5}, 0.7}}));
}

TEST(StrokeRecorder, SmoothsCornersAndBeginsAndEndsWhereThePenDid)
{
    // A circle sampled in 12 corners: the curve may leave it by no more than the corners' polygon does, and turns gently.
    StrokeRecorder recorder({.radius = 0.02}, {});
    for (int i = 0; i <= 12; ++i)
        recorder.add({{0.5 * std::cos(i * 0.5236), 0.5 * std::sin(i * 0.5236)}, 1.0});
    recorder.finish();
    ASSERT_EQ(recorder.strokes().size(), 1u);
    const std::vector<StrokePoint>& points = recorder.strokes()[0].points;
    EXPECT_LT(glm::distance(points.front().q, glm::dvec2(0.5, 0.0)), 1e-5);
    EXPECT_LT(glm::distance(points.back().q, glm::dvec2(0.5, 0.0)), 1e-4);
    EXPECT_GT(points.size(), 24u);
    for (size_t i = 2; i + 2 < points.size(); ++i) {
        EXPECT_GT(glm::length(points[i].q), 0.5 * std::cos(0.2618) - 1e-3);
        EXPECT_LT(glm::length(points[i].q), 0.5 + 1e-5);
        const glm::dvec2 a = glm::normalize(points[i].q - points[i - 1].q), b = glm::normalize(points[i + 1].q - points[i].q);
        EXPECT_GT(glm::dot(a, b), std::cos(0.4)) << i; // the samples' corners are of 0.52
    }
}

TEST(StrokeRecorder, WhatStandsStaysAsTheStrokeGoesOn)
{
    StrokeRecorder recorder({}, {});
    std::vector<StrokePoint> before;
    for (int i = 0; i < 30; ++i) {
        recorder.add({{0.03 * i, 0.3 * std::sin(0.7 * i)}, 0.5});
        const std::vector<StrokePoint>& now = recorder.strokes()[0].points;
        ASSERT_GE(now.size(), before.size());
        EXPECT_TRUE(std::equal(before.begin(), before.end(), now.begin()));
        before = now;
    }
}

TEST(StrokeRecorder, ALeapOrALiftedPenBeginsAnotherStroke)
{
    StrokeRecorder recorder({}, {.radial = 3}, 0.3);
    recorder.add({{0.0, 0.0}, 1.0});
    recorder.add({{0.1, 0.0}, 1.0});
    recorder.add({{0.9, 0.0}, 1.0});
    recorder.add({{0.91, 0.05}, 1.0});
    recorder.lift();
    recorder.add({{0.92, 0.05}, 1.0});
    recorder.finish();
    ASSERT_EQ(recorder.strokes().size(), 3u);
    EXPECT_EQ(recorder.strokes()[0].points.back().q, glm::dvec2(0.1, 0.0));
    EXPECT_EQ(recorder.strokes()[1].points.front().q, glm::dvec2(0.9, 0.0));
    EXPECT_EQ(recorder.strokes()[2].symmetry.radial, 3);
}

TEST(StrokeRecorder, TakesTiltsToATenthOfADegreeAndOnlyWhereTheBrushHeedsThem)
{
    for (const double heeds : {0.0, 1.0}) {
        StrokeRecorder recorder({.tilt = heeds}, {});
        for (int i = 0; i < 5; ++i)
            recorder.add({{0.1 * i, 0.0}, 1.0, {12.3456, -75.0}});
        recorder.finish();
        for (const StrokePoint& point : recorder.strokes()[0].points)
            EXPECT_EQ(point.tilt, heeds * glm::dvec2(12.3, -60.0));
        EXPECT_NO_THROW(validate(recorder.strokes()));
    }
}

TEST(StrokeRecorder, SamplesThatAreNoPlaceAreLeftOut)
{
    StrokeRecorder recorder({}, {});
    recorder.add({{0.0, 0.0}, 1.0});
    recorder.add({{std::numeric_limits<double>::quiet_NaN(), 0.0}, 1.0});
    recorder.add({{1e9, 0.0}, 7.0});
    recorder.finish();
    EXPECT_NO_THROW(validate(recorder.strokes()));
}

} // namespace
} // namespace mirrorball
