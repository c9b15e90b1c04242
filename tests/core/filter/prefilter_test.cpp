#include "core/base/error.h"
#include "core/filter/direct.h"
#include "core/filter/prefilter.h"
#include "core/filter/reference.h"
#include "core/report/error_metrics.h"
#include "support/probe_builders.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace mirrorball {
namespace {

using test::constantProbe;
using test::noiseProbe;
using test::sunProbe;

std::vector<MapLayout> smallLayouts()
{
    return {{Parameterization::Latlong, 24, 0}, {Parameterization::Cube, 12, 0},       {Parameterization::Sphere, 24, 0},
            {Parameterization::Angular, 24, 0}, {Parameterization::Paraboloid, 20, 2}, {Parameterization::Octahedral, 24, 0}};
}

EnvironmentMap filtered(const EnvironmentMap& probe, const PrefilterOptions& options, const JobControl& job = {})
{
    FilterSource source(probe);
    return prefilter(source, options, job).map;
}

ErrorMetrics againstReference(const EnvironmentMap& probe, PrefilterOptions options, PrefilterOutcome* outcome = nullptr)
{
    FilterSource source(probe);
    const PrefilterOutcome result = prefilter(source, options);
    if (outcome)
        *outcome = result;
    options.method = Method::Reference;
    return errorMetrics(result.map, prefilter(source, options).map);
}

/// The methods that do not refuse a lobe.
std::vector<Method> methodsFor(const Lobe& lobe)
{
    std::vector<Method> methods;
    for (const Method method : allMethods)
        if (refusal(method, {.lobe = lobe}, {.width = 64}).empty())
            methods.push_back(method);
    return methods;
}

double largest(const EnvironmentMap& map) { return *std::max_element(map.image.texels.begin(), map.image.texels.end()); }

TEST(Reference, OfOneTexelIsTheNormalizedKernel)
{
    // Directions far enough from the lobe's own sampling error: E(r) = L w k(r.d) / N, with N = 1 up to the quadrature of 128 rows.
    const EnvironmentMap probe = sunProbe(128, 1e6f, 40, 50);
    EnvironmentMap black = constantProbe(128, 0.0f);
    black.image.texel(40, 50)[1] = 1000.0f;
    const glm::dvec3 d = texelDirection(black.layout, 40, 50);
    const double flux = 1000.0 * texelSolidAngle(black.layout, 40, 50);
    const glm::dvec3 side = glm::normalize(glm::cross(d, glm::dvec3(0.3, 1.0, 0.2)));
    for (const double angle : {0.0, 0.1, 0.4, 1.2}) {
        const std::vector<glm::dvec3> r{d * std::cos(angle) + side * std::sin(angle)};
        const double c = std::cos(angle);
        EXPECT_NEAR(referenceSum(black, phongLobe(20), r)[0].y / (flux * 21.0 / (2 * pi) * std::pow(c, 20)), 1.0, 2e-3);
        EXPECT_NEAR(referenceSum(black, diffuseLobe(), r)[0].y / (flux / pi * c), 1.0, 1e-3);
    }
}

TEST(Reference, SurvivesExponentsThatUnderflowEveryTexel)
{
    // cos^n of the nearest texel center is exp(-1e6) here; the sum must still be that texel's neighborhood, not 0/0.
    const EnvironmentMap probe = noiseProbe(16, 1);
    const std::vector<glm::dvec3> r{directionFromLonLat(0.3, 0.2), {0, 1, 0}, {0, -1, 0}};
    for (const double n : {1e6, 1e9})
        for (const glm::dvec3& e : referenceSum(probe, phongLobe(n), r))
            EXPECT_TRUE(std::isfinite(e.x) && e.x > 0.0 && e.x < 60.0) << n;
}

TEST(Prefilter, WhiteFurnace)
{
    const EnvironmentMap probe = constantProbe(32);
    for (const Lobe& lobe : {phongLobe(0), phongLobe(1e-3), phongLobe(1), phongLobe(50.5), phongLobe(500), phongLobe(1e6), phongLobe(1e9),
                             diffuseLobe(), ggxLobe(0), ggxLobe(0.04), ggxLobe(0.3), ggxLobe(1), tabulatedLobe({0, 1, 0, 2})})
        for (const Method method : methodsFor(lobe))
            for (const MapLayout& layout : smallLayouts())
                for (const float value : filtered(probe, {.lobe = lobe, .target = layout, .method = method}).image.texels)
                    ASSERT_NEAR(value, 1.0f, 1e-6f) << describe(lobe) << ' ' << name(layout.kind) << ' ' << name(method);
}

TEST(Prefilter, SpectralReproducesTheReferenceInEveryParameterization)
{
    const EnvironmentMap probe = noiseProbe(48, 11);
    for (const Lobe& lobe : {phongLobe(3), phongLobe(50), diffuseLobe(), ggxLobe(0.2), ggxLobe(1)})
        for (const MapLayout& layout : smallLayouts()) {
            const ErrorMetrics e = againstReference(probe, {.lobe = lobe, .target = layout, .method = Method::Spectral});
            EXPECT_LE(e.relRms, 1e-5) << describe(lobe) << ' ' << name(layout.kind);
        }
}

TEST(Prefilter, HoldsTheToleranceBesideASunOfAMillion)
{
    const EnvironmentMap probe = sunProbe(64, 1e6f, 20, 17);
    const MapLayout cube{Parameterization::Cube, 16, 0};
    const auto expectKept = [&](const Lobe& lobe, Method method) {
        const ErrorMetrics e = againstReference(probe, {.lobe = lobe, .target = cube, .method = method});
        EXPECT_LE(e.relRms, 1e-5) << describe(lobe);
        EXPECT_LE(e.medianRel, 1e-5) << describe(lobe);
        EXPECT_LE(e.p99Rel, 1e-3) << describe(lobe);
    };
    for (const double n : {10.0, 50.0, 200.0})
        expectKept(phongLobe(n), Method::Spectral);
    for (const Lobe& lobe : {phongLobe(1.0), phongLobe(1.5), diffuseLobe(), ggxLobe(0.3)})
        expectKept(lobe, Method::Auto);
}

TEST(Prefilter, PredictsItsError)
{
    const EnvironmentMap probe = noiseProbe(48, 2);
    for (const double tolerance : {1e-2, 1e-3, 1e-4, 1e-6}) {
        PrefilterOutcome outcome;
        const ErrorMetrics e = againstReference(
            probe, {.lobe = phongLobe(50), .target = {Parameterization::Cube, 16, 0}, .method = Method::Spectral, .tolerance = tolerance},
            &outcome);
        EXPECT_LE(e.relRms, tolerance);
        EXPECT_LE(outcome.predicted.relRms, tolerance);
    }
}

TEST(Prefilter, DirectAgreesWithTheReferenceForNarrowLobes)
{
    const EnvironmentMap probe = sunProbe(128, 1e5f, 100, 3); // near the pole, where rows are short
    for (const double n : {300.0, 900.0}) {
        const ErrorMetrics e =
            againstReference(probe, {.lobe = phongLobe(n), .target = {Parameterization::Octahedral, 32, 0}, .method = Method::Direct});
        EXPECT_LE(e.relRms, 1e-6) << n;
        EXPECT_LE(e.p99Rel, 1e-3) << n;
    }
}

TEST(Prefilter, ALobeOnAPoleIsNoSpecialCase)
{
    const EnvironmentMap probe = noiseProbe(64, 21);
    const std::vector<glm::dvec3> poles{{0, 1, 0}, {0, -1, 0}, {1e-300, 1, 0}, {0, 1, 1e-17}};
    const auto reference = referenceSum(probe, phongLobe(100), poles);
    const auto direct = directSum(probe, phongLobe(100), poles);
    for (size_t i = 0; i < poles.size(); ++i)
        EXPECT_NEAR(direct[i].x / reference[i].x, 1.0, 1e-9);
    // Odd sizes of these maps have a texel center exactly on a pole (octahedral: both).
    const ErrorMetrics e =
        againstReference(probe, {.lobe = phongLobe(100), .target = {Parameterization::Octahedral, 9, 0}, .method = Method::Spectral});
    EXPECT_LE(e.relRms, 1e-5);
}

TEST(Prefilter, YawTurnsTheMap)
{
    const EnvironmentMap probe = noiseProbe(48, 31);
    const double yaw = 0.7;
    const MapLayout layout{Parameterization::Cube, 10, 0};
    for (const Method method : {Method::Spectral, Method::Direct, Method::Reference}) {
        const EnvironmentMap turned = filtered(probe, {.lobe = phongLobe(200), .target = layout, .method = method, .yaw = yaw});
        std::vector<glm::dvec3> values, expected, directions;
        for (int y = 0; y < 60; ++y)
            for (int x = 0; x < 10; ++x) {
                values.emplace_back(turned.image.texel(x, y)[0], turned.image.texel(x, y)[1], turned.image.texel(x, y)[2]);
                directions.push_back(yawed(texelDirection(layout, x, y), -yaw));
            }
        EXPECT_LE(errorMetrics(values, referenceSum(probe, phongLobe(200), directions)).relRms, 1e-5) << name(method);
    }
    // A latlong map is turned along its rings: by a quarter of its width, that is a shift of whole columns.
    const MapLayout latlong{Parameterization::Latlong, 16, 0};
    const EnvironmentMap straight = filtered(probe, {.lobe = phongLobe(20), .target = latlong});
    const EnvironmentMap quarter = filtered(probe, {.lobe = phongLobe(20), .target = latlong, .yaw = pi / 2});
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 32; ++x) // content moves from +Z (the middle) to +X (the left quarter)
            EXPECT_NEAR(quarter.image.texel(x, y)[0], straight.image.texel((x + 8) % 32, y)[0], 1e-5);
}

