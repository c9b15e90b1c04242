#include "core/filter/paraboloid_kernel.h"

#include "core/sphere/direction.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace mirrorball {
namespace {

double reachOfPhong(double exponent, double clamp) { return std::acos(std::pow(clamp, 1.0 / exponent)); }

/// The table of 000 section 3.2.5: a half of 512 texels, clamped at 0.1, with a convolution of at most 7 texels.
TEST(ParaboloidKernel, SizesAndShrinkFactorsAreThoseOfThePublishedTable)
{
    struct Row {
        double exponent;
        KernelSizes sizes;
    };
    const Row table[] = {
        {10, {174, 260, 32, 64}}, {50, {78, 136, 16, 32}}, {100, {56, 100, 8, 16}}, {250, {36, 66, 8, 16}}, {500, {26, 48, 4, 8}}};
    for (const Row& row : table) {
        EXPECT_EQ(kernelSizes(reachOfPhong(row.exponent, 0.1), 512, 7), row.sizes) << "exponent " << row.exponent;
        EXPECT_NEAR(LobeShape(phongLobe(row.exponent)).support(0.1), reachOfPhong(row.exponent, 0.1), 1e-6) << "the lobe's own reach";
    }
}

/// "The ratio between the smallest filter radius and largest filter radius is 1 : 2", of lobes so narrow that a half is flat under them.
TEST(ParaboloidKernel, NarrowLobesAreTwiceAsLargeAtTheRim)
{
    const KernelSizes sizes = kernelSizes(1e-3, 1 << 22, 7);
    EXPECT_NEAR(static_cast<double>(sizes.large) / sizes.small, 2.0, 0.003);
}

TEST(ParaboloidKernel, TapsAreTheLobeAtTheAnglesTheyStandFor)
{
    const double reach = reachOfPhong(100.0, 0.1);
    const SampledKernel kernel = sampleKernel(phongLobe(100), reach, 512, 8, KernelPlace::Middle);
    ASSERT_EQ(kernel.side(), 7);
    const auto weight = [&](int x, int y) { return kernel.weights[static_cast<size_t>((y + 3) * 7 + x + 3)]; };
    EXPECT_NEAR(std::accumulate(kernel.weights.begin(), kernel.weights.end(), 0.0), 1.0, 1e-12);
    for (int y = -3; y <= 3; ++y)
        for (int x = -3; x <= 3; ++x) {
            // In the middle of the half cos t = (1 - s^2)/(1 + s^2) at the distance s.
            const double s2 = (x * x + y * y) * 64.0 / (256.0 * 256.0);
            const double power = std::pow((1.0 - s2) / (1.0 + s2), 100.0);
            EXPECT_NEAR(weight(x, y) / weight(0, 0), power >= 0.1 ? power : 0.0, 1e-12) << x << ' ' << y;
        }
    // At the rim the tap towards the middle, s away, is 90 degrees - 2 atan(1 - s) from it.
    const SampledKernel rim = sampleKernel(phongLobe(100), reach, 512, 16, KernelPlace::Rim);
    ASSERT_EQ(rim.side(), 7);
    const double ratio = rim.weights[3 * 7 + 2] / rim.weights[3 * 7 + 3];
    EXPECT_NEAR(ratio, std::pow(std::cos(0.5 * pi - 2.0 * std::atan(1.0 - 1.0 / 16.0)), 100.0), 1e-12);
}

TEST(ParaboloidKernel, ShrunkKernelsFitTheLargestSize)
{
    for (const double exponent : {0.5, 1.0, 3.0, 10.0, 77.0, 1000.0})
        for (const double clamp : {0.3, 0.1, 1e-3})
            for (const int largest : {3, 5, 7, 15}) {
                const double reach = LobeShape(phongLobe(exponent)).support(clamp);
                const KernelSizes sizes = kernelSizes(reach, 512, largest);
                EXPECT_LE(sampleKernel(phongLobe(exponent), reach, 512, sizes.smallShrink, KernelPlace::Middle).side(), largest + 1);
                EXPECT_LE(sampleKernel(phongLobe(exponent), reach, 512, sizes.largeShrink, KernelPlace::Rim).side(), largest + 1);
                EXPECT_TRUE(sizes.smallShrink == 1 || 2.0 * sizes.small / sizes.smallShrink > largest) << "no smaller than it must be";
            }
}

TEST(ParaboloidKernel, TheBorderTakesTheLargeKernelAndIsWholeShrunkTexels)
{
    const double reach = reachOfPhong(10.0, 0.1);
    const KernelSizes sizes = kernelSizes(reach, 512, 7);
    const SampledKernel large = sampleKernel(phongLobe(10), reach, 512, sizes.largeShrink, KernelPlace::Rim);
    const int side = blendedHalfSide(sizes, large, 512, 0);
    EXPECT_EQ(side % (2 * sizes.largeShrink), 0);
    EXPECT_GE((side - 512) / 2, sizes.large / 2);
    EXPECT_EQ(blendedHalfSide(sizes, large, 512, 64), 640) << "the paper's border of 64 texels needs no rounding";
}

TEST(ParaboloidKernel, MapsAreBlendedByTheSquareOfTheDistance)
{
    EXPECT_EQ(largeKernelShare(0.0), 0.0);
    EXPECT_EQ(largeKernelShare(0.5), 0.25) << "25 % of map L, as the paper says";
    EXPECT_EQ(largeKernelShare(1.0), 1.0);
    EXPECT_EQ(largeKernelShare(1.01), 1.0) << "a corner beyond the rim";
}

glm::dvec3 lifted(const glm::dvec2& q)
{
    const double q2 = glm::dot(q, q);
    return glm::dvec3(2.0 * q, 1.0 - q2) / (1.0 + q2);
}

/// Figure 12. A circle in the map comes back to the sphere as an exact circle, all of it in one plane; its middle is displaced, which is
/// the distortion, up to about a quarter of the radius.
TEST(ParaboloidKernel, DistortionOfACircleIsThatOfFigure12)
{
    double largest = 0.0;
    for (const double d : {0.0, 0.25, 0.5, 0.75, 1.0})
        for (const double r : {0.05, 0.1, 0.2, 0.3, 0.4, 0.5}) {
            const glm::dvec3 a = lifted({d + r, 0.0}), b = lifted({d, r}), c = lifted({d - r, 0.0}), middle = lifted({d, 0.0});
            const glm::dvec3 normal = glm::normalize(glm::cross(b - a, c - a));
            double nearest = 10.0, farthest = 0.0;
            for (int i = 0; i < 720; ++i) {
                const double angle = pi * i / 360.0;
                const glm::dvec3 point = lifted({d + r * std::cos(angle), r * std::sin(angle)});
                ASSERT_NEAR(glm::dot(point - a, normal), 0.0, 1e-12) << "not a circle: d " << d << " r " << r;
                const double distance = std::acos(glm::clamp(glm::dot(point, middle), -1.0, 1.0));
                nearest = std::min(nearest, distance);
                farthest = std::max(farthest, distance);
            }
            EXPECT_NEAR(circleDistortion(d, r), (farthest - nearest) / (farthest + nearest), 1e-6) << "d " << d << " r " << r;
            largest = std::max(largest, circleDistortion(d, r));
        }
    EXPECT_NEAR(largest, 0.24, 0.005) << "\"the distortion goes up to 25% for large radii\"";
    EXPECT_LT(circleDistortion(0.5, 0.05), 0.025) << "\"for smaller radii the distortion remains fairly small\"";
    EXPECT_EQ(circleDistortion(0.0, 0.5), 0.0);
    for (const double r : {0.1, 0.3, 0.5})
        for (double d = 0.05; d <= 1.0; d += 0.05)
            EXPECT_GT(circleDistortion(d, r), circleDistortion(d - 0.05, r)) << "grows with d";
}

TEST(ParaboloidKernel, ACapIsTheCircleItsBoundaryProjectsTo)
{
    for (const glm::dvec3& axis : {glm::dvec3(0, 0, 1), glm::dvec3(1, 0, 0), glm::dvec3(0.3, -0.8, 0.5), glm::dvec3(-0.6, 0.1, -0.2)})
        for (const double t : {0.01, 0.2, 0.7, 1.2}) {
            const glm::dvec3 r = glm::normalize(axis);
            if (r.z + std::cos(t) < 0.05)
                continue;
            const CapCircle circle = circleOfCap(r, t);
            const glm::dvec3 u = glm::normalize(glm::cross(r, glm::dvec3(0.2, 0.9, 0.1))), v = glm::cross(r, u);
            for (int i = 0; i < 100; ++i) {
                const double angle = 2.0 * pi * i / 100.0;
                const glm::dvec3 p = std::cos(t) * r + std::sin(t) * (std::cos(angle) * u + std::sin(angle) * v);
                const glm::dvec2 q = glm::dvec2(p.x, p.y) / (1.0 + p.z);
                ASSERT_NEAR(glm::distance(q, circle.center), circle.radius, 1e-10 * (1.0 + circle.radius));
            }
            // The center of the circle is not the projection of the cap's center, except in the middle.
            const glm::dvec2 projected = glm::dvec2(r.x, r.y) / (1.0 + r.z);
            if (glm::length(projected) < 1e-9) {
                EXPECT_LT(glm::distance(projected, circle.center), 1e-12);
            } else if (t > 0.1) {
                EXPECT_GT(glm::distance(projected, circle.center), 0.01 * circle.radius);
            }
        }
}

TEST(ParaboloidKernel, CubicWeightsReproduceEveryCubic)
{
    for (const double f : {0.0, 0.2, 0.5, 0.9, 1.0}) {
        const std::array<double, 4> w = cubicWeights(f);
        for (int power = 0; power < 4; ++power) {
            double sum = 0.0;
            for (int i = 0; i < 4; ++i)
                sum += w[static_cast<size_t>(i)] * std::pow(i - 1.0, power);
            EXPECT_NEAR(sum, std::pow(f, power), 1e-14);
        }
    }
}

} // namespace
} // namespace mirrorball
