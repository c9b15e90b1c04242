#include "core/image/container/packed_texel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace mirrorball {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN(), infinity = std::numeric_limits<float>::infinity();

TEST(PackedTexel, HalvesAreThoseOfIeee754)
{
    EXPECT_EQ(packHalf(1.0f), 0x3c00);
    EXPECT_EQ(packHalf(-2.0f), 0xc000);
    EXPECT_EQ(packHalf(1e9f), 0x7bff) << "clamped to 65504, not infinite";
    EXPECT_EQ(packHalf(-infinity), 0xfbff);
    EXPECT_EQ(packHalf(nan), 0);
    EXPECT_EQ(unpackHalf(0x3555), 0x1.554p-2f) << "the half nearest to a third";
}

// Data Format 1.3, 10.3: 1.0 is exponent 15, mantissa 0; 65024 = 2^15 (1 + 63/64) the largest; 2^-20 the smallest.
TEST(PackedTexel, ElevenAndTenBitFloatsAreThoseOfTheSpecification)
{
    EXPECT_EQ(packR11G11B10({1.0f, 0.0f, 0.0f}), 15u << 6);
    EXPECT_EQ(packR11G11B10({0.0f, 1.0f, 0.0f}), 15u << 6 << 11);
    EXPECT_EQ(packR11G11B10({0.0f, 0.0f, 1.0f}), 15u << 5 << 22);
    EXPECT_EQ(packR11G11B10({0x1p-20f, 0.0f, 0.0f}), 1u);
    EXPECT_EQ(unpackR11G11B10(packR11G11B10({1e9f, infinity, 1e9f})), glm::vec3(65024.0f, 65024.0f, 64512.0f));
    EXPECT_EQ(packR11G11B10({-1.0f, nan, -infinity}), 0u);
}

TEST(PackedTexel, SmallFloatsAreTheNearestOnes)
{
    for (float value = 0x1p-13f; value < 60000.0f; value *= 1.0137f) {
        const glm::vec3 back = unpackR11G11B10(packR11G11B10(glm::vec3(value)));
        EXPECT_NEAR(back.r, value, value * 0x1p-7f * 1.0001f) << "half of the last of 6 bits";
        EXPECT_NEAR(back.b, value, value * 0x1p-6f * 1.0001f) << "half of the last of 5 bits";
    }
    for (std::uint32_t bits = 0; bits < 31u << 6; ++bits) // all finite ones come back as they are
        EXPECT_EQ(packR11G11B10({unpackR11G11B10(bits).r, 0.0f, 0.0f}), bits);
}

// EXT_texture_shared_exponent: the largest value is 511/512 2^16; 1.0 alone has the mantissa 256 and the exponent 1 + 15.
TEST(PackedTexel, SharedExponentsAreThoseOfTheExtension)
{
    EXPECT_EQ(packE5B9G9R9({1.0f, 0.0f, 0.0f}), 16u << 27 | 256u);
    EXPECT_EQ(unpackE5B9G9R9(packE5B9G9R9({1e9f, 0.0f, 0.0f})).r, 65408.0f);
    EXPECT_EQ(packE5B9G9R9({nan, -1.0f, 0.0f}) & 0x7ffffffu, 0u);
    for (float value = 1e-4f; value < 60000.0f; value *= 1.0137f) {
        const glm::vec3 back = unpackE5B9G9R9(packE5B9G9R9({value, 0.3f * value, 0.0f}));
        EXPECT_NEAR(back.r, value, value * 0x1p-9f * 1.0001f);
        EXPECT_NEAR(back.g, 0.3f * value, value * 0x1p-9f * 1.0001f) << "as coarse as the brightest channel's";
    }
}

struct ColorCase {
    PackedColor form;
    float lowest, highest; ///< where the bound holds
    float relative;        ///< of the brightest channel
};

// Steps of 1/255 in the encoded root: 2.2 (RGBD) or 2 (RGBM, RGBP) half steps relative to a root of at least 1/2 of the range; RGBE rounds
// to 1/256 of an octave. RGBD's multiplier is a whole number, so near the top the byte alone resolves 1/2 of the range and less.
class PackedColors : public testing::TestWithParam<ColorCase> {};

TEST_P(PackedColors, ComeBackWithinTheirSteps)
{
    const ColorCase c = GetParam();
    for (float value = c.lowest; value <= c.highest; value *= 1.0137f) {
        const glm::vec3 back = unpackColor(c.form, packColor(c.form, {value, 0.5f * value, 0.0f}));
        EXPECT_NEAR(back.r, value, c.relative * value);
        EXPECT_NEAR(back.g, 0.5f * value, c.relative * value);
        EXPECT_EQ(back.b, 0.0f);
    }
}

TEST_P(PackedColors, ClampToTheirRangeAndTakeAnyNumber)
{
    const PackedColor form = GetParam().form;
    const float largest = largestValue(form);
    EXPECT_NEAR(unpackColor(form, packColor(form, glm::vec3(infinity))).g / largest, 1.0f, 1e-3f);
    EXPECT_EQ(unpackColor(form, packColor(form, {nan, -1.0f, -infinity})), glm::vec3(0.0f));
}

// Babylon.js' shader decodes byte^2.2: the byte is the power's, rounded, whatever finds it.
TEST(PackedColor, RgbdRoundsThePowerItself)
{
    for (float v = 1e-9f; v <= 255.0f; v *= 1.00037f) {
        const float multiplier = std::clamp(std::floor(255.0f / v), 1.0f, 255.0f);
        const float half = 0.5f * v * multiplier / 255.0f, whole = std::min(v * multiplier / 255.0f, 1.0f);
        const Rgba8 texel = packColor(PackedColor::Rgbd, {v, 0.5f * v, 0.0f});
        EXPECT_EQ(texel, (Rgba8{static_cast<std::uint8_t>(std::lround(255.0f * std::pow(whole, 1.0f / 2.2f))),
                                static_cast<std::uint8_t>(std::lround(255.0f * std::pow(half, 1.0f / 2.2f))), 0,
                                static_cast<std::uint8_t>(multiplier)}))
            << v;
    }
}

INSTANTIATE_TEST_SUITE_P(Forms, PackedColors,
                         testing::Values(ColorCase{PackedColor::Rgbe, 1e-6f, 1e6f, 0x1p-8f * 1.001f},
                                         ColorCase{PackedColor::Rgbm, 1e-2f, 64.0f, 0.012f},
                                         ColorCase{PackedColor::Rgbd, 0.1f, 255.0f, 0.012f},
                                         ColorCase{PackedColor::Rgbp, 0.1f, 64.0f, 0.014f}));

} // namespace
} // namespace mirrorball