TEST(Prefilter, NarrowLobesBesideAPoleWithYaw)
{
    const EnvironmentMap probe = noiseProbe(64, 5);
    const ErrorMetrics e = againstReference(
        probe, {.lobe = phongLobe(400), .target = {Parameterization::Paraboloid, 17, 1}, .method = Method::Spectral, .yaw = -2.1});
    EXPECT_LE(e.relRms, 1e-5);
}

TEST(Prefilter, AnUnresolvedLobeIsTheBilinearLookup)
{
    const EnvironmentMap probe = noiseProbe(16, 6);
    const MapLayout layout{Parameterization::Cube, 8, 0};
    FilterSource source(probe);
    const PrefilterOutcome outcome = prefilter(source, {.lobe = phongLobe(1e9), .target = layout});
    EXPECT_FALSE(outcome.filtered);
    EXPECT_NE(outcome.why.find("bilinear"), std::string::npos);
    for (int y = 0; y < 48; ++y)
        for (int x = 0; x < 8; ++x)
            EXPECT_EQ(outcome.map.image.texel(x, y)[0], probe.radiance(texelDirection(layout, x, y)).x);
}

TEST(Prefilter, ManyLobesShareOneSpectrum)
{
    const EnvironmentMap probe = noiseProbe(64, 8);
    FilterSource source(probe);
    const PrefilterOptions options{.lobe = phongLobe(60), .target = {Parameterization::Cube, 8, 0}, .method = Method::Spectral};
    EXPECT_FALSE(prefilter(source, options).stages.at(0).leftOut);
    PrefilterOptions other = options;
    other.lobe = phongLobe(50);
    const PrefilterOutcome again = prefilter(source, other);
    EXPECT_TRUE(again.stages.at(0).leftOut);
    EXPECT_EQ(again.stages.at(0).name, "spectrum");
    EXPECT_EQ(again.stages.at(0).seconds, 0.0);
    // Sharing changes nothing beyond the rounding of float.
    const EnvironmentMap alone = filtered(probe, other);
    EXPECT_LE(errorMetrics(again.map, alone).relRms, 1e-6);
}

