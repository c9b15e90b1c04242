#include "split_probes.h"

#include "core/filter/kernel_split.h"
#include "core/filter/near_far.h"
#include "core/filter/near_sum.h"
#include "core/filter/prefilter.h"
#include "core/filter/reference.h"
#include "core/image/image_io.h"
#include "support/directions.h"
#include "support/plain_sum.h"
#include "support/probe_builders.h"
#include "support/shared_data.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace mirrorball {
namespace {

using test::constantProbe;
using test::directions;
using test::noiseProbe;
using test::placeOf;
using test::sunny;
using test::valuesOf;

/// sunny() with a sky of 1e-3 of that.
EnvironmentMap dark(int height)
{
    EnvironmentMap probe = noiseProbe(height, 6);
    for (float& value : probe.image.texels)
        value *= 1e-3f;
    std::fill_n(probe.image.texel(height, height / 2), 3, 1e2f);
    return probe;
}

// 1 - G has a zero of second order where k has its pole, z, so that the far kernel is a polynomial of the band limit's degree. At the
// lobe's axis, which is 2 alpha^2 from there, G is 1 but for what that leaves: half of G'' times the square, G'' ~ (band limit/reach)^2.
TEST(KernelSplit, FallsFromOneToWhatItLeavesOut)
{
    for (const double alpha : {0.003, 0.01, 0.02})
        for (const double leftOut : {1e-3, 1e-5, 1e-7}) {
            const KernelSplit split(ggxLobe(alpha), 192, leftOut);
            ASSERT_TRUE(split.hasReach());
            EXPECT_LE(split.leftOut(), leftOut * 1.001);
            const double beyond = 2.0 * alpha * alpha / (1.0 - alpha * alpha);
            EXPECT_NEAR(split.share(-beyond), 1.0, 1e-9); // z = 1 + beyond
            EXPECT_NEAR(split.share(-beyond + 1e-9), split.share(-beyond - 1e-9), 1e-9);
            double before = 1.0 + 1e-9;
            for (int i = 0; i <= 100; ++i) {
                const double share = split.share(0.9 * split.reach() * i / 100.0);
                EXPECT_LE(share, before); // it falls
                before = share;
            }
            for (int i = 0; i <= 1000; ++i)
                EXPECT_LE(std::abs(split.share(split.reach() + (2.0 - split.reach()) * i / 1000.0)), leftOut * 1.001);
        }
}

TEST(KernelSplit, NeedsNoReachWhereTheLobesOwnSpectrumIsShort)
{
    // k_l falls like exp(-2 alpha l): at 256 degrees and alpha 0.1 it is at e^-51.
    EXPECT_FALSE(KernelSplit(ggxLobe(0.1), 256, 1e-6).hasReach());
    EXPECT_TRUE(KernelSplit(ggxLobe(0.01), 256, 1e-6).hasReach());
}

TEST(KernelSplit, PolynomialIsTheShare)
{
    for (const double leftOut : {1e-1, 1e-4, 1e-7}) {
        const KernelSplit split(ggxLobe(0.004), 256, leftOut);
        const std::vector<double> powers = split.sharePolynomial();
        for (int i = 0; i <= 200; ++i) {
            const double x = 1.0 - i / 100.0;
            double value = 0.0;
            for (size_t j = powers.size(); j-- > 0;)
                value = value * x + powers[j];
            EXPECT_NEAR(value, split.share(0.5 * split.reach() * (1.0 - x)), std::max(2e-8, KernelSplit::polynomialShare * leftOut))
                << leftOut << ' ' << x;
        }
    }
}

TEST(KernelSplit, FarCoefficientsAndNearShareAddUpToTheLobe)
{
    for (const double alpha : {0.003, 0.01, 0.03}) {
        const KernelSplit split(ggxLobe(alpha), 192, 1e-5);
        const std::vector<double> far = split.farCoefficients(192);
        EXPECT_LE(largestMiss(split, far), 1e-5 + 2e-6) << alpha; // the rest is the kink at the horizon
        // Integral of the near part by the midpoint rule in u, and of the far one: 1.
        const LobeShape shape(split.lobe());
        double near = 0.0;
        constexpr int steps = 200000;
        for (int i = 0; i < steps; ++i) {
            const double u = split.reach() * (i + 0.5) / steps;
            near += 2.0 * pi * split.reach() / steps * shape.relative(1.0 - u) / shape.integral() * split.share(u);
        }
        EXPECT_NEAR(near + far[0], 1.0, 2e-5) << alpha;
    }
}

TEST(KernelSplit, AWrongCoefficientIsSeen)
{
    const KernelSplit split(ggxLobe(0.01), 192, 1e-5);
    const std::vector<double> far = split.farCoefficients(192);
    for (const size_t l : {0u, 3u, 40u, 120u}) {
        std::vector<double> wrong = far;
        wrong[l] *= 1.01;
        EXPECT_GE(largestMiss(split, wrong), 3e-5) << l;
    }
}

/// By definition, in double.
TEST(NearSum, IsTheSumOverTheTexelsWithinTheReach)
{
    for (const int height : {16, 33, 64}) {
        const EnvironmentMap probe = sunny(height);
        for (const auto& [alpha, bandLimit, leftOut] :
             {std::tuple(0.02, 64, 1e-3), std::tuple(0.05, 64, 1e-3), std::tuple(0.004, 128, 1e-3), std::tuple(0.004, 128, 1e-6)}) {
            const KernelSplit split(ggxLobe(alpha), bandLimit, leftOut);
            const double relative = 2e-6 + KernelSplit::polynomialShare * leftOut;
            const LobeShape shape(split.lobe());
            const NearSum near(probe, {}, split);
            for (const glm::dvec3& r : directions(60)) {
                glm::dvec4 sum(0.0), expected(0.0);
                near.at(std::array{placeOf(r)}, 0.0, &sum);
                for (int y = 0; y < height; ++y)
                    for (int x = 0; x < 2 * height; ++x) {
                        const glm::dvec3 apart = texelDirection(probe.layout, x, y) - r;
                        const double u = 0.5 * glm::dot(apart, apart);
                        if (u >= split.reach())
                            continue;
                        const double weight =
                            texelSolidAngle(probe.layout, x, y) * shape.relative(1.0 - u) / shape.integral() * split.share(u);
                        const float* t = probe.image.texel(x, y);
                        expected += weight * glm::dvec4(t[0], t[1], t[2], 1.0);
                    }
                for (int c = 0; c < 4; ++c) // what lies at the reach itself counts for leftOut of k at most, and may count or not
                    EXPECT_NEAR(sum[c], expected[c], relative * std::abs(expected[c]) + (c < 3 ? 1e5 : 1.0) * 1e-8)
                        << height << ' ' << alpha;
            }
        }
    }
}

struct Errors {
    PrefilterOutcome outcome;
    test::PlainError measured;
};

Errors against(const EnvironmentMap& probe, const PrefilterOptions& options)
{
    FilterSource source(probe);
    Errors errors{.outcome = prefilter(source, options), .measured = {}};
    const std::vector<glm::dvec3> directions = lookupDirections(options.target, options.yaw);
    errors.measured = test::plainError(valuesOf(errors.outcome.map), test::plainSum(probe.image, options.lobe, directions));
    return errors;
}

bool wasSplit(const PrefilterOutcome& outcome) { return outcome.method == Method::Direct && outcome.bandLimit > 0; }

/// Filtered by near and far whether or not that is the cheapest for such a small map.
TEST(NearFar, KeepsItsTolerance)
{
    int kept = 0, settings = 0;
    for (const EnvironmentMap& probe : {sunny(128), dark(128)})
        for (const double alpha : {0.003, 0.01, 0.05}) // also where auto would look the probe up: the sum is as good
            for (const double tolerance : {1e-3, 1e-4, 1e-5, 1e-6})
                for (const MapLayout& target : {MapLayout{Parameterization::Cube, 7, 0}, MapLayout{Parameterization::Octahedral, 9, 0}}) {
                    const PrefilterOptions options{.lobe = ggxLobe(alpha), .target = target, .tolerance = tolerance, .yaw = 0.4};
                    FilterSource source(probe);
                    const SettledNearFar settled = settleNearFar(source, options);
                    ++settings;
                    if (!settled.far.keeps)
                        continue;
                    ++kept;
                    const EnvironmentMap map = filterNearFar(source, settled, options);
                    const std::vector<glm::dvec3> places = lookupDirections(target, options.yaw);
                    const test::PlainError error = test::plainError(valuesOf(map), test::plainSum(probe.image, options.lobe, places));
                    EXPECT_TRUE(error.keeps(tolerance)) << alpha << ' ' << tolerance << ": rel_rms " << error.relRms << ", median "
                                                        << error.medianRel << ", p99 " << error.p99Rel << ", least " << error.least;
                    const PredictedErrors predicted = spectralErrors(ValueDistribution::of(map), settled.far);
                    EXPECT_LE(error.relRms, predicted.relRms) << alpha << ' ' << tolerance;
                    EXPECT_LE(error.medianRel, predicted.medianRel) << alpha << ' ' << tolerance;
                    EXPECT_LE(error.p99Rel, predicted.p99Rel) << alpha << ' ' << tolerance;
                }
    EXPECT_GE(kept, settings / 2); // at 1e-6 the rounding of floats, at alpha 0.05 the kink at the horizon leave little
}

/// A lobe of 0.02 on a probe of 256 x 128 and a map of some size: near and far are cheaper than all texels under the tail.
TEST(NearFar, IsWhatDirectDoesWithALongTail)
{
    const PrefilterOptions options{
        .lobe = ggxLobe(0.02), .target = {Parameterization::Cube, 32, 0}, .method = Method::Direct, .tolerance = 1e-4};
    const Errors errors = against(noiseProbe(128, 3), options);
    EXPECT_TRUE(wasSplit(errors.outcome)) << errors.outcome.why;
    EXPECT_TRUE(errors.outcome.promised);
    EXPECT_TRUE(errors.measured.keeps(options.tolerance));
    EXPECT_LE(errors.measured.relRms, errors.outcome.predicted.relRms);
}

/// In a black room the back of a window is black: no absolute error is small beside it. The sum over all texels is left, and keeps it.
TEST(NearFar, GivesWayWhereTheKinkAtTheHorizonWouldBeSeen)
{
    EnvironmentMap probe = constantProbe(64, 0.0f);
    for (int y = 20; y < 36; ++y) // more texels than are taken out one by one
        for (int x = 20; x < 36; ++x)
            std::fill_n(probe.image.texel(x, y), 3, 100.0f + static_cast<float>(x));
    const PrefilterOptions options{
        .lobe = ggxLobe(0.05), .target = {Parameterization::Cube, 24, 0}, .method = Method::Direct, .tolerance = 1e-5};
    const Errors errors = against(probe, options);
    EXPECT_FALSE(wasSplit(errors.outcome));
    EXPECT_TRUE(errors.outcome.promised);
    EXPECT_TRUE(errors.measured.keeps(options.tolerance));
}

/// The sun itself is exact, and so is the black behind it.
TEST(NearFar, KeepsTheBlackBehindASun)
{
    EnvironmentMap probe = constantProbe(64, 0.0f);
    std::fill_n(probe.image.texel(20, 30), 3, 1e5f);
    const PrefilterOptions options{
        .lobe = ggxLobe(0.05), .target = {Parameterization::Cube, 24, 0}, .method = Method::Direct, .tolerance = 1e-5};
    const Errors errors = against(probe, options);
    EXPECT_TRUE(wasSplit(errors.outcome));
    EXPECT_TRUE(errors.measured.keeps(options.tolerance));
}

TEST(NearFar, KeepsAConstant)
{
    FilterSource source(constantProbe(96));
    for (const double alpha : {0.02, 0.03})
        for (const MapLayout& target : {MapLayout{Parameterization::Cube, 8, 0}, MapLayout{Parameterization::Latlong, 16, 0}}) {
            const PrefilterOptions options{.lobe = ggxLobe(alpha), .target = target};
            const SettledNearFar settled = settleNearFar(source, options);
            ASSERT_TRUE(settled.near);
            for (const float value : filterNearFar(source, settled, options).image.texels)
                ASSERT_NEAR(value, 1.0f, 1e-6f) << alpha;
        }
}

TEST(NearFar, DoesNotDependOnThreads)
{
    const PrefilterOptions options{.lobe = ggxLobe(0.02), .target = {Parameterization::Cube, 9, 0}, .tolerance = 1e-4};
    const auto filtered = [&](int threads) {
        FilterSource source(sunny(128));
        return filterNearFar(source, settleNearFar(source, options, {.threads = threads}), options, {.threads = threads}).image;
    };
    EXPECT_EQ(filtered(1), filtered(2));
}

TEST(NearFar, TakesTheLargestFloats)
{
    EnvironmentMap probe = noiseProbe(64, 2);
    probe.image.texel(3, 20)[0] = std::numeric_limits<float>::max();
    FilterSource source(probe);
    const KernelSplit split(ggxLobe(0.05), 64, 1e-3);
    const NearSum near(probe, {}, split);
    glm::dvec4 sum(0.0);
    near.at(std::array{placeOf(texelDirection(probe.layout, 3, 20))}, 0.0, &sum);
    EXPECT_TRUE(std::isfinite(sum.x) && sum.x > 1e36);
}

// Lamps of 3351 make the split give way at this tolerance; what is left of direct is a sum over all texels, four minutes of it, while the
// spectrum keeps the promise in a second.
TEST(NearFar, LeavesItToTheSpectrumWhereItGivesWay)
{
    SHARED_DATA_OR_SKIP(path, "probes/studio_small_03_1k.hdr");
    FilterSource source(EnvironmentMap({Parameterization::Latlong, 512, 0}, readImage(path)));
    const PrefilterOutcome outcome =
        prefilter(source, {.lobe = ggxLobe(0.0179492), .target = {.kind = Parameterization::Cube, .size = 128}, .tolerance = 1e-4});
    EXPECT_TRUE(outcome.promised);
    for (const Stage& stage : outcome.stages)
        EXPECT_NE(stage.name, "direct sum");
}

} // namespace
} // namespace mirrorball
