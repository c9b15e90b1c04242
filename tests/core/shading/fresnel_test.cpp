#include "core/shading/fresnel.h"

#include "core/base/error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <limits>

using namespace mirrorball;

namespace {

// Snell and the two amplitude ratios, derived apart from the code under test: refract, then divide.
long double amplitudeForm(long double cosTheta, std::complex<long double> eta)
{
    const std::complex<long double> sin2t = (1.0L - cosTheta * cosTheta) / (eta * eta);
    const std::complex<long double> cosT = std::sqrt(1.0L - sin2t);
    const auto rs = (cosTheta - eta * cosT) / (cosTheta + eta * cosT);
    const auto rp = (eta * cosTheta - cosT) / (eta * cosTheta + cosT);
    return 0.5L * (std::norm(rs) + std::norm(rp));
}

constexpr double indices[] = {1.0 + 1e-9, 1.0001, 1.33, 1.5, 2.42, 5.0, 200.0, 1e6, 0.9, 0.5, 0.1};

} // namespace

TEST(Fresnel, IsTheSquaredAmplitudeRatioAtNormalIncidence)
{
    for (const double n : indices) {
        const double r = (n - 1.0) / (n + 1.0);
        EXPECT_NEAR(fresnelDielectric(1.0, n), r * r, 1e-15 + 1e-12 * r * r) << n;
    }
}

TEST(Fresnel, KeepsItsRelativePrecisionWhenTheIndexIsNearlyOne)
{
    const double n = 1.0 + 1e-9;
    const double r = (n - 1.0) / (n + 1.0);
    EXPECT_NEAR(fresnelDielectric(1.0, n) / (r * r), 1.0, 1e-12);
}

TEST(Fresnel, ReflectsNothingWhenThereIsNoSurface)
{
    for (const double c : {0.0, 1e-300, 1e-9, 0.5, 1.0}) {
        EXPECT_EQ(fresnelDielectric(c, 1.0), 0.0) << c;
        EXPECT_EQ(fresnelConductor(c, 1.0, 0.0), 0.0) << c;
    }
}

TEST(Fresnel, ReflectsEverythingAtGrazingIncidence)
{
    for (const double n : indices)
        EXPECT_DOUBLE_EQ(fresnelDielectric(0.0, n), 1.0) << n;
    for (const double k : {1e-6, 0.1, 3.0, 100.0})
        EXPECT_DOUBLE_EQ(fresnelConductor(0.0, 1.0, k), 1.0) << k;
}

TEST(Fresnel, ReflectsOnlyTheCrossPolarisedHalfAtBrewstersAngle)
{
    for (const double n : {1.1, 1.5, 5.0, 0.8}) {
        const double c = 1.0 / std::sqrt(1.0 + n * n); // tan(theta) = n
        const double rs = (n * n - 1.0) / (n * n + 1.0);
        EXPECT_NEAR(fresnelDielectric(c, n), 0.5 * rs * rs, 1e-15) << n;
    }
}

TEST(Fresnel, IsTotalPastTheCriticalAngle)
{
    const double n = 1.0 / 1.5;
    const double critical = std::sqrt(1.0 - n * n);
    EXPECT_EQ(fresnelDielectric(critical - 1e-9, n), 1.0);
    EXPECT_EQ(fresnelDielectric(0.0, n), 1.0);
    EXPECT_LT(fresnelDielectric(critical + 1e-3, n), 1.0);
}

TEST(Fresnel, AgreesWithTheAmplitudeFormInLongDouble)
{
    for (const double n : indices)
        for (int i = 1; i <= 1000; ++i) {
            const double c = i / 1000.0;
            // Near the critical angle F is as steep as a square root: the rounding of c^2 shows in the thirteenth digit.
            EXPECT_NEAR(fresnelDielectric(c, n), static_cast<double>(amplitudeForm(c, n)), 1e-12) << n << " at " << c;
        }
}

TEST(Fresnel, OfAConductorAgreesWithTheAmplitudeFormInLongDouble)
{
    for (const double n : {0.05, 0.2, 1.0, 1.5, 3.0, 40.0})
        for (const double k : {1e-9, 1e-3, 0.5, 3.0, 9.0, 100.0})
            for (int i = 0; i <= 200; ++i) {
                const double c = i / 200.0;
                EXPECT_NEAR(fresnelConductor(c, n, k), static_cast<double>(amplitudeForm(c, {n, k})), 1e-12)
                    << n << " " << k << " at " << c;
            }
}

TEST(Fresnel, OfAConductorWithoutExtinctionIsTheDielectricOne)
{
    for (const double n : indices)
        for (int i = 1; i <= 100; ++i)
            EXPECT_NEAR(fresnelConductor(i / 100.0, n, 1e-14), fresnelDielectric(i / 100.0, n), 1e-6) << n << " at " << i;
}

TEST(Fresnel, StaysBetweenZeroAndOneEverywhere)
{
    for (const double n : {1e-6, 0.5, 1.0 - 1e-16, 1.0, std::nextafter(1.0, 2.0), 1.5, 200.0, 1e6, 1e100})
        for (const double k : {0.0, 1e-300, 1e-9, 1.0, 100.0})
            for (const double c : {0.0, std::numeric_limits<double>::denorm_min(), 1e-200, 1e-8, 0.1, 0.5, 1.0, 1.0 + 1e-7, -0.1}) {
                const double f = fresnelConductor(c, n, k);
                EXPECT_TRUE(f >= 0.0 && f <= 1.0) << f << " for n " << n << " k " << k << " cos " << c;
            }
}

TEST(Fresnel, TendsToAMirrorForLargeIndices)
{
    EXPECT_GT(fresnelDielectric(0.5, 1e6), 1.0 - 1e-5);
    EXPECT_GT(fresnelConductor(0.5, 1.0, 100.0), 0.99);
}

TEST(Fresnel, OfSchlickMeetsBothEnds)
{
    EXPECT_EQ(fresnelSchlick(1.0, 0.04), 0.04);
    EXPECT_EQ(fresnelSchlick(0.0, 0.04), 1.0);
}

TEST(Fresnel, OfAMaterialFollowsItsKind)
{
    EXPECT_EQ(reflectance({}, 0.3), glm::dvec3(1.0));
    const Fresnel glass{.kind = FresnelKind::Dielectric, .index = 1.5};
    EXPECT_EQ(reflectance(glass, 0.3), glm::dvec3(fresnelDielectric(0.3, 1.5)));
}

TEST(Fresnel, RefusesAnIndexThatIsNoIndex)
{
    EXPECT_THROW(validate(Fresnel{.kind = FresnelKind::Dielectric, .index = 0.0}), InvalidArgument);
    EXPECT_THROW(validate(Fresnel{.kind = FresnelKind::Dielectric, .index = std::nan("")}), InvalidArgument);
    EXPECT_THROW(validate(Fresnel{.kind = FresnelKind::Conductor, .conductor = {{1, 1, 1}, {0, -1, 0}}}), InvalidArgument);
    EXPECT_NO_THROW(validate(Fresnel{.kind = FresnelKind::Conductor, .conductor = {{1, 1, 1}, {0, 1, 100}}}));
}