TEST(Prefilter, DoesNotDependOnThreads)
{
    const EnvironmentMap sun = sunProbe(64, 1e5f, 9, 30), noise = noiseProbe(64, 4);
    for (const Lobe& lobe : {phongLobe(50), diffuseLobe(), ggxLobe(0.1)})
        for (const Method method : {Method::Spectral, Method::Direct, Method::Reference}) {
            const EnvironmentMap& probe = lobe == phongLobe(50) ? sun : noise;
            const PrefilterOptions options{.lobe = lobe, .target = {Parameterization::Cube, 9, 0}, .method = method};
            EXPECT_EQ(filtered(probe, options, {.threads = 1}).image, filtered(probe, options, {.threads = 2}).image)
                << describe(lobe) << ' ' << name(method);
        }
}

TEST(Prefilter, AStreamedProbeGivesTheSameMap)
{
    const EnvironmentMap probe = noiseProbe(64, 13);
    const PrefilterOptions options{.lobe = phongLobe(50), .target = {Parameterization::Cube, 12, 0}};
    const PrefilterPlan plan = planPrefilter(options, {.width = 128, .streamed = true});
    FilterSource streamed(analyze(probe, plan.bandLimit));
    EXPECT_EQ(streamed.latlong(), nullptr);
    EXPECT_LE(errorMetrics(prefilter(streamed, options).map, filtered(probe, options)).relRms, 1e-6);
}

