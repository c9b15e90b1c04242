#include "core/filter/mip_blur.h"
#include "core/filter/prefilter.h"
#include "core/report/seam_ratio.h"
#include "support/probe_builders.h"

#include <gtest/gtest.h>

#include <cmath>

namespace mirrorball {
namespace {

/// L = 1 + d.y/2 is a harmonic of degree 1: any radial blur scales its slope by k_1.
EnvironmentMap gradient(const MapLayout& layout)
{
    EnvironmentMap map(layout);
    for (int y = 0; y < map.image.height; ++y)
        for (int x = 0; x < map.image.width; ++x)
            for (int c = 0; c < 3; ++c)
                map.image.texel(x, y)[c] = static_cast<float>(1.0 + 0.5 * texelDirection(layout, x, y).y);
    return map;
}

/// k_1 of what was done to gradient(): the projection on d.y.
double slopeKept(const EnvironmentMap& map)
{
    double product = 0.0, square = 0.0;
    for (int y = 0; y < map.image.height; ++y)
        for (int x = 0; x < map.image.width; ++x) {
            const double w = texelSolidAngle(map.layout, x, y), dy = texelDirection(map.layout, x, y).y;
            product += w * dy * (static_cast<double>(map.image.texel(x, y)[0]) - 1.0);
            square += w * dy * dy;
        }
    return product / square / 0.5;
}

constexpr MapLayout cube64{Parameterization::Cube, 64, 0};

TEST(MipBlur, IsAsWideAsItsVarianceSays)
{
    const MipPyramid pyramid = blurPyramid(gradient(cube64), MipFiltering::AcrossSeams);
    double seen = 0.0; // the texels' solid angle, averaged over directions
    for (int y = 0; y < 64 * 6; ++y)
        for (int x = 0; x < 64; ++x)
            seen += std::pow(texelSolidAngle(cube64, x, y), 2) / (4.0 * pi);
    const double h2 = seen;
    for (const double lambda : {2.0, 3.0, 3.5, 4.0, 5.0}) {
        const double lost = 1.0 - slopeKept(mipBlur(pyramid, MipFiltering::AcrossSeams, lambda, cube64, 0.0));
        EXPECT_NEAR(lost / (1.0 - std::exp(-blurVariance(lambda, h2))), 1.0, 0.1) << lambda; // coarse levels exchange around corners too
    }
}

TEST(MipBlur, MatchedLambdaIsAsWideAsTheLobe)
{
    // Phong keeps (n+1)/(n+2) of a gradient.
    const MipPyramid pyramid = blurPyramid(gradient(cube64), MipFiltering::AcrossSeams);
    for (const double n : {3.0, 10.0, 50.0, 200.0}) {
        const double lambda = matchedLambda(phongLobe(n), cube64);
        const double lost = 1.0 - slopeKept(mipBlur(pyramid, MipFiltering::AcrossSeams, lambda, cube64, 0.0));
        EXPECT_NEAR(lost * (n + 2.0), 1.0, 0.1) << n;
    }
}

TEST(MipBlur, LambdaAndExponentAreEachOthersInverse)
{
    for (const double n : {0.5, 1.0, 10.0, 50.0, 500.0, 2000.0})
        EXPECT_NEAR(matchedExponent(matchedLambda(phongLobe(n), cube64), cube64) / n, 1.0, 1e-9) << n;
    EXPECT_EQ(matchedLambda(phongLobe(1e9), cube64), 0.0);
    EXPECT_EQ(matchedLambda(ggxLobe(0.0), cube64), 0.0);
    for (const double level : {0.0, 0.3, 1.0, 2.75, 6.0})
        EXPECT_NEAR(levelForVariance(blurVariance(level, 0.01), 0.01), level, 1e-12);
}

TEST(MipBlur, PerFaceFilteringShowsSeamsThatConsistentFilteringDoesNot)
{
    FilterSource source(test::noiseProbe(128, 4));
    const auto ratio = [&](MipFiltering filtering, double lambda) {
        return seamSteps(
                   prefilter(source, {.target = cube64, .method = Method::Mip, .knobs = {.lambda = lambda, .mipFiltering = filtering}}).map)
            .ratio();
    };
    for (const double lambda : {2.0, 3.0, 4.0}) {
        const double consistent = ratio(MipFiltering::AcrossSeams, lambda), perFace = ratio(MipFiltering::PerFace, lambda);
        EXPECT_LT(consistent, 1.5) << lambda;
        EXPECT_GT(perFace, 2.0 * consistent) << lambda;
    }
}

TEST(MipBlur, LambdaPastTheLastLevelIsTheLastLevel)
{
    const MipPyramid pyramid = blurPyramid(gradient(cube64), MipFiltering::AcrossSeams);
    for (const MipFiltering filtering : {MipFiltering::AcrossSeams, MipFiltering::PerFace})
        EXPECT_EQ(mipBlur(pyramid, filtering, 6.0, cube64, 0.0).image, mipBlur(pyramid, filtering, 32.0, cube64, 0.0).image);
}

TEST(MipBlur, SmallTargetsReadTheLevelOfTheirOwnTexels)
{
    // Lambda is a least level: a target of 4 texels a face reads level 4 of 64 even without one.
    const MipPyramid pyramid = blurPyramid(gradient(cube64), MipFiltering::AcrossSeams);
    const MapLayout small{Parameterization::Cube, 4, 0};
    EXPECT_EQ(mipBlur(pyramid, MipFiltering::AcrossSeams, 0.0, small, 0.0).image,
              mipBlur(pyramid, MipFiltering::AcrossSeams, 2.0, small, 0.0).image);
}

TEST(MipBlur, AnExplicitLambdaNeedsNoLobe)
{
    FilterSource source(test::noiseProbe(64, 4));
    const PrefilterOptions options{
        .lobe = ggxLobe(0.0), .target = {Parameterization::Cube, 16, 0}, .method = Method::Mip, .knobs = {.lambda = 3.0}};
    const PrefilterOutcome outcome = prefilter(source, options);
    EXPECT_TRUE(outcome.filtered);
    EXPECT_EQ(outcome.method, Method::Mip);
}

} // namespace
} // namespace mirrorball
