#include "core/spheremap/evaluation/blend.h"

#include <gtest/gtest.h>

#include <cmath>

namespace mirrorball {
namespace {

constexpr BlendMode allModes[] = {BlendMode::Normal,  BlendMode::Multiply,  BlendMode::Screen, BlendMode::Add,
                                  BlendMode::Overlay, BlendMode::SoftLight, BlendMode::Darken, BlendMode::Lighten};

TEST(Blend, IsTheWordedRuleWithinZeroAndOne)
{
    EXPECT_FLOAT_EQ(blended(BlendMode::Normal, 0.3f, 0.6f), 0.6f);
    EXPECT_FLOAT_EQ(blended(BlendMode::Multiply, 0.3f, 0.6f), 0.18f);
    EXPECT_FLOAT_EQ(blended(BlendMode::Screen, 0.3f, 0.6f), 0.72f); // 1 - 0.7 * 0.4
    EXPECT_FLOAT_EQ(blended(BlendMode::Add, 0.3f, 0.6f), 0.9f);
    EXPECT_FLOAT_EQ(blended(BlendMode::Darken, 0.3f, 0.6f), 0.3f);
    EXPECT_FLOAT_EQ(blended(BlendMode::Lighten, 0.3f, 0.6f), 0.6f);
    EXPECT_NEAR(blended(BlendMode::Overlay, 0.16f, 0.36f), 0.48f * 0.48f, 1e-6f);  // roots 0.4 and 0.6: 2 * 0.24
    EXPECT_NEAR(blended(BlendMode::Overlay, 0.36f, 0.16f), 0.52f * 0.52f, 1e-6f);  // roots 0.6 and 0.4: 1 - 2 * 0.4 * 0.6
    EXPECT_NEAR(blended(BlendMode::SoftLight, 0.36f, 0.25f), 0.36f, 1e-6f);        // the middle source changes nothing
    EXPECT_NEAR(blended(BlendMode::SoftLight, 0.25f, 0.0f), 0.25f * 0.25f, 1e-6f); // root 0.5: 0.5 - 0.5 * 0.5
}

TEST(Blend, StaysFiniteRisesAndLeavesNoGapForLightOfAnySize)
{
    for (const BlendMode mode : allModes)
        for (const float b : {0.0f, 0.1f, 0.5f, 0.9999f, 1.0f, 1.0001f, 3.0f, 1000.0f})
            for (float s = 0.0f; s < 4.0f; s += 0.01f) {
                const float here = blended(mode, b, s);
                ASSERT_TRUE(std::isfinite(here) && here >= 0.0f);
                ASSERT_GE(blended(mode, b, s + 0.01f), here - 1e-3f * std::max(1.0f, b)) << static_cast<int>(mode) << ' ' << b << ' ' << s;
                ASSERT_GE(blended(mode, b + 0.01f, s), here - 1e-3f * std::max(1.0f, b)) << static_cast<int>(mode) << ' ' << b << ' ' << s;
            }
    for (const BlendMode mode : allModes)
        for (const float edge : {0.25f, 1.0f}) // where a rule changes its form
            for (const float other : {0.0f, 0.2f, 0.7f, 1.5f}) {
                EXPECT_NEAR(blended(mode, edge - 1e-6f, other), blended(mode, edge + 1e-6f, other), 3e-3f);
                EXPECT_NEAR(blended(mode, other, edge - 1e-6f), blended(mode, other, edge + 1e-6f), 3e-3f);
            }
    EXPECT_GE(blended(BlendMode::Screen, 5.0f, 0.5f), 5.0f); // light never takes light away
}

TEST(Blend, NegativeColorsCountAsBlackWhereAProductWouldTurnTheirSign)
{
    for (const BlendMode mode : {BlendMode::Multiply, BlendMode::Screen, BlendMode::Overlay, BlendMode::SoftLight})
        EXPECT_EQ(blended(mode, -0.5f, 0.7f), blended(mode, 0.0f, 0.7f));
}

TEST(Blend, OverNothingEveryModeShowsTheSource)
{
    for (const BlendMode mode : allModes) {
        ColorSpan source{}, backdrop{};
        source.r[0] = 0.8f;
        source.a[0] = 0.25f;
        blend(mode, 1, source, backdrop);
        EXPECT_FLOAT_EQ(backdrop.r[0], 0.2f) << static_cast<int>(mode); // multiplied by the opacity
        EXPECT_FLOAT_EQ(backdrop.a[0], 0.25f);
    }
}

} // namespace
} // namespace mirrorball
