#include "core/base/error.h"
#include "core/filter/prefilter.h"
#include "core/filter/sh9.h"
#include "core/report/error_metrics.h"
#include "support/probe_builders.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace mirrorball {
namespace {

constexpr MapLayout cube{Parameterization::Cube, 16, 0};

double quadratic(const glm::dvec3& d, double k1, double k2)
{
    // x^2 - 1/3, y^2 - 1/3 and the products are harmonics of degree 2, the coordinates of degree 1.
    return 1.0 + k1 * (0.3 * d.x - 0.2 * d.y + 0.1 * d.z) +
           k2 * (0.25 * (d.x * d.x - 1.0 / 3.0) - 0.35 * (d.y * d.y - 1.0 / 3.0) + 0.15 * d.x * d.y - 0.4 * d.y * d.z + 0.2 * d.x * d.z);
}

TEST(Sh9, IsExactForQuadraticsOfTheDirection)
{
    // Ramamoorthi and Hanrahan: degree 1 is scaled by 2/3, degree 2 by 1/4. Errors are the quadrature's, (pi/256)^2/24.
    EnvironmentMap probe(MapLayout{Parameterization::Latlong, 256, 0});
    for (int y = 0; y < 256; ++y)
        for (int x = 0; x < 512; ++x)
            for (int c = 0; c < 3; ++c)
                probe.image.texel(x, y)[c] = static_cast<float>(quadratic(texelDirection(probe.layout, x, y), 1.0, 1.0));
    const double yaw = 0.6;
    const EnvironmentMap map = filterSh9(analyze(probe, 2), cube, yaw);
    for (int y = 0; y < map.image.height; ++y)
        for (int x = 0; x < map.image.width; ++x)
            ASSERT_NEAR(map.image.texel(x, y)[1], quadratic(yawed(texelDirection(cube, x, y), -yaw), 2.0 / 3.0, 0.25), 2e-5);
}

TEST(Sh9, MissesWhatItsSpectrumSaysItMisses)
{
    for (const EnvironmentMap& probe : {test::noiseProbe(64, 3), test::sunProbe(64, 1e6f, 20, 17)}) {
        FilterSource source(probe);
        PrefilterOptions options{.lobe = diffuseLobe(), .target = cube, .method = Method::Sh9};
        const PrefilterOutcome outcome = prefilter(source, options);
        options.method = Method::Reference;
        const double error = errorMetrics(outcome.map, prefilter(source, options).map).relRms;
        EXPECT_NEAR(outcome.predicted.relRms / error, 1.0, 0.1);
    }
}

TEST(Sh9, OneSunIsOffByNearlyNinePercentAndDipsByLessThanFour)
{
    // sqrt(sum over l > 2 of (2l+1) k_l^2 / sum over all) = 0.0885, and the kernel's least value over its greatest is -0.158/4.25.
    EnvironmentMap black = test::constantProbe(64, 0.0f);
    black.image.texel(30, 25)[0] = 1000.0f;
    FilterSource source(black);
    PrefilterOptions options{.lobe = diffuseLobe(), .target = cube, .method = Method::Sh9};
    const EnvironmentMap map = prefilter(source, options).map;
    options.method = Method::Reference;
    const EnvironmentMap reference = prefilter(source, options).map;
    EXPECT_NEAR(errorMetrics(map, reference).relRms, 0.0885, 2e-3);
    const auto [low, high] = std::minmax_element(map.image.texels.begin(), map.image.texels.end());
    EXPECT_NEAR(*low / *high, -0.158 / 4.25, 2e-3);
}

TEST(Sh9, RefusesOtherLobesByName)
{
    FilterSource source(test::noiseProbe(16, 3));
    try {
        prefilter(source, {.lobe = phongLobe(50), .target = cube, .method = Method::Sh9});
        ADD_FAILURE() << "did not refuse";
    } catch (const InvalidArgument& e) {
        EXPECT_NE(std::string(e.what()).find("sh9"), std::string::npos);
        EXPECT_NE(std::string(e.what()).find("lobe"), std::string::npos);
    }
}

TEST(Sh9, RunsOnAStreamedProbe)
{
    const EnvironmentMap probe = test::noiseProbe(64, 13);
    FilterSource streamed(analyze(probe, 24)), whole(probe);
    const PrefilterOptions options{.lobe = diffuseLobe(), .target = cube, .method = Method::Sh9};
    EXPECT_LE(errorMetrics(prefilter(streamed, options).map, prefilter(whole, options).map).relRms, 1e-6);
}

} // namespace
} // namespace mirrorball
