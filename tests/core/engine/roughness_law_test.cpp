#include "core/engine/roughness_law.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace mirrorball {
namespace {

constexpr std::array laws{RoughnessLaw::Linear,     RoughnessLaw::Filament, RoughnessLaw::Babylon,
                          RoughnessLaw::PlayCanvas, RoughnessLaw::Unity,    RoughnessLaw::Unreal};

class RoughnessLaws : public testing::TestWithParam<RoughnessLaw> {};

TEST_P(RoughnessLaws, GrowFromAMirrorToFullyRough)
{
    EXPECT_EQ(levelRoughness(GetParam(), 0, 9, 256), 0.0);
    EXPECT_NEAR(levelRoughness(GetParam(), 8, 9, 256), 1.0, 1e-12);
    for (int level = 1; level < 9; ++level)
        EXPECT_GE(levelRoughness(GetParam(), level, 9, 256), levelRoughness(GetParam(), level - 1, 9, 256));
}

TEST_P(RoughnessLaws, TheShadersLookupFindsEachLevelAtItsRoughness)
{
    for (int level = 1; level < 9; ++level)
        if (const double roughness = levelRoughness(GetParam(), level, 9, 256); roughness < 1.0) {
            EXPECT_NEAR(roughnessLevel(GetParam(), roughness, 9, 256), level, 1e-9);
        }
    EXPECT_EQ(roughnessLevel(GetParam(), 0.0, 9, 256), 0.0);
}

std::string lawName(const testing::TestParamInfo<RoughnessLaw>& tested) { return std::string(name(tested.param)); }
INSTANTIATE_TEST_SUITE_P(All, RoughnessLaws, testing::ValuesIn(laws), lawName);

// The figures of the engines' own sources.
TEST(RoughnessLaw, IsTheEnginesOwn)
{
    EXPECT_NEAR(levelRoughness(RoughnessLaw::Filament, 3, 5, 256), 0.5, 1e-12) << "lod = 4 r (2 - r) is 3 at one half";
    EXPECT_NEAR(std::pow(levelRoughness(RoughnessLaw::Babylon, 4, 9, 256), 2.0), 0.125, 1e-12) << "alpha = 2^(4/0.8)/256";
    EXPECT_NEAR(levelRoughness(RoughnessLaw::PlayCanvas, 2, 7, 512), 0.4, 1e-12);
    EXPECT_NEAR(roughnessLevel(RoughnessLaw::Unity, 0.5, 7, 128), 6.0 * 0.5 * (1.7 - 0.35), 1e-12);
    EXPECT_NEAR(levelRoughness(RoughnessLaw::Unreal, 6, 9, 256), 1.0, 1e-12) << "the third last level";
    EXPECT_NEAR(levelRoughness(RoughnessLaw::Linear, 1, 6, 256), 0.2, 1e-12);
}

} // namespace
} // namespace mirrorball
