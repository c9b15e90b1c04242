#include "core/image/image_io.h"
#include "core/image/layout_detection.h"
#include "core/image/reproject.h"
#include "support/directions.h"
#include "support/shared_data.h"

#include <gtest/gtest.h>

#include <optional>

namespace mirrorball {
namespace {

EnvironmentMap load(const std::filesystem::path& path, std::optional<Parameterization> kind = {})
{
    const Detection detection = detectLayout(openImage(path)->info(), kind);
    return toEnvironmentMap(readImage(path), detection);
}

/// Mean difference of the logarithms of the radiance in the same directions; `mirrored` looks up the second map with x negated.
enum class Look { Straight, MirroredX, Turned };
double logDifference(const EnvironmentMap& a, const EnvironmentMap& b, Look look = Look::Straight)
{
    double sum = 0.0;
    const auto directions = test::randomDirections(4000);
    for (const glm::dvec3& d : directions) {
        const glm::dvec3 there = look == Look::Straight    ? d
                                 : look == Look::MirroredX ? glm::dvec3(-d.x, d.y, d.z)
                                                           : glm::dvec3(-d.x, d.y, -d.z);
        const glm::vec3 va = a.radiance(d), vb = b.radiance(there);
        for (int c = 0; c < 3; ++c)
            sum += std::abs(std::log((va[c] + 1e-3) / (vb[c] + 1e-3)));
    }
    return sum / (3.0 * static_cast<double>(directions.size()));
}

/// The same direction shows the same color in both maps, and in no mirrored or turned one. Resampling blurs fine texture: below 0.08.
void expectSameWorld(const EnvironmentMap& a, const EnvironmentMap& b)
{
    const double same = logDifference(a, b);
    EXPECT_LT(same, 0.08);
    EXPECT_GT(logDifference(a, b, Look::MirroredX), 2.0 * same);
    EXPECT_GT(logDifference(a, b, Look::Turned), 2.0 * same);
}

TEST(RealProbes, OpenExrsLatlongAndCubeShowTheSameLabels)
{
    SHARED_DATA_OR_SKIP(latlong, "probes/openexr/OrientationLatLong.exr");
    SHARED_DATA_OR_SKIP(cube, "probes/openexr/OrientationCube.exr");
    expectSameWorld(load(latlong), load(cube));
}

TEST(RealProbes, OpenExrsLatlongAndCubeShowTheSameCarPark)
{
    SHARED_DATA_OR_SKIP(latlong, "probes/openexr/KernerEnvLatLong.exr");
    SHARED_DATA_OR_SKIP(cube, "probes/openexr/KernerEnvCube.exr");
    expectSameWorld(load(latlong), load(cube));
}

TEST(RealProbes, AVerticalCrossShowsTheWorldOfItsLatlong)
{
    SHARED_DATA_OR_SKIP(latlong, "probes/rooitou_park_1k.hdr");
    SHARED_DATA_OR_SKIP(cross, "probes/derived/rooitou_park_vcross_256.hdr");
    expectSameWorld(load(latlong), load(cross));
}

TEST(RealProbes, AHorizontalCrossShowsTheWorldOfItsLatlong)
{
    SHARED_DATA_OR_SKIP(latlong, "probes/st_fagans_interior_1k.hdr");
    SHARED_DATA_OR_SKIP(cross, "probes/derived/st_fagans_interior_hcross_256.exr");
    expectSameWorld(load(latlong), load(cross));
}

TEST(RealProbes, AnAngularMapIsAPictureFromInsideAndNeedsNoFlip)
{
    // Our angular map has -X on the right of +Z as the latlong has: light probes as they are found load straight.
    SHARED_DATA_OR_SKIP(latlong, "probes/empty_warehouse_01_1k.hdr");
    SHARED_DATA_OR_SKIP(angular, "probes/derived/empty_warehouse_01_angular_640.hdr");
    expectSameWorld(load(latlong), load(angular));
    SHARED_DATA_OR_SKIP(labels, "probes/openexr/OrientationLatLong.exr");
    SHARED_DATA_OR_SKIP(angularLabels, "probes/derived/orientation_angular_512.exr");
    expectSameWorld(load(labels), load(angularLabels));
}

TEST(RealProbes, APhotographOfAMirrorBallIsGlSphereMapAndNeedsNoFlip)
{
    // The ball shows the world mirrored; so does GL_SPHERE_MAP, with +X on the right of +Z.
    SHARED_DATA_OR_SKIP(latlong, "probes/studio_small_03_1k.hdr");
    SHARED_DATA_OR_SKIP(ball, "probes/derived/studio_small_03_mirrorball_512.hdr");
    expectSameWorld(load(latlong), load(ball, Parameterization::Sphere));
}

TEST(RealProbes, EveryProbeKeepsItsMeanInASmallCube)
{
    for (const auto& path : test::realProbes()) {
        const EnvironmentMap probe = load(path);
        const glm::dvec3 before = meanRadiance(probe), after = meanRadiance(reproject(probe, {{Parameterization::Cube, 32, 0}, 0.0}));
        EXPECT_LT(glm::length(after - before) / glm::length(before), 2e-3) << path;
    }
}

} // namespace
} // namespace mirrorball
