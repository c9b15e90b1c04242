#include "core/report/reference_samples.h"

#include "core/filter/prefilter.h"
#include "support/probe_builders.h"

#include <gtest/gtest.h>

#include <cmath>

namespace mirrorball {
namespace {

const MapLayout cube16{Parameterization::Cube, 16, 0};

TEST(EvenDirections, IntegrateSphericalHarmonicsOfLowDegreeToZero)
{
    // Equal weights on an even lattice: means of x, y z, x^2 - 1/3 and x^4 - 1/5 over the sphere are 0.
    glm::dvec4 means(0.0);
    const auto directions = evenDirections(1000);
    for (const glm::dvec3& d : directions) {
        EXPECT_NEAR(glm::length(d), 1.0, 1e-14);
        means += glm::dvec4(d.x, d.y * d.z, d.x * d.x - 1.0 / 3, std::pow(d.x, 4) - 0.2) / 1000.0;
    }
    for (int i = 0; i < 4; ++i)
        EXPECT_NEAR(means[i], 0.0, 1e-4);
}

TEST(ReferenceSamples, AreTheWholeReferenceMapWhenItIsSmall)
{
    FilterSource source(test::noiseProbe(16, 1));
    const MapLayout cube4{Parameterization::Cube, 4, 0};
    const ReferenceSamples samples = referenceSamples(source, phongLobe(5), cube4, 1000, {});
    EXPECT_TRUE(samples.complete);
    ASSERT_EQ(samples.texels.size(), 96u);
    const EnvironmentMap map = prefilter(source, {.lobe = phongLobe(5), .target = cube4, .method = Method::Reference}).map;
    EXPECT_LE(errorAt(samples, map).relRms, 1e-7); // the map is rounded to float
    double sphere = 0.0;
    for (const double w : samples.weights)
        sphere += w;
    EXPECT_NEAR(sphere, 4.0 * pi, 1e-9);
}

TEST(ReferenceSamples, EstimateTheErrorOfTheWholeMapFromAPartOfIt)
{
    FilterSource source(test::noiseProbe(16, 2));
    const Lobe lobe = phongLobe(4);
    const EnvironmentMap reference = prefilter(source, {.lobe = lobe, .target = cube16, .method = Method::Reference}).map;
    EnvironmentMap wrong = reference;
    for (int y = 0; y < 96; ++y)
        for (int x = 0; x < 16; ++x)
            wrong.image.texel(x, y)[0] *= 1.0f + 0.01f * std::sin(static_cast<float>(7 * x + 3 * y));
    const ReferenceSamples part = referenceSamples(source, lobe, cube16, 300, {});
    EXPECT_FALSE(part.complete);
    EXPECT_LE(part.weighted(), 300);
    const ErrorMetrics whole = errorMetrics(wrong, reference), estimate = errorAt(part, wrong);
    EXPECT_NEAR(estimate.relRms / whole.relRms, 1.0, 0.1); // 300 samples of a variance: 1/sqrt(600) = 4 %, twice that and some
    EXPECT_LE(estimate.maxAbs, whole.maxAbs * (1.0 + 1e-6));
    EXPECT_NEAR(estimate.maxAbs / whole.maxAbs, 1.0, 0.1);
}

TEST(ReferenceSamples, LookForTheLargestErrorAroundTheSun)
{
    const EnvironmentMap probe = test::sunProbe(16, 1e4f, 20, 3);
    FilterSource source(probe);
    const Lobe lobe = phongLobe(20);
    EnvironmentMap map = prefilter(source, {.lobe = lobe, .target = cube16, .method = Method::Reference}).map;
    // One wrong texel, at the sun: 16 even directions miss it, the largest error must not.
    const glm::dvec2 sun = coordinate(cube16, texelDirection(probe.layout, 20, 3));
    map.image.texel(static_cast<int>(sun.x), static_cast<int>(sun.y))[0] *= 2.0f;
    const ReferenceSamples samples = referenceSamples(source, lobe, cube16, 16, {});
    EXPECT_GT(errorAt(samples, map).maxAbs, 0.5);
}

TEST(ReferenceSamples, OfAnUnresolvedLobeAreTheBilinearLookup)
{
    FilterSource source(test::noiseProbe(16, 3));
    const ReferenceSamples samples = referenceSamples(source, phongLobe(1e6), cube16, 50, {});
    for (size_t i = 0; i < samples.texels.size(); ++i)
        EXPECT_EQ(samples.values[i],
                  glm::dvec3(source.latlong()->radiance(texelDirection(cube16, samples.texels[i].x, samples.texels[i].y))));
}

} // namespace
} // namespace mirrorball
