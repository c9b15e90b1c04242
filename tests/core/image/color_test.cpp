#include "core/image/color.h"

#include "core/base/error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace mirrorball;

namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float notANumber = std::numeric_limits<float>::quiet_NaN();

void expectNear(const glm::dvec3& actual, const glm::dvec3& expected, double tolerance)
{
    for (int i = 0; i < 3; ++i)
        EXPECT_NEAR(actual[i], expected[i], tolerance) << "component " << i;
}

} // namespace

TEST(Color, LuminanceOfWhiteIsOne)
{
    EXPECT_DOUBLE_EQ(luminance({1, 1, 1}), 1.0);
    EXPECT_DOUBLE_EQ(luminance({0, 2, 0}), 2 * 0.7152);
}

TEST(Color, SrgbHasItsPublishedValues)
{
    EXPECT_NEAR(decodeSrgb(0.5f), 0.21404114f, 1e-7);
    EXPECT_NEAR(encodeSrgb(0.18f), 0.46135613f, 1e-6);
    EXPECT_EQ(encodeSrgb(0.0f), 0.0f);
    EXPECT_NEAR(encodeSrgb(1.0f), 1.0f, 1e-6);
    EXPECT_NEAR(encodeSrgb(0.002f), 0.02584f, 1e-7);
}

TEST(Color, SrgbRoundTripsAndIsContinuousAtTheKnee)
{
    for (int i = 0; i <= 4096; ++i) {
        const float x = static_cast<float>(i) / 4096.0f;
        EXPECT_NEAR(decodeSrgb(encodeSrgb(x)), x, 1e-6);
    }
    EXPECT_NEAR(encodeSrgb(0.0031308f), encodeSrgb(0.0031309f), 2e-6);
}

TEST(Color, EveryByteSurvivesTheRoundTrip)
{
    for (int i = 0; i < 256; ++i)
        EXPECT_EQ(toByte(encodeSrgb(decodeSrgb(static_cast<float>(i) / 255.0f))), i);
}

TEST(Color, BytesAreRoundedAndClamped)
{
    EXPECT_EQ(toByte(0.5f), 128);
    EXPECT_EQ(toByte(0.4999f / 255.0f), 0);
    EXPECT_EQ(toByte(0.5001f / 255.0f), 1);
    EXPECT_EQ(toByte(-1.0f), 0);
    EXPECT_EQ(toByte(7.0f), 255);
    EXPECT_EQ(toByte(notANumber), 0);
}

TEST(Color, ToneCurvesHaveTheirClosedForms)
{
    EXPECT_FLOAT_EQ(toneMapped(0.25f, ToneCurve::None), 0.25f);
    EXPECT_FLOAT_EQ(toneMapped(1.0f, ToneCurve::Reinhard), 0.5f);
    EXPECT_FLOAT_EQ(toneMapped(3.0f, ToneCurve::Reinhard), 0.75f);
    EXPECT_FLOAT_EQ(toneMapped(1.0f, ToneCurve::Filmic), 2.54f / 3.16f);
}

TEST(Color, ToneCurvesRiseAndStayInRangeForAnyInput)
{
    for (const ToneCurve curve : {ToneCurve::None, ToneCurve::Reinhard, ToneCurve::Filmic}) {
        float previous = 0.0f;
        for (float x = 1e-6f; x < 1e38f; x *= 1.5f) {
            const float y = toneMapped(x, curve);
            EXPECT_GE(y, previous);
            EXPECT_LE(y, 1.0f);
            previous = y;
        }
        EXPECT_EQ(toneMapped(notANumber, curve), 0.0f);
        EXPECT_EQ(toneMapped(-3.0f, curve), 0.0f);
        EXPECT_NEAR(toneMapped(infinity, curve), 1.0f, 1e-6);
        EXPECT_EQ(toneCurveFromName(name(curve)), curve);
    }
    EXPECT_FALSE(toneCurveFromName("Filmic").has_value());
}

