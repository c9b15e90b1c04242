#include "core/base/error.h"
#include "core/filter/prefilter.h"
#include "core/filter/promise.h"
#include "core/filter/reference.h"
#include "core/filter/row_sums.h"
#include "core/image/builtin_probes.h"
#include "core/report/reference_samples.h"
#include "support/plain_sum.h"
#include "support/probe_builders.h"

#include <gtest/gtest.h>

#include <cmath>

namespace mirrorball {
namespace {

using test::constantProbe;
using test::noiseProbe;
using test::sunProbe;

/// A million on a thousandth, in one texel: nearly all of the root mean square is the sun, and all that is seen is the sky.
EnvironmentMap sunOnNight(int height)
{
    EnvironmentMap probe = constantProbe(height, 1e-3f);
    std::fill_n(probe.image.texel(height / 2, height / 4), 3, 1e6f);
    return probe;
}

struct Cell {
    const char* probe;
    Lobe lobe;
    double tolerance;
};

EnvironmentMap probeOf(const std::string& word)
{
    return word == "night" ? sunOnNight(32)
           : word == "sky" ? renderBuiltinProbe("sky", {Parameterization::Latlong, 48, 0})
                           : noiseProbe(32, 3);
}

/// Judged by a sum that shares nothing with the library's filters; `build/ci/bin/tolerance_table` does the same over whole folders.
TEST(Promise, IsKeptInADozenCells)
{
    const std::vector<Cell> cells{{"night", phongLobe(0), 1e-2},   {"night", phongLobe(3), 1e-5},   {"night", phongLobe(4.5), 1e-5},
                                  {"night", phongLobe(30), 1e-3},  {"night", ggxLobe(0.3), 1e-1},   {"night", diffuseLobe(), 1e-5},
                                  {"sky", phongLobe(0.5), 5e-2},   {"sky", phongLobe(300), 1e-1},   {"sky", ggxLobe(0.1), 1e-3},
                                  {"sky", diffuseLobe(), 1e-2},    {"noise", phongLobe(7.3), 1e-5}, {"noise", ggxLobe(1.0), 1e-1},
                                  {"noise", phongLobe(3000), 1e-3}};
    const MapLayout target{Parameterization::Cube, 16, 0};
    const std::vector<glm::dvec3> directions = lookupDirections(target, 0.0);
    for (const Cell& cell : cells) {
        const EnvironmentMap probe = probeOf(cell.probe);
        const std::vector<glm::dvec3> truth = test::plainlyUnresolved(cell.lobe, probe.image.width)
                                                  ? test::plainLookups(probe.image, directions)
                                                  : test::plainSum(probe.image, cell.lobe, directions);
        FilterSource source(probe);
        const PrefilterOutcome outcome = prefilter(source, {.lobe = cell.lobe, .target = target, .tolerance = cell.tolerance});
        std::vector<glm::dvec3> values;
        for (size_t i = 0; i < directions.size(); ++i)
            values.emplace_back(outcome.map.image.texels[3 * i], outcome.map.image.texels[3 * i + 1], outcome.map.image.texels[3 * i + 2]);
        const test::PlainError error = test::plainError(values, truth);
        EXPECT_TRUE(outcome.promised && error.keeps(cell.tolerance))
            << cell.probe << ' ' << describe(cell.lobe) << " at " << cell.tolerance << " by " << name(outcome.method) << ": rel_rms "
            << error.relRms << ", median_rel " << error.medianRel << ", p99_rel " << error.p99Rel << ", least " << error.least;
    }
}

TEST(Promise, IsRefusedByASpectrumThatCannotKeepIt)
{
    // A step at the horizon: no band limit is enough for 1e-6, and there are more texels than are taken out one by one.
    FilterSource source(noiseProbe(96, 5));
    const PrefilterOptions options{
        .lobe = phongLobe(0), .target = {Parameterization::Cube, 4, 0}, .method = Method::Spectral, .tolerance = 1e-6};
    EXPECT_THROW(prefilter(source, options), InvalidArgument);
}

TEST(Promise, LimitsAreThoseOfTheGuide)
{
    const ErrorLimits loose = errorLimits(1e-1), usual = errorLimits(1e-5);
    EXPECT_DOUBLE_EQ(loose.relRms, 1e-1);
    EXPECT_DOUBLE_EQ(loose.medianRel, 1e-1);
    EXPECT_DOUBLE_EQ(loose.p99Rel, 5e-1);
    EXPECT_DOUBLE_EQ(loose.negative, 1e-4);
    EXPECT_DOUBLE_EQ(usual.p99Rel, 1e-3);
    EXPECT_DOUBLE_EQ(usual.negative, 1e-7);
}

TEST(Promise, IsNotMadeByMethodsThatApproximate)
{
    FilterSource source(noiseProbe(32, 9));
    for (const Method method : {Method::Mip, Method::Importance, Method::Sh9}) {
        const PrefilterOutcome outcome =
            prefilter(source, {.lobe = diffuseLobe(), .target = {Parameterization::Cube, 4, 0}, .method = method});
        EXPECT_FALSE(outcome.promised) << name(method);
        EXPECT_FALSE(keepsTolerance(method));
    }
}

TEST(RowSums, AreTheReferenceSum)
{
    for (const int height : {16, 33}) {
        EnvironmentMap probe = noiseProbe(height, 7);
        std::fill_n(probe.image.texel(5, height / 3), 3, 1e4f);
        std::vector<glm::dvec3> directions = lookupDirections({Parameterization::Octahedral, 13, 0}, 0.3);
        for (const glm::dvec3& axis : {glm::dvec3(0, 1, 0), glm::dvec3(0, -1, 0), glm::dvec3(0.6, 0, 0.8), glm::dvec3(1e-12, 1, 0)})
            directions.push_back(axis);
        for (const Lobe& lobe : {phongLobe(0), phongLobe(1), phongLobe(2), phongLobe(3), diffuseLobe(), ggxLobe(1.0)}) {
            ASSERT_TRUE(isShortPolynomial(lobe));
            const std::vector<glm::dvec3> sums = rowSums(probe, lobe, directions), truth = referenceSum(probe, lobe, directions);
            for (size_t i = 0; i < truth.size(); ++i)
                for (int c = 0; c < 3; ++c)
                    ASSERT_NEAR(sums[i][c] / truth[i][c], 1.0, 1e-11) << describe(lobe) << ' ' << height << ' ' << i;
        }
    }
    for (const Lobe& lobe : {phongLobe(0.5), phongLobe(4), ggxLobe(0.5)})
        EXPECT_FALSE(isShortPolynomial(lobe)) << describe(lobe);
}

TEST(RowSums, KeepTheDarkBesideASun)
{
    const EnvironmentMap probe = sunOnNight(32);
    const std::vector<glm::dvec3> directions = lookupDirections({Parameterization::Cube, 8, 0}, 0.0);
    for (const Lobe& lobe : {phongLobe(0), diffuseLobe(), phongLobe(3)}) {
        const std::vector<glm::dvec3> sums = rowSums(probe, lobe, directions), truth = test::plainSum(probe.image, lobe, directions);
        const test::PlainError error = test::plainError(sums, truth);
        EXPECT_LE(error.p99Rel, 1e-6) << describe(lobe);
    }
}

} // namespace
} // namespace mirrorball
