#include "core/filter/view_stack.h"

#include "core/filter/brdf_sum.h"
#include "core/report/brdf_errors.h"
#include "core/shading/reflection_kernel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace mirrorball {
namespace {

/// Smooth, and at no place alike all around it: a lamp, a strip, and a dim sky.
EnvironmentMap smoothProbe(double lampWidth = 40.0)
{
    EnvironmentMap map({Parameterization::Latlong, 32, 0});
    const glm::dvec3 lamp = glm::normalize(glm::dvec3(0.5, 0.7, 0.6));
    for (int y = 0; y < map.image.height; ++y)
        for (int x = 0; x < map.image.width; ++x) {
            const glm::dvec3 d = texelDirection(map.layout, x, y);
            const double light = std::exp(lampWidth * (glm::dot(d, lamp) - 1.0)), strip = std::exp(-12.0 * d.y * d.y) * (1.2 + d.x);
            const glm::dvec3 value(0.3 + 4.0 * light + strip, 0.3 + 3.0 * light + 0.5 * strip, 0.4 + 2.0 * light);
            for (int c = 0; c < 3; ++c)
                map.image.texel(x, y)[c] = static_cast<float>(value[c]);
        }
    return map;
}

struct Seen {
    glm::dvec3 r;
    double viewDeg, azimuthDeg;
};

/// The worst error at some frames, as a share of the brute-force sum.
double worstError(const ViewStack& stack, const EnvironmentMap& probe, const Brdf& brdf, std::span<const Seen> frames)
{
    double worst = 0.0;
    for (const Seen& seen : frames) {
        const double view = glm::radians(seen.viewDeg);
        const glm::dvec3 r = glm::normalize(seen.r), n = normalAt(r, {view, glm::radians(seen.azimuthDeg)});
        const glm::dvec3 truth = BrdfSum(probe, brdf, view).at(std::span(&n, 1), std::span(&r, 1)).front();
        worst = std::max(worst, glm::length(reflected(stack, n, r) - truth) / glm::length(truth));
    }
    return worst;
}

const std::vector<Seen> someFrames{{{0.3, 0.2, 0.9}, 10, 20},    {{-0.6, 0.5, 0.3}, 22, 130},  {{0.2, -0.7, 0.5}, 31, 250},
                                   {{0.9, 0.1, -0.3}, 40, 80},   {{-0.2, 0.9, -0.3}, 48, 300}, {{0.5, 0.4, -0.8}, 55, 10},
                                   {{-0.8, -0.3, 0.4}, 63, 200}, {{0.1, 0.3, -0.9}, 69, 340},  {{0.7, 0.6, 0.4}, 75, 110},
                                   {{-0.4, 0.1, -0.9}, 72, 45},  {{0.6, -0.2, 0.7}, 58, 160},  {{0.0, 0.5, 0.9}, 36, 270}};

TEST(ViewStack, IsTheIntegralAtAnyAngleOfView)
{
    const EnvironmentMap probe = smoothProbe();
    FilterSource source(probe);
    for (const char* model : {"ggx:roughness=0.5,metal=gold", "ggx:roughness=0.7", "ward:alpha=0.3"}) {
        const Brdf brdf = brdfFromText(model);
        const ViewStack stack = makeViewStack(source, brdf);
        EXPECT_EQ(stack.tolerance, 1e-2) << model;
        EXPECT_LT(stack.predictedError, 1e-2) << model;
        EXPECT_LT(worstError(stack, probe, brdf, someFrames), 2e-2) << model;
    }
}

TEST(ViewStack, OfOrderZeroAloneMissesWhatIsNotAlikeAllAround)
{
    const EnvironmentMap probe = smoothProbe();
    FilterSource source(probe);
    const Brdf brdf = brdfFromText("ggx:roughness=0.6");
    ViewStack stack = makeViewStack(source, brdf);
    for (ViewStack::Node& node : stack.nodes)
        node.orders = 0;
    EXPECT_GT(worstError(stack, probe, brdf, someFrames), 0.1);
}

// The frames of A_m have poles and the map an edge; what is reflected has neither.
TEST(ViewStack, HasNeitherPolesNorSeam)
{
    const EnvironmentMap probe = smoothProbe();
    FilterSource source(probe);
    const Brdf brdf = brdfFromText("ggx:roughness=0.5");
    const ViewStack stack = makeViewStack(source, brdf);
    std::vector<Seen> frames;
    for (const double azimuth : {0.0, 100.0, 225.0}) {
        for (const double x : {0.0, 1e-4, 0.01, -0.02, 0.04})
            for (const double y : {1.0, -1.0})
                frames.push_back({{x, y, 0.3 * x}, 60, azimuth});
        for (const double x : {1e-5, -1e-5, 0.02})
            frames.push_back({{x, 0.2, -1.0}, 60, azimuth});
    }
    EXPECT_LT(worstError(stack, probe, brdf, frames), 2e-2);
    // Across a pole nothing jumps: the same surface, its mirror direction a hair this and that side of it.
    for (const double up : {1.0, -1.0}) {
        const glm::dvec3 n = glm::normalize(glm::dvec3(0.3, 0.5 * up, -0.7));
        const glm::dvec3 a = reflected(stack, n, glm::normalize(glm::dvec3(1e-7, up, 1e-7)));
        for (const glm::dvec3& beside : {glm::dvec3(-1e-7, up, 0.0), glm::dvec3(0.0, up, -1e-7), glm::dvec3(0.0, up, 0.0)})
            EXPECT_LT(glm::length(reflected(stack, n, glm::normalize(beside)) - a), 1e-3 * glm::length(a));
    }
}

TEST(ViewStack, InAFurnaceReflectsTheDirectionalAlbedo)
{
    EnvironmentMap white({Parameterization::Latlong, 16, 0});
    std::fill(white.image.texels.begin(), white.image.texels.end(), 1.0f);
    FilterSource source(white);
    const Brdf brdf = brdfFromText("ggx:roughness=0.6,metal=copper");
    const ViewStack stack = makeViewStack(source, brdf);
    for (const double degrees : {0.0, 20.0, 45.0, 70.0, 80.0, 86.0}) {
        const double view = glm::radians(degrees);
        const glm::dvec3 r = glm::normalize(glm::dvec3(0.2, 0.5, -0.7)), albedo = directionalAlbedo(brdf, view);
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(reflected(stack, normalAt(r, {view, 1.0}), r)[c], albedo[c], 5e-3)
                << degrees; // texels of so small a probe count as bright ones, without the norm of a sum
    }
}

// A sun goes through the kernel and not through harmonics, so that no degree is missed; orders and views are those of the tolerance, which
// is one of all frames together, dark ones included.
TEST(ViewStack, FollowsASun)
{
    EnvironmentMap probe = smoothProbe();
    for (int c = 0; c < 3; ++c)
        probe.image.texel(20, 9)[c] = 4000.0f;
    FilterSource source(probe);
    const Brdf brdf = brdfFromText("ggx:roughness=0.7");
    const ViewStack stack = makeViewStack(source, brdf, {.tolerance = 0.03});
    EXPECT_EQ(stack.tolerance, 0.03);
    for (const double degrees : {15.0, 45.0, 70.0}) {
        const double view = glm::radians(degrees);
        const BrdfFrames frames(probe, brdf, view);
        const double error = frames.relRms([&](double azimuth) {
            EnvironmentMap map(frames.layout());
            for (int y = 0; y < map.image.height; ++y)
                for (int x = 0; x < map.image.width; ++x) {
                    const glm::dvec3 r = texelDirection(map.layout, x, y), light = reflected(stack, normalAt(r, {view, azimuth}), r);
                    for (int c = 0; c < 3; ++c)
                        map.image.texel(x, y)[c] = static_cast<float>(light[c]);
                }
            return map;
        });
        EXPECT_LT(error, stack.tolerance) << degrees;
    }
}

TEST(ViewStack, TurnsWithTheProbe)
{
    const EnvironmentMap probe = smoothProbe();
    FilterSource source(probe);
    const Brdf brdf = brdfFromText("ggx:roughness=0.6");
    const ViewStack plain = makeViewStack(source, brdf), turned = makeViewStack(source, brdf, {.yaw = 0.7});
    for (const Seen& seen : someFrames) {
        const glm::dvec3 r = glm::normalize(seen.r), n = normalAt(r, {glm::radians(seen.viewDeg), glm::radians(seen.azimuthDeg)});
        const glm::dvec3 expected = reflected(plain, n, r);
        EXPECT_LT(glm::length(reflected(turned, yawed(n, 0.7), yawed(r, 0.7)) - expected), 1e-2 * glm::length(expected));
    }
}

TEST(ViewStack, OfANarrowLobeSaysWhatItKeeps)
{
    const EnvironmentMap probe = smoothProbe();
    FilterSource source(probe);
    const ViewStack small = makeViewStack(source, brdfFromText("ggx:roughness=0.4"), {.mostTexels = 1 << 18});
    EXPECT_GT(small.tolerance, 1e-2);
    EXPECT_GT(small.predictedError, 5e-3);
    EXPECT_LE(static_cast<double>(small.layers.size()) * small.layers[0].width * small.layers[0].height, 1 << 18);
    const ViewStack mirror = makeViewStack(source, brdfFromText("ggx:roughness=0.04"));
    ASSERT_EQ(mirror.nodes.size(), 1u);
    const glm::dvec3 r = texelDirection(probe.layout, 11, 7);
    EXPECT_LT(glm::length(reflected(mirror, r, r) - glm::dvec3(glm::vec3(probe.radiance(r)))), 1e-5) << "a lookup times the albedo, 1";
}

} // namespace
} // namespace mirrorball