TEST(Color, DisplayAppliesExposureThenCurveThenEncoding)
{
    Image linear(3, 1);
    linear.texels = {0.25f, notANumber, -1.0f, infinity, 0.0f, 1e30f, 0.09f, 0.09f, 0.09f};
    const Image display = toDisplay(linear, 1.0, ToneCurve::None);
    EXPECT_FLOAT_EQ(display.texels[0], encodeSrgb(0.5f));
    EXPECT_EQ(display.texels[1], 0.0f);
    EXPECT_EQ(display.texels[2], 0.0f);
    EXPECT_NEAR(display.texels[3], 1.0f, 1e-6);
    EXPECT_FLOAT_EQ(display.texels[8], encodeSrgb(0.18f));
}

TEST(Color, DisplayKeepsOpacityLinear)
{
    Image linear(1, 2, 4, 0.25f); // a white of which a quarter covers
    const Image display = toDisplay(linear, 2.0, ToneCurve::Reinhard);
    EXPECT_FLOAT_EQ(display.texel(0, 1)[0], encodeSrgb(0.8f));
    EXPECT_EQ(display.texel(0, 1)[3], 0.25f);
    EXPECT_EQ(toDisplay(Image(1, 1, 4, 0.0f), 0.0, ToneCurve::None), Image(1, 1, 4, 0.0f));
}

TEST(Color, Rec709NeedsNoConversion) { EXPECT_EQ(toRec709({}), glm::dmat3(1.0)); }

TEST(Color, WhiteGoesToWhiteWhateverThePrimaries)
{
    const Chromaticities displayP3{{0.680, 0.320}, {0.265, 0.690}, {0.150, 0.060}, {0.3127, 0.3290}};
    const Chromaticities adobeWide{{0.7347, 0.2653}, {0.1152, 0.8264}, {0.1566, 0.0177}, {0.3457, 0.3585}};
    for (const Chromaticities& c : {displayP3, adobeWide})
        expectNear(toRec709(c) * glm::dvec3(1.0), glm::dvec3(1.0), 1e-12);
}

// The matrix that OpenColorIO's ACES configurations and the color-science package publish for AP0 to linear Rec.709 with Bradford.
TEST(Color, AcesMatrixIsThePublishedOne)
{
    const Chromaticities ap0{{0.73470, 0.26530}, {0.0, 1.0}, {0.00010, -0.07700}, {0.32168, 0.33767}};
    const glm::dmat3 m = toRec709(ap0);
    expectNear({m[0][0], m[1][0], m[2][0]}, {2.52168619, -1.13413099, -0.38755520}, 2e-4);
    expectNear({m[0][1], m[1][1], m[2][1]}, {-0.27647991, 1.37271909, -0.09623917}, 2e-4);
    expectNear({m[0][2], m[1][2], m[2][2]}, {-0.01537806, -0.15297534, 1.16835340}, 2e-4);
}

// Rec.2020 has the white of Rec.709, so no adaptation enters. Source: ITU-R BT.2087-0, annex 1.
TEST(Color, Rec2020MatrixIsThePublishedOne)
{
    const glm::dmat3 m = toRec709({{0.708, 0.292}, {0.170, 0.797}, {0.131, 0.046}, {0.3127, 0.3290}});
    expectNear({m[0][0], m[1][0], m[2][0]}, {1.6605, -0.5876, -0.0728}, 1e-4);
    expectNear({m[0][1], m[1][1], m[2][1]}, {-0.1246, 1.1329, -0.0083}, 1e-4);
    expectNear({m[0][2], m[1][2], m[2][2]}, {-0.0182, -0.1006, 1.1187}, 1e-4);
}

TEST(Color, DegeneratePrimariesAreRefused)
{
    EXPECT_THROW(toRec709({{0.3, 0.3}, {0.3, 0.3}, {0.15, 0.06}, {0.3127, 0.3290}}), InvalidArgument);
    EXPECT_THROW(toRec709({{0.64, 0.33}, {0.3, 0.6}, {0.15, 0.06}, {0.3127, 0.0}}), InvalidArgument);
    EXPECT_THROW(toRec709({{std::nan(""), 0.33}, {0.3, 0.6}, {0.15, 0.06}, {0.3127, 0.329}}), InvalidArgument);
}
