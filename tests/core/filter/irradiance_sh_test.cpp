#include "core/filter/irradiance_sh.h"

#include "core/filter/lobe.h"
#include "core/filter/prefilter.h"
#include "core/image/builtin_probes.h"
#include "support/probe_builders.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace mirrorball {
namespace {

/// The definition: the sum over the texels.
RadianceSh summed(const EnvironmentMap& map)
{
    RadianceSh sh;
    for (int y = 0; y < map.image.height; ++y)
        for (int x = 0; x < map.image.width; ++x) {
            const float* texel = map.image.texel(x, y);
            for (int i = 0; i < 9; ++i)
                sh.coefficients[static_cast<size_t>(i)] += texelSolidAngle(map.layout, x, y) * shNorm(i) *
                                                           shPolynomial(i, texelDirection(map.layout, x, y)) *
                                                           glm::dvec3(texel[0], texel[1], texel[2]);
        }
    return sh;
}

double largestDifference(const RadianceSh& a, const RadianceSh& b)
{
    double largest = 0.0;
    for (size_t i = 0; i < 9; ++i)
        for (int c = 0; c < 3; ++c)
            largest = std::max(largest, std::abs(a.coefficients[i][c] - b.coefficients[i][c]));
    return largest;
}

TEST(IrradianceSh, CoefficientsFromTheSpectrumAreTheSumsOverTheTexels)
{
    const EnvironmentMap probe = test::noiseProbe(32, 4);
    EXPECT_LT(largestDifference(radianceSh(analyze(probe, 4)), summed(probe)), 1e-9);
}

TEST(IrradianceSh, TurningThemIsTurningTheProbe)
{
    EnvironmentMap probe = test::noiseProbe(32, 4), shifted = probe; // a quarter turn is 16 columns
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 64; ++x)
            std::copy_n(probe.image.texel((x + 16) % 64, y), 3, shifted.image.texel(x, y));
    const glm::dvec3 from = texelDirection(probe.layout, 16, 8), to = texelDirection(probe.layout, 0, 8);
    const double yaw = std::atan2(to.x, to.z) - std::atan2(from.x, from.z);
    EXPECT_LT(largestDifference(turned(summed(probe), yaw), summed(shifted)), 1e-9);
}

TEST(IrradianceSh, OfAConstantIsThatConstant)
{
    const glm::dvec3 e = irradianceOverPi(summed(test::constantProbe(64)), glm::normalize(glm::dvec3(1.0, 2.0, -3.0)));
    EXPECT_NEAR(e.g, 1.0, 1e-4);
}

// ENGINES' figures: the axes probe in Filament's terms, c_i = k_i N_i L_i.
TEST(IrradianceSh, OfTheAxesProbeIsWhatFilamentShowed)
{
    const RadianceSh sh = summed(renderBuiltinProbe("axes", {Parameterization::Latlong, 256, 0}));
    const std::array<glm::dvec3, 4> expected{glm::dvec3(.37568, .31647, .32096), glm::dvec3(-.07577, .08112, -.06135),
                                             glm::dvec3(-.14617, -.07826, .12563), glm::dvec3(.12106, -.07979, -.08490)};
    for (int i = 0; i < 4; ++i)
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(shCosineFactor(i) * shNorm(i) * sh.coefficients[static_cast<size_t>(i)][c], expected[static_cast<size_t>(i)][c],
                        2e-3);
}

double leastOnAGrid(const RadianceSh& sh, int channel)
{
    const MapLayout grid{Parameterization::Latlong, 180, 0};
    double least = 1e300;
    for (int y = 0; y < grid.height(); ++y)
        for (int x = 0; x < grid.width(); ++x)
            least = std::min(least, irradianceOverPi(sh, texelDirection(grid, x, y))[channel]);
    return least;
}

RadianceSh oneSun()
{
    EnvironmentMap probe = test::constantProbe(64, 0.0f);
    probe.image.texel(30, 25)[0] = 1000.0f;
    return summed(probe);
}

TEST(IrradianceSh, BesideASunTheNineAreNegativeAndTheirFitIsNot)
{
    const RadianceSh sun = oneSun();
    EXPECT_NEAR(leastIrradianceOverPi(sun).r, leastOnAGrid(sun, 0), 1e-4 * sun.coefficients[0].r);
    EXPECT_LT(leastIrradianceOverPi(sun).r, -0.01);
    EXPECT_GE(leastOnAGrid(nonNegative(sun), 0), 0.0);
    EXPECT_GE(leastIrradianceOverPi(nonNegative(sun)).r, -1e-12);
}

double squaredDifference(const RadianceSh& a, const RadianceSh& b, int channel)
{
    double sum = 0.0;
    for (int i = 0; i < 9; ++i) {
        const double d =
            shCosineFactor(i) * (a.coefficients[static_cast<size_t>(i)][channel] - b.coefficients[static_cast<size_t>(i)][channel]);
        sum += d * d;
    }
    return sum;
}

/// What is done elsewhere: degrees scaled down until nothing is negative.
RadianceSh windowed(RadianceSh sh)
{
    const RadianceSh whole = sh;
    for (double share = 1.0; share > 0.0; share -= 0.01) {
        for (size_t i = 1; i < 9; ++i)
            sh.coefficients[i] = whole.coefficients[i] * (i < 4 ? share : share * share * share);
        if (leastOnAGrid(sh, 0) >= 0.0)
            break;
    }
    return sh;
}

TEST(IrradianceSh, NoOtherNonNegativeNineLoseLess)
{
    const RadianceSh sun = oneSun(), fit = nonNegative(sun);
    const double lost = squaredDifference(fit, sun, 0);
    EXPECT_LT(lost, 0.5 * squaredDifference(windowed(sun), sun, 0)) << "scaling degrees down is far from the least loss";
    // The nearest point of a convex set: from it, the way to any other point of the set leads away from the original.
    std::mt19937 generator(3);
    for (int trial = 0; trial < 2000; ++trial) {
        RadianceSh other = fit;
        for (size_t i = 0; i < 9; ++i)
            other.coefficients[i].r += 0.02 * fit.coefficients[0].r * (static_cast<double>(generator()) / 2147483648.0 - 1.0);
        if (leastIrradianceOverPi(other).r >= 0.0) {
            EXPECT_GE(squaredDifference(other, sun, 0), lost * (1.0 - 1e-6));
        }
    }
}

TEST(IrradianceSh, LightThatIsNowhereNegativeStaysAsItIs)
{
    const RadianceSh noise = summed(test::noiseProbe(32, 4));
    EXPECT_EQ(nonNegative(noise), noise);
    EXPECT_EQ(nonNegative(RadianceSh{}), RadianceSh{});
}

} // namespace
} // namespace mirrorball
