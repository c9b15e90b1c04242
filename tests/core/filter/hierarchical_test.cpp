#include "core/base/error.h"
#include "core/filter/hierarchical.h"
#include "core/filter/prefilter.h"
#include "core/filter/reference.h"
#include "core/report/error_metrics.h"
#include "support/directions.h"
#include "support/probe_builders.h"

#include <gtest/gtest.h>

namespace mirrorball {
namespace {

TEST(Hierarchical, HoldsItsTolerance)
{
    const std::vector<glm::dvec3> directions = test::randomDirections(150);
    for (const EnvironmentMap& probe : {test::noiseProbe(64, 3), test::sunProbe(64, 1e6f, 20, 17), test::sunProbe(64, 50.0f, 3, 1)}) {
        const RadianceTree tree(probe);
        for (const Lobe& lobe : {phongLobe(0), phongLobe(0.5), phongLobe(1.5), phongLobe(10), phongLobe(200), diffuseLobe(), ggxLobe(0.1),
                                 ggxLobe(1), tabulatedLobe({0, 1, 0, 2})}) {
            const auto reference = referenceSum(probe, lobe, directions);
            for (const double tolerance : {1e-1, 1e-2, 1e-4}) {
                const auto sums = hierarchicalSum(tree, lobe, directions, {.tolerance = tolerance});
                EXPECT_LE(errorMetrics(sums.values, reference).relRms, tolerance) << describe(lobe);
            }
        }
    }
}

TEST(Hierarchical, SplitsOnlyWhatTheToleranceAsksFor)
{
    const EnvironmentMap probe = test::noiseProbe(128, 3);
    const RadianceTree tree(probe);
    const std::vector<glm::dvec3> directions = test::randomDirections(50);
    double before = 0.0;
    for (const double tolerance : {1e-1, 1e-2, 1e-3}) {
        const double terms = hierarchicalSum(tree, phongLobe(20), directions, {.tolerance = tolerance}).terms / 50.0;
        EXPECT_GT(terms, before);
        EXPECT_LT(terms, tolerance < 5e-2 ? 256 * 128 / 2.0 : 256 * 128 / 16.0); // half of the texels are below the horizon
        before = terms;
    }
}

TEST(Hierarchical, ItsNodesHoldWhatTheirTexelsHold)
{
    const EnvironmentMap probe = test::noiseProbe(11, 3); // odd sizes: blocks are cut at the edges
    const RadianceTree tree(probe);
    const RadianceTree::Node& root = tree.levels().back().nodes.at(0);
    glm::dvec3 flux(0.0);
    for (int y = 0; y < 11; ++y)
        for (int x = 0; x < 22; ++x) {
            const float* t = probe.image.texel(x, y);
            flux += texelSolidAngle(probe.layout, x, y) * glm::dvec3(t[0], t[1], t[2]);
        }
    EXPECT_NEAR(root.solidAngle, 4.0 * pi, 1e-12);
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(root.flux[c] / flux[c], 1.0, 1e-12);
    EXPECT_NEAR(glm::length(root.center), 0.0, 1e-12);
    EXPECT_NEAR(root.spread, 1.0, 1e-12); // of unit vectors about the origin
}

TEST(Hierarchical, DoesNotDependOnThreads)
{
    const EnvironmentMap probe = test::noiseProbe(32, 2);
    const std::vector<glm::dvec3> directions = test::randomDirections(100);
    const auto one = hierarchicalSum(RadianceTree(probe, {.threads = 1}), phongLobe(30), directions, {.tolerance = 1e-2}, {.threads = 1});
    const auto two = hierarchicalSum(RadianceTree(probe, {.threads = 2}), phongLobe(30), directions, {.tolerance = 1e-2}, {.threads = 2});
    EXPECT_EQ(one.values, two.values);
    EXPECT_EQ(one.terms, two.terms);
}

TEST(Hierarchical, RefusesAMirrorAndProbesThatDoNotFitInMemory)
{
    const EnvironmentMap probe = test::noiseProbe(8, 2);
    EXPECT_THROW(hierarchicalSum(RadianceTree(probe), ggxLobe(0.0), test::randomDirections(1)), InvalidArgument);
    EXPECT_NE(refusal(Method::Hierarchical, {}, {.width = 16384}).find("width"), std::string::npos);
}

} // namespace
} // namespace mirrorball