TEST(Prefilter, AStreamedProbeRefusesWhatNeedsItsTexels)
{
    FilterSource streamed(analyze(noiseProbe(32, 1), 40));
    PrefilterOptions options{.lobe = phongLobe(1e9), .target = {Parameterization::Cube, 4, 0}};
    EXPECT_THROW(prefilter(streamed, options), InvalidArgument);
    options = {.lobe = phongLobe(20), .target = {Parameterization::Cube, 4, 0}, .method = Method::Direct};
    EXPECT_THROW(prefilter(streamed, options), InvalidArgument);
}

TEST(Prefilter, StaysFiniteAndInRangeAtTheExtremes)
{
    const EnvironmentMap probe = sunProbe(32, 1e6f, 10, 12);
    const double high = largest(probe);
    for (const double n : {0.0, 1e-3, 1.0, 2.5, 1e3, 1e6, 1e9})
        for (const MapLayout& layout : smallLayouts()) {
            const EnvironmentMap map = filtered(probe, {.lobe = phongLobe(n), .target = layout});
            for (const float value : map.image.texels) {
                ASSERT_TRUE(std::isfinite(value)) << n;
                ASSERT_LE(value, high * 1.001) << n;
                ASSERT_GE(value, -1e-4 * high) << n;
            }
        }
    for (const double roughness : {0.0, 1e-4, 0.1, 0.5, 1.0})
        for (const float value :
             filtered(probe, {.lobe = ggxLobe(roughness * roughness), .target = {Parameterization::Cube, 8, 0}}).image.texels)
            ASSERT_TRUE(std::isfinite(value)) << roughness;
}

TEST(Prefilter, TakesProbesOfOneAndTwoTexels)
{
    for (const int width : {1, 2}) {
        EnvironmentMap probe(MapLayout{Parameterization::Latlong, 1, 0});
        probe.image = Image(2, 1, 3, 0.5f);
        if (width == 2)
            probe.image.texel(1, 0)[0] = 1.5f;
        for (const Lobe& lobe : {phongLobe(0), phongLobe(50), diffuseLobe(), ggxLobe(1)})
            for (const float value : filtered(probe, {.lobe = lobe, .target = {Parameterization::Cube, 4, 0}}).image.texels) {
                EXPECT_GE(value, 0.5f - 1e-4f);
                EXPECT_LE(value, 1.5f + 1e-4f);
            }
    }
}

