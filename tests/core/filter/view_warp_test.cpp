#include "core/filter/view_warp.h"

#include "core/base/error.h"
#include "core/filter/brdf_sum.h"
#include "core/report/error_metrics.h"
#include "support/probe_builders.h"

#include <gtest/gtest.h>

#include <cmath>

namespace mirrorball {
namespace {

const MapLayout smallLatlong{Parameterization::Latlong, 12, 0};

// Every source mirrors its own view to the same r, and its view lies where it was asked for.
TEST(ViewWarp, TakesWhatItsSourcesMirrorToTheSameDirection)
{
    const glm::dvec3 r = glm::normalize(glm::dvec3(0.4, 0.3, -0.8));
    const SurfaceView wanted{0.6, 1.1};
    const auto viewer = [&](const SurfaceView& seen) {
        const glm::dvec3 n = normalAt(r, seen);
        return 2.0 * glm::dot(n, r) * n - r;
    };
    const auto sources = warpSources(wanted, 0.35);
    glm::dvec3 mean(0.0);
    for (const SurfaceView& source : sources) {
        EXPECT_NEAR(std::acos(glm::dot(viewer(source), viewer(wanted))), 0.35, 1e-9);
        mean += viewer(source) / 3.0;
    }
    EXPECT_LT(glm::distance(glm::normalize(mean), viewer(wanted)), 1e-9) << "the wanted view is in their middle";
    EXPECT_NEAR(sources[0].view, 0.6 + 0.175, 1e-9) << "in the plane of incidence half of the distance is the normal's";
    EXPECT_THROW(warpSources({1.2, 0.0}, 0.8), InvalidArgument);
}

// From no distance it is the map itself; the further the sources, the more of the lobe's change is lost.
TEST(ViewWarp, ErrsMoreFromFurtherViews)
{
    const EnvironmentMap probe = test::noiseProbe(48, 3);
    FilterSource source(probe);
    const Brdf brdf{GgxBrdf{0.25}};
    const SurfaceView seen{0.9, 0.4};
    const EnvironmentMap truth = filterBrdfSum(probe, brdf, seen, smallLatlong, 0.0);
    const auto error = [&](double distance) {
        return errorMetrics(filterBrdfWarped(source, brdf, seen, distance, smallLatlong, 0.0, 1e-3), truth).relRms;
    };
    const double none = error(0.0), near = error(0.3), far = error(0.8);
    EXPECT_LT(none, 2e-3);
    EXPECT_GT(near, 2.0 * none);
    EXPECT_GT(far, 1.5 * near);
}

} // namespace
} // namespace mirrorball
