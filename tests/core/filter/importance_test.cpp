#include "core/filter/importance.h"
#include "core/filter/prefilter.h"
#include "core/image/builtin_probes.h"
#include "core/image/smoothed_poles.h"
#include "core/report/error_metrics.h"
#include "support/directions.h"
#include "support/probe_builders.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace mirrorball {
namespace {

constexpr MapLayout cube{Parameterization::Cube, 12, 0};

TEST(Importance, SamplesFollowTheLobe)
{
    // Their means of cos t and of P_2 are k_1 and k_2.
    for (const Lobe& lobe :
         {phongLobe(1), phongLobe(50), phongLobe(5000), diffuseLobe(), ggxLobe(0.09), ggxLobe(1.0), tabulatedLobe({0, 1, 0, 2})}) {
        const auto samples = lobeSamples(lobe, 4096, 512);
        const auto k = legendreCoefficients(lobe, 2);
        double c = 0.0, c2 = 0.0;
        glm::dvec3 sum(0.0);
        for (const LobeSample& s : samples) {
            EXPECT_NEAR(s.x * s.x + s.y * s.y + s.z * s.z, 1.0, 1e-12);
            c += s.z / 4096.0;
            c2 += 0.5 * (3.0 * s.z * s.z - 1.0) / 4096.0;
            sum += glm::dvec3(s.x, s.y, s.z) / 4096.0;
        }
        EXPECT_NEAR((1.0 - c) / (1.0 - k[1]), 1.0, 2e-3) << describe(lobe);
        EXPECT_NEAR((1.0 - c2) / (1.0 - k[2]), 1.0, 2e-3) << describe(lobe);
        EXPECT_LE(std::hypot(sum.x, sum.y), 1e-3) << describe(lobe); // no side is favored
    }
}

TEST(Importance, RareSamplesReadCoarserLevels)
{
    const auto few = lobeSamples(phongLobe(20), 64, 512), many = lobeSamples(phongLobe(20), 4096, 512);
    EXPECT_GT(few.back().level, few.front().level);          // the rim is sampled sparsely
    EXPECT_NEAR(few[32].level - many[2048].level, 3.0, 0.3); // 64 times as many samples: cells of an eighth the width
}

TEST(Importance, ComesCloserWithEverySample)
{
    const EnvironmentMap probe = renderBuiltinProbe("studio", {Parameterization::Latlong, 128, 0});
    for (const Lobe& lobe : {phongLobe(10), phongLobe(60), ggxLobe(0.3), diffuseLobe()}) {
        FilterSource source(probe);
        PrefilterOptions options{.lobe = lobe, .target = cube, .method = Method::Reference};
        const EnvironmentMap reference = prefilter(source, options).map;
        options.method = Method::Importance;
        double before = 1.0;
        for (const int samples : {16, 256, 4096}) {
            options.knobs.samples = samples;
            const double error = errorMetrics(prefilter(source, options).map, reference).relRms;
            EXPECT_LT(error, 0.7 * before) << describe(lobe) << ' ' << samples;
            before = error;
        }
        EXPECT_LE(before, 5e-3) << describe(lobe);
    }
}

TEST(Importance, AQuarterMillionSamplesOfAConstantAreThatConstant)
{
    constexpr int samples = 1 << 18;
    const MapLayout one{Parameterization::Cube, 1, 0};
    FilterSource source(test::constantProbe(16, 0.7f));
    for (const float value :
         prefilter(source, {.lobe = phongLobe(5), .target = one, .method = Method::Importance, .knobs = {.samples = samples}})
             .map.image.texels)
        EXPECT_NEAR(value / 0.7f, 1.0f, 1e-6f);
    // What a sum in float would have made of them, with no lookup at all: far beyond the furnace's 1e-6.
    float naive = 0.0f;
    for (int i = 0; i < samples; ++i)
        naive += 0.7f;
    EXPECT_GT(std::abs(static_cast<double>(naive) / samples / static_cast<double>(0.7f) - 1.0), 1e-5);
}

TEST(Importance, LooksUpInFloatWhatTheMapSaysInDouble)
{
    // One sample of the narrowest lobe reads level 0 at r itself, which EnvironmentMap::radiance does in double.
    const EnvironmentMap probe = test::noiseProbe(64, 9);
    const LookupPyramid pyramid(probe);
    const MapLayout layout{Parameterization::Latlong, 37, 0};
    const EnvironmentMap map = importanceSample(pyramid, phongLobe(1e12), 1, layout, 0.3);
    const EnvironmentMap smooth = withInterpolatedEnergy(smoothedPoles(probe));
    for (int y = 0; y < 37; ++y)
        for (int x = 0; x < 74; ++x) {
            const glm::dvec3 r = yawed(texelDirection(layout, x, y), -0.3);
            EXPECT_NEAR(map.image.texel(x, y)[0], smooth.radiance(r).x, 1e-3); // angles to 1e-6, 20 texels a radian, steps of up to 30
        }
}

/// One texel in each row in turn: what its bilinear lookups hold over the sphere, by a midpoint rule finer than the texels, is its radiance
/// times its solid angle. Plain rows at a pole hold a twelfth more.
TEST(Importance, LookupsHoldTheEnergyOfTheTexels)
{
    constexpr int height = 8, fine = 32 * height;
    const MapLayout layout{Parameterization::Latlong, height, 0}, dense{Parameterization::Latlong, fine, 0};
    const auto energy = [&](const EnvironmentMap& map) {
        double sum = 0.0;
        for (int y = 0; y < fine; ++y)
            for (int x = 0; x < 2 * fine; ++x)
                sum += static_cast<double>(map.radiance(texelDirection(dense, x, y)).x) * texelSolidAngle(dense, x, y);
        return sum;
    };
    for (int row = 0; row < height; ++row) {
        EnvironmentMap map = test::constantProbe(height, 0.0f);
        for (int x = 0; x < 2 * height; ++x)
            map.image.texel(x, row)[0] = 1.0f;
        const double area = 2 * height * texelSolidAngle(layout, 0, row);
        EXPECT_NEAR(energy(withInterpolatedEnergy(map)) / area, 1.0, 2e-4) << row; // of the midpoint rule
        if (row == 0) {                                                            // 13/12 for small h
            const double h = pi / height, half = std::sin(0.5 * h);
            EXPECT_NEAR(energy(map) / area, 2.0 / h * half + (1.0 - 2.0 / h * half) / (1.0 - std::cos(h)), 2e-4);
        }
    }
}

TEST(Importance, DoesNotDependOnThreads)
{
    const LookupPyramid pyramid(test::noiseProbe(32, 2));
    EXPECT_EQ(importanceSample(pyramid, ggxLobe(0.2), 100, cube, 0.1, {.threads = 1}).image,
              importanceSample(pyramid, ggxLobe(0.2), 100, cube, 0.1, {.threads = 2}).image);
}

} // namespace
} // namespace mirrorball
