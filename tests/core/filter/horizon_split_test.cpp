#include "split_probes.h"

#include "core/filter/horizon_split.h"
#include "core/filter/horizon_sum.h"
#include "core/filter/near_far.h"
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

namespace mirrorball {
namespace {

using test::directions;
using test::noiseProbe;
using test::placeOf;
using test::sunny;
using test::valuesOf;

Lobe lobeOf(double exponent) { return {.kind = LobeKind::Phong, .exponent = exponent}; }

// I_s(5, 5) is the chance that of nine even numbers at least five lie below s: a sum of binomials, by definition.
TEST(HorizonSplit, ShareIsTheIncompleteBetaFunction)
{
    for (int i = 0; i <= 50; ++i) {
        const double s = i / 50.0;
        double atLeastFive = 0.0;
        for (int j = 5; j <= 9; ++j)
            atLeastFive += std::tgamma(10.0) / (std::tgamma(j + 1.0) * std::tgamma(10.0 - j)) * std::pow(s, j) * std::pow(1.0 - s, 9 - j);
        EXPECT_NEAR(HorizonSplit::nearShare(s), 1.0 - atLeastFive, 1e-14) << s;
    }
    EXPECT_EQ(HorizonSplit::nearShare(0.0), 1.0);
    EXPECT_EQ(HorizonSplit::nearShare(1.0), 0.0);
    EXPECT_EQ(HorizonSplit::nearShare(2.0), 0.0);
}

// The near part has the integral (n + 1) w^(n+1) * integral of s^n (1 - W) ds, by parts w^(n+1) * integral of s^(n+1) W' ds, W' the
// density of the beta distribution (5, 5): (n + 1) cancels, and its moment of order n + 1 is B(n + 6, 5)/B(5, 5).
TEST(HorizonSplit, PartsAddUpToOne)
{
    const auto beta = [](double a, double b) { return std::tgamma(a) * std::tgamma(b) / std::tgamma(a + b); };
    for (const double n : {0.0, 0.03, 0.5, 1.5, 3.3})
        for (const double width : {1.0, 0.2, 0.01}) {
            const double near = std::pow(width, n + 1.0) * beta(n + 6.0, 5.0) / beta(5.0, 5.0);
            EXPECT_NEAR(HorizonSplit(lobeOf(n), width).farCoefficients(64)[0], 1.0 - near, 1e-10) << n << ' ' << width;
        }
}

/// From some 30/w on, where the lobe itself goes on like l^-(n + 3/2).
TEST(HorizonSplit, FarPartHasAShortSpectrum)
{
    for (const double n : {0.05, 0.3, 0.7}) {
        const std::vector<double> far = HorizonSplit(lobeOf(n), 0.1).farCoefficients(800), whole = legendreCoefficients(lobeOf(n), 800);
        double farTail = 0.0, wholeTail = 0.0;
        for (size_t l = 300; l <= 800; ++l) {
            farTail += (2.0 * static_cast<double>(l) + 1.0) * far[l] * far[l];
            wholeTail += (2.0 * static_cast<double>(l) + 1.0) * whole[l] * whole[l];
        }
        EXPECT_LE(std::sqrt(farTail), 0.01 * std::sqrt(wholeTail)) << n;
    }
}

/// By definition, in double.
TEST(HorizonSum, IsTheSumOverTheTexelsAboveTheHorizon)
{
    for (const int height : {16, 33, 64}) {
        const EnvironmentMap probe = sunny(height);
        for (const double n : {0.0, 0.02, 0.4, 2.7})
            for (const double width : {0.004, 0.05, 0.5, 1.0}) {
                const HorizonSum near(probe, {}, HorizonSplit(lobeOf(n), width));
                for (const glm::dvec3& r : directions(40)) {
                    glm::dvec4 sum(0.0), expected(0.0), whole(0.0), unsure(0.0);
                    near.at(std::array{placeOf(r)}, 0.0, &sum);
                    for (int y = 0; y < height; ++y)
                        for (int x = 0; x < 2 * height; ++x) {
                            const double c = glm::dot(texelDirection(probe.layout, x, y), r);
                            const float* t = probe.image.texel(x, y);
                            const glm::dvec4 light =
                                texelSolidAngle(probe.layout, x, y) * (n + 1.0) / (2.0 * pi) * glm::dvec4(t[0], t[1], t[2], 1.0);
                            constexpr double rounding = 1e-15; // of c: on the horizon itself it decides whether a texel counts
                            unsure += light * (std::abs(c) < 10.0 * rounding ? 1.0 : n * std::pow(std::abs(c), n - 1.0) * rounding);
                            if (c <= 0.0 || c >= width)
                                continue;
                            whole += light * std::pow(c, n); // 1 - W is a float near 1 less one, so that its error is one of 1
                            expected += light * std::pow(c, n) * HorizonSplit::nearShare(c / width);
                        }
                    for (int c = 0; c < 4; ++c)
                        EXPECT_NEAR(sum[c], expected[c], 1e-6 * whole[c] + 1.000001 * unsure[c] + 1e-12)
                            << height << ' ' << n << ' ' << width << ' ' << r.x << ' ' << r.y << ' ' << r.z;
                }
            }
    }
}

TEST(HorizonSum, TurnsWithTheYaw)
{
    const EnvironmentMap probe = noiseProbe(48, 9);
    const HorizonSum near(probe, {}, HorizonSplit(lobeOf(0.3), 0.1));
    for (const double azimuth : {0.1, 3.0, 6.2}) {
        glm::dvec4 turned(0.0), plain(0.0);
        near.at(std::array{SpherePoint{.azimuth = azimuth, .colatitude = 1.2}}, 0.7, &turned);
        near.at(std::array{SpherePoint{.azimuth = azimuth + 0.7, .colatitude = 1.2}}, 0.0, &plain);
        EXPECT_EQ(turned, plain);
    }
}

TEST(HorizonSum, TakesTheLargestFloats)
{
    EnvironmentMap probe = noiseProbe(64, 2);
    std::fill_n(probe.image.row(20), 3 * 128, std::numeric_limits<float>::max());
    const HorizonSum near(probe, {}, HorizonSplit(lobeOf(0.1), 0.2));
    glm::dvec4 sum(0.0);
    near.at(std::array{placeOf(glm::dvec3(0, 1, 0))}, 0.0, &sum);
    near.at(std::array{placeOf(glm::normalize(glm::dvec3(1, 0.1, 0)))}, 0.0, &sum);
    EXPECT_TRUE(std::isfinite(sum.x) && sum.x > 1e35);
}

/// Split whether or not that is the cheapest for such a small map, against the sum over all texels.
TEST(HorizonSplit, KeepsItsTolerance)
{
    int kept = 0, settings = 0;
    for (const EnvironmentMap& probe : {sunny(128), noiseProbe(96, 3)})
        for (const double exponent : {0.01, 0.1, 0.37, 0.9, 2.5})
            for (const double tolerance : {1e-1, 1e-3, 1e-5})
                for (const MapLayout& target : {MapLayout{Parameterization::Cube, 7, 0}, MapLayout{Parameterization::Latlong, 9, 0}}) {
                    const PrefilterOptions options{.lobe = lobeOf(exponent), .target = target, .tolerance = tolerance, .yaw = 0.4};
                    FilterSource source(probe);
                    const SettledNearFar settled = settleNearFar(source, options);
                    ++settings;
                    if (!settled.far.keeps)
                        continue;
                    ++kept;
                    const EnvironmentMap map = filterNearFar(source, settled, options);
                    const std::vector<glm::dvec3> places = lookupDirections(target, options.yaw);
                    const test::PlainError error = test::plainError(valuesOf(map), test::plainSum(probe.image, options.lobe, places));
                    EXPECT_TRUE(error.keeps(tolerance)) << exponent << ' ' << tolerance << ": rel_rms " << error.relRms << ", median "
                                                        << error.medianRel << ", p99 " << error.p99Rel << ", least " << error.least;
                    const PredictedErrors predicted = spectralErrors(ValueDistribution::of(map), settled.far);
                    EXPECT_LE(error.relRms, predicted.relRms) << exponent << ' ' << tolerance;
                    EXPECT_LE(error.p99Rel, predicted.p99Rel) << exponent << ' ' << tolerance;
                }
    EXPECT_GE(kept, settings * 9 / 10);
}

/// The lower end of the studio's slider on a sunlit probe: no band limit keeps the promise, and a sum over all texels takes minutes.
TEST(HorizonSplit, IsWhatFiltersASunlitProbeByTheSmallestExponents)
{
    SHARED_DATA_OR_SKIP(path, "probes/kiara_1_dawn_1k.hdr");
    FilterSource source(EnvironmentMap({Parameterization::Latlong, 512, 0}, readImage(path)));
    for (const double exponent : {0.02, 0.1, 0.3}) {
        const PrefilterOptions options{.lobe = lobeOf(exponent), .target = {.kind = Parameterization::Cube, .size = 8}};
        const PrefilterOutcome outcome = prefilter(source, options);
        EXPECT_EQ(outcome.method, Method::Direct) << exponent;
        EXPECT_GT(outcome.bandLimit, 0) << exponent;
        EXPECT_TRUE(outcome.promised);
        const std::vector<glm::dvec3> places = lookupDirections(options.target, 0.0);
        const auto truth = test::plainSum(source.latlong()->image, options.lobe, places);
        EXPECT_TRUE(test::plainError(valuesOf(outcome.map), truth).keeps(options.tolerance)) << exponent;
    }
}

} // namespace
} // namespace mirrorball