TEST(Prefilter, ReportsWhatResamplingACubeProbeCosts)
{
    EnvironmentMap cube(MapLayout{Parameterization::Cube, 16, 0});
    for (int y = 0; y < 96; ++y)
        for (int x = 0; x < 16; ++x) {
            const glm::dvec3 d = texelDirection(cube.layout, x, y);
            for (int c = 0; c < 3; ++c)
                cube.image.texel(x, y)[c] = static_cast<float>(1.0 + 0.5 * d[c]);
        }
    FilterSource source(cube);
    EXPECT_GT(source.resamplingError(), 0.0);
    EXPECT_LT(source.resamplingError(), 2e-3);
    // A linear function of direction is a harmonic of degree 1: filtering scales it by k_1 = (n+1)/(n+2).
    const EnvironmentMap map = prefilter(source, {.lobe = phongLobe(4), .target = cube.layout}).map;
    for (int y = 0; y < 96; ++y)
        for (int x = 0; x < 16; ++x)
            EXPECT_NEAR(map.image.texel(x, y)[1], 1.0 + 0.5 * 5.0 / 6.0 * texelDirection(cube.layout, x, y).y, 2e-3);
}

TEST(Prefilter, ARotationOfTheProbeRotatesTheMap)
{
    // A smooth function turned about a slanted axis, sampled anew: filtering commutes with rotations up to the sampling.
    const glm::dvec3 axis = glm::normalize(glm::dvec3(1.0, 2.0, -0.5));
    const auto turned = [&](const glm::dvec3& d) { // Rodrigues, by 1 radian
        return d * std::cos(1.0) + glm::cross(axis, d) * std::sin(1.0) + axis * (glm::dot(axis, d) * (1.0 - std::cos(1.0)));
    };
    const auto scene = [](const glm::dvec3& d) { return 1.0 + std::exp(3.0 * d.x) + d.y * d.z; };
    EnvironmentMap a = constantProbe(128), b = constantProbe(128);
    for (int y = 0; y < 128; ++y)
        for (int x = 0; x < 256; ++x) {
            const glm::dvec3 d = texelDirection(a.layout, x, y);
            a.image.texel(x, y)[0] = static_cast<float>(scene(d));
            b.image.texel(x, y)[0] = static_cast<float>(scene(turned(d)));
        }
    const MapLayout layout{Parameterization::Latlong, 64, 0};
    const EnvironmentMap fa = filtered(a, {.lobe = ggxLobe(0.25), .target = layout}),
                         fb = filtered(b, {.lobe = ggxLobe(0.25), .target = layout});
    for (int y = 0; y < 64; y += 5)
        for (int x = 0; x < 128; x += 5) {
            const double expected = fa.radiance(turned(texelDirection(layout, x, y))).x;
            EXPECT_NEAR(fb.image.texel(x, y)[0] / expected, 1.0, 3e-3); // the bilinear lookup in fa
        }
}

TEST(Prefilter, NamesTheFieldThatIsWrong)
{
    FilterSource source(noiseProbe(8, 1));
    const auto message = [&](const PrefilterOptions& options) -> std::string {
        try {
            prefilter(source, options);
        } catch (const InvalidArgument& e) {
            return e.what();
        }
        return "";
    };
    PrefilterOptions options;
    options.tolerance = 0.0;
    EXPECT_NE(message(options).find("tolerance"), std::string::npos);
    options = {};
    options.target.size = 0;
    EXPECT_NE(message(options).find("size"), std::string::npos);
    options = {};
    options.yaw = std::numeric_limits<double>::quiet_NaN();
    EXPECT_NE(message(options).find("yaw"), std::string::npos);
}

TEST(Prefilter, StopsWhenAsked)
{
    std::stop_source stop;
    stop.request_stop();
    FilterSource source(noiseProbe(32, 1));
    EXPECT_THROW(prefilter(source, {}, {.stop = stop.get_token()}), Cancelled);
}

TEST(Prefilter, AGgxChainRunsFromMirrorToFullyRough)
{
    EXPECT_EQ(chainRoughness(0, 9), 0.0);
    EXPECT_EQ(chainRoughness(4, 9), 0.5);
    EXPECT_EQ(chainRoughness(8, 9), 1.0);
    EXPECT_EQ(chainRoughness(0, 1), 0.0);
}

} // namespace
} // namespace mirrorball
