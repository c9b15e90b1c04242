#include "core/report/picture_error.h"

#include "core/base/error.h"

#include <gtest/gtest.h>

#include <cmath>

namespace mirrorball {
namespace {

/// Gray values of a function of the column.
template <typename Value>
Image gray(int width, int height, Value value)
{
    Image image(width, height, 3);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (int c = 0; c < 3; ++c)
                image.texel(x, y)[c] = static_cast<float>(value(x));
    return image;
}

Image flat(double value)
{
    return gray(40, 30, [&](int) { return value; });
}

Image noise(unsigned seed, float reach)
{
    Image image(64, 48, 4, 1.0f);
    for (size_t i = 0; i < image.texels.size(); ++i) {
        seed = seed * 1664525u + 1013904223u;
        if (i % 4 != 3)
            image.texels[i] = reach * static_cast<float>(seed >> 8) / 16777216.0f;
    }
    return image;
}

constexpr double c1 = 1e-4, c2 = 9e-4;

TEST(PictureError, EqualPicturesHaveNone)
{
    const Image picture = noise(7, 1.0f);
    const PictureError error = pictureError(picture, picture);
    EXPECT_EQ(error.relRms, 0.0);
    EXPECT_EQ(error.psnr, HUGE_VAL);
    EXPECT_NEAR(error.ssim, 1.0, 1e-12);
    EXPECT_EQ(pictureError(flat(0.0), flat(0.0)).relRms, 0.0); // black, too
}

// mean (E - R)^2 = d^2, so PSNR = -20 log10 d; rms(E - R) / rms(R) = d / R.
TEST(PictureError, OfAKnownOffsetIsItsClosedForm)
{
    for (const double offset : {0.1, 0.01, -0.25}) {
        const PictureError error = pictureError(flat(0.5 + offset), flat(0.5));
        EXPECT_NEAR(error.psnr, -20.0 * std::log10(std::abs(offset)), 1e-5) << offset; // a float holds 0.6 to 2e-8
        EXPECT_NEAR(error.relRms, std::abs(offset) / 0.5, 1e-6) << offset;
    }
    EXPECT_NEAR(pictureError(flat(0.6), flat(0.5)).psnr, 20.0, 1e-5);
    EXPECT_NEAR(pictureError(flat(1.0), flat(0.0)).psnr, 0.0, 1e-12); // the whole range
    EXPECT_EQ(pictureError(flat(1.0), flat(0.0)).relRms, HUGE_VAL);
}

// Without variance only the luminance term is left: (2 m (m + d) + C1) / (m^2 + (m + d)^2 + C1).
TEST(PictureError, TheSimilarityOfAConstantShiftIsItsLuminanceTerm)
{
    for (const double shift : {0.2, 0.05, -0.3}) {
        const double m = 0.4, e = m + shift;
        EXPECT_NEAR(pictureError(flat(e), flat(m)).ssim, (2.0 * m * e + c1) / (m * m + e * e + c1), 1e-6) << shift;
    }
}

// Of a ramp of slope s the mean under the window is the value at its middle, the variance s^2 sum w i^2; of the ramp turned over (1 - R)
// the covariance is minus that. So the similarity is known column by column.
TEST(PictureError, TheSimilarityOfARampTurnedOverIsItsClosedForm)
{
    const int width = 60;
    const double slope = 1.0 / width;
    double weights = 0.0, moment = 0.0;
    for (int i = -5; i <= 5; ++i) {
        const double w = std::exp(-0.5 * i * i / (1.5 * 1.5));
        weights += w;
        moment += w * i * i;
    }
    const double variance = slope * slope * moment / weights;
    double expected = 0.0;
    for (int x = 5; x < width - 5; ++x) {
        const double m = slope * x, e = 1.0 - m;
        expected += (2.0 * m * e + c1) * (c2 - 2.0 * variance) / ((m * m + e * e + c1) * (2.0 * variance + c2)) / (width - 10);
    }
    const PictureError error =
        pictureError(gray(width, 20, [&](int x) { return 1.0 - slope * x; }), gray(width, 20, [&](int x) { return slope * x; }));
    EXPECT_NEAR(error.ssim, expected, 1e-5); // floats of about 1 hold a variance of 6e-4 to 1e-7
}

TEST(PictureError, DoesNotDependOnThreadsNorOnWhichIsTheReferenceWhereItIsSymmetric)
{
    const Image a = noise(1, 1.0f), b = noise(2, 0.7f);
    const PictureError one = pictureError(a, b, {.threads = 1});
    EXPECT_EQ(one, pictureError(a, b, {.threads = 4}));
    const PictureError turned = pictureError(b, a);
    EXPECT_DOUBLE_EQ(one.psnr, turned.psnr);
    EXPECT_DOUBLE_EQ(one.ssim, turned.ssim);
    EXPECT_LT(one.ssim, 0.5);
}

TEST(PictureError, OpacityIsNotLookedAt)
{
    const Image picture = noise(3, 1.0f);
    Image thin = picture;
    for (size_t i = 3; i < thin.texels.size(); i += 4)
        thin.texels[i] = 0.5f;
    EXPECT_EQ(pictureError(thin, picture).relRms, 0.0);
}

TEST(PictureError, RefusesWhatCannotBeCompared)
{
    EXPECT_THROW(pictureError(Image(20, 20, 3), Image(20, 21, 3)), InvalidArgument);
    EXPECT_THROW(pictureError(Image(20, 20, 1), Image(20, 20, 1)), InvalidArgument);
    EXPECT_THROW(pictureError(Image(10, 20, 3), Image(10, 20, 3)), InvalidArgument);
    EXPECT_NO_THROW(pictureError(Image(11, 11, 3), Image(11, 11, 3)));
}

} // namespace
} // namespace mirrorball
