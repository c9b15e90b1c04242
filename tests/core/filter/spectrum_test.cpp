#include "core/filter/spectrum.h"
#include "support/probe_builders.h"

#include <gtest/gtest.h>

#include <numeric>

namespace mirrorball {
namespace {

using test::constantProbe;
using test::noiseProbe;

TEST(Spectrum, OfAConstantIsItsMean)
{
    const Spectrum s = analyze(constantProbe(64, 2.0f), 10);
    EXPECT_NEAR(s.coefficients[0][s.index(0, 0)].real(), 2.0 * std::sqrt(4.0 * pi), 1e-12);
    for (int l = 1; l <= 10; ++l)
        for (int m = 1; m <= l; ++m)
            EXPECT_NEAR(std::abs(s.coefficients[1][s.index(l, m)]), 0.0, 1e-12);
    EXPECT_NEAR(s.unit[0].real(), std::sqrt(4.0 * pi), 1e-12);
}

TEST(Spectrum, OfOneTexelFollowsTheAdditionTheorem)
{
    // sum_m |Y_lm(d)|^2 = (2l+1)/(4 pi), whatever d.
    EnvironmentMap probe = constantProbe(32, 0.0f);
    probe.image.texel(5, 9)[0] = 3.0f;
    const double flux = 3.0 * texelSolidAngle(probe.layout, 5, 9);
    const Spectrum s = analyze(probe, 100); // far beyond what 64 columns resolve
    for (int l = 0; l <= 100; ++l) {
        double power = 0.0;
        for (int m = 0; m <= l; ++m)
            power += (m == 0 ? 1.0 : 2.0) * std::norm(s.coefficients[0][s.index(l, m)]);
        EXPECT_NEAR(power / (flux * flux * (2 * l + 1) / (4.0 * pi)), 1.0, 1e-10) << l;
    }
}

TEST(Spectrum, OfAConstantHasNoPowerAboutItsMean)
{
    const std::vector<double> power = analyze(constantProbe(16, 3.0f), 80).powerAboutMean();
    EXPECT_NEAR(power[0], 3 * 9.0 * 4.0 * pi, 1e-9);
    for (size_t l = 1; l < power.size(); ++l)
        EXPECT_LT(power[l], 1e-24);
}

TEST(Spectrum, TruncatingRowsIsExact)
{
    const EnvironmentMap probe = noiseProbe(64, 3);
    const Spectrum truncated = analyze(probe, 12); // keeps rows of 128 texels at 30 samples
    const Spectrum whole = analyze(probe, 90);     // keeps them whole
    for (int m = 0; m <= 12; ++m)
        for (int l = m; l <= 12; ++l)
            EXPECT_NEAR(std::abs(truncated.coefficients[2][truncated.index(l, m)] - whole.coefficients[2][whole.index(l, m)]), 0.0, 1e-12);
}

TEST(Spectrum, BuiltBlockByBlockIsTheSame)
{
    const EnvironmentMap probe = noiseProbe(50, 4);
    SpectrumBuilder builder(100, 50, 20);
    for (int y = 0; y < 50; y += 7)
        builder.addRows(y, std::min(7, 50 - y), probe.image.row(y));
    const Spectrum streamed = builder.finish();
    EXPECT_EQ(streamed.coefficients, analyze(probe, 20).coefficients);
    EXPECT_EQ(streamed.peak, analyze(probe, 20).peak);
}

TEST(Spectrum, OfAConstantOneIsKnownBelowAndBeyondTheRowsLength)
{
    // Beyond the length of a row the constant is no longer zonal on the rings: both ways of getting its spectrum must be the transform's.
    for (const int bandLimit : {20, 70}) {
        const Spectrum s = analyze(constantProbe(32), bandLimit);
        for (size_t i = 0; i < s.unit.size(); ++i)
            EXPECT_NEAR(std::abs(s.unit[i] - s.coefficients[0][i]), 0.0, 1e-12);
    }
    const Spectrum s = analyze(constantProbe(32), 70);
    EXPECT_GT(std::abs(s.unit[s.index(70, 64)]), 1e-3);
}

TEST(Spectrum, DoesNotDependOnThreads)
{
    const EnvironmentMap probe = noiseProbe(64, 5);
    EXPECT_EQ(analyze(probe, 40, {.threads = 1}).coefficients, analyze(probe, 40, {.threads = 2}).coefficients);
}

TEST(Spectrum, OfTinyProbesIsFinite)
{
    for (const int width : {1, 2}) {
        EnvironmentMap probe(MapLayout{Parameterization::Latlong, 1, 0});
        probe.image = Image(width, 1, 3, 2.5f);
        const Spectrum s = analyze(probe, 8);
        EXPECT_NEAR(s.coefficients[0][0].real(), 2.5 * std::sqrt(4.0 * pi), 1e-12);
    }
}

} // namespace
} // namespace mirrorball
