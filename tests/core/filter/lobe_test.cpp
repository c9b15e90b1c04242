#include "core/base/error.h"
#include "core/filter/lobe.h"
#include "core/filter/lobe_row.h"
#include "core/sphere/direction.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace mirrorball {
namespace {

/// Integral of f over [0, 1] by Simpson's rule in u with c = u^4 (5 - 4u), which crowds the points at both ends: at the peak c = 1, and
/// at c = 0 where a fractional power has no derivative.
template <typename F>
long double integrate(F f, int steps = 200000)
{
    long double sum = 0.0L;
    const long double h = 1.0L / steps;
    for (int i = 0; i <= steps; ++i) {
        const long double u = i * h, c = u * u * u * u * (5.0L - 4.0L * u);
        sum += (i == 0 || i == steps ? 1.0L : i % 2 ? 4.0L : 2.0L) * f(c) * 20.0L * u * u * u * (1.0L - u);
    }
    return sum * h / 3.0L;
}

std::vector<Lobe> someLobes()
{
    return {phongLobe(0.0),    phongLobe(1e-3),
            phongLobe(0.5),    phongLobe(1.0),
            phongLobe(7.3),    phongLobe(50.0),
            phongLobe(5000.0), diffuseLobe(),
            ggxLobe(0.01),     ggxLobe(0.09),
            ggxLobe(0.36),     ggxLobe(0.9999),
            ggxLobe(1.0),      tabulatedLobe({0.0, 0.1, 0.5, 3.0, 1.0})};
}

/// A lobe that is made of a word and a number holds that number where its row says, and is described by both.
TEST(LobeRows, MakeTheLobesThatTheyDescribe)
{
    const std::vector<Lobe> tried = someLobes();
    for (const LobeRow& row : lobeRows) {
        EXPECT_EQ(rowOf(row.kind).word, row.word);
        EXPECT_TRUE(std::any_of(tried.begin(), tried.end(), [&](const Lobe& lobe) { return lobe.kind == row.kind; })) << row.word;
        if (!row.make)
            continue;
        const Lobe lobe = row.make(0.25);
        EXPECT_EQ(lobe.kind, row.kind) << row.word;
        EXPECT_EQ(describe(lobe), std::string(row.word) + (row.value ? ":0.25" : ""));
        if (row.value) {
            EXPECT_EQ(lobe.*row.value, 0.25) << row.word;
        }
    }
    EXPECT_EQ(describe(tabulatedLobe({0.0, 1.0, 2.0})), "tabulated:3");
}

TEST(Lobe, IntegratesToOneOverTheSphere)
{
    for (const Lobe& lobe : someLobes()) {
        const LobeShape shape(lobe);
        const double sphere =
            2.0 * pi *
            static_cast<double>(integrate([&](long double c) { return static_cast<long double>(shape.relative(static_cast<double>(c))); }));
        EXPECT_NEAR(sphere / shape.integral(), 1.0, lobe.kind == LobeKind::Tabulated ? 1e-7 : 1e-9) << describe(lobe);
    }
}

TEST(Lobe, IsZeroAtAndBelowItsHorizon)
{
    for (const Lobe& lobe : someLobes()) {
        EXPECT_EQ(LobeShape(lobe).relative(0.0), 0.0) << describe(lobe);
        EXPECT_EQ(LobeShape(lobe).relative(-0.5), 0.0) << describe(lobe);
    }
}

TEST(Lobe, PhongCoefficientsAreTheIntegralsOfPolynomials)
{
    // k_l = (n+1) integral c^n P_l(c): for P_2 = (3c^2 - 1)/2 and P_3 = (5c^3 - 3c)/2 term by term.
    for (const double n : {0.0, 0.5, 1.0, 3.0, 50.0, 1e4, 1e9}) {
        const auto k = legendreCoefficients(phongLobe(n), 3);
        EXPECT_NEAR(k[0], 1.0, 0.0);
        EXPECT_NEAR(k[1], (n + 1) / (n + 2), 1e-15);
        EXPECT_NEAR(k[2], (n + 1) * (1.5 / (n + 3) - 0.5 / (n + 1)), 1e-14);
        EXPECT_NEAR(k[3], (n + 1) * (2.5 / (n + 4) - 1.5 / (n + 2)), 1e-13);
    }
}

TEST(Lobe, DiffuseCoefficientsAreRamamoorthisAndHanrahans)
{
    // "An Efficient Representation for Irradiance Environment Maps" (2001) eq. 8, over pi: 1, 2/3, 1/4, 0, -1/24, 0, 1/64.
    const auto k = legendreCoefficients(diffuseLobe(), 6);
    const double expected[] = {1.0, 2.0 / 3.0, 1.0 / 4.0, 0.0, -1.0 / 24.0, 0.0, 1.0 / 64.0};
    for (size_t l = 0; l < 7; ++l)
        EXPECT_NEAR(k[l], expected[l], 1e-16);
}

TEST(Lobe, QuadratureAgreesWithAnIndependentIntegral)
{
    for (const double alpha : {0.02, 0.1, 0.5, 0.95}) {
        const Lobe lobe = ggxLobe(alpha);
        const LobeShape shape(lobe);
        const auto k = legendreCoefficients(lobe, 40);
        for (const int l : {1, 2, 7, 40}) {
            const auto integrand = [&](long double c) {
                return static_cast<long double>(shape.relative(static_cast<double>(c)) *
                                                std::legendre(static_cast<unsigned>(l), static_cast<double>(c)));
            };
            EXPECT_NEAR(k[static_cast<size_t>(l)], 2.0 * pi * static_cast<double>(integrate(integrand)) / shape.integral(), 1e-9)
                << alpha << " l=" << l;
        }
    }
}

/// k_l by the midpoint rule in t, which converges fast once its steps are small against the peak and the waves of P_l; Richardson's
/// extrapolation makes the order four.
std::vector<double> byMidpoints(const Lobe& lobe, int bandLimit, int steps)
{
    const LobeShape shape(lobe);
    std::vector<double> k(static_cast<size_t>(bandLimit) + 1, 0.0);
    for (int i = 0; i < steps; ++i) {
        // Steps that grow with t, t = s^3 pi/2: most of them lie under the peak.
        const double s = (i + 0.5) / steps, t = 0.5 * pi * s * s * s, c = std::cos(t);
        const double weight = shape.relative(c) * std::sin(t) * 1.5 * pi * s * s / steps;
        double previous = 0.0, p = 1.0;
        for (int l = 0; l <= bandLimit; ++l) {
            k[static_cast<size_t>(l)] += weight * p;
            previous = std::exchange(p, ((2.0 * l + 1.0) * c * p - l * previous) / (l + 1.0));
        }
    }
    return k;
}

TEST(Lobe, GgxCoefficientsAreTheIntegralToANinthDigitWhicheverWayTheirRecurrenceRuns)
{
    // Upwards, as a system, and as a series near 1, and on both sides of where one takes over from another.
    for (const double alpha : {0.004, 0.0045, 0.0047, 0.01, 0.09, 0.5, 0.904, 0.906, 0.97}) {
        constexpr int bandLimit = 768;
        const std::vector<double> k = legendreCoefficients(ggxLobe(alpha), bandLimit);
        const std::vector<double> coarse = byMidpoints(ggxLobe(alpha), bandLimit, 6000),
                                  fine = byMidpoints(ggxLobe(alpha), bandLimit, 12000);
        double largest = 0.0;
        for (size_t l = 0; l < k.size(); ++l) {
            const double expected = (4.0 * fine[l] - coarse[l]) / (4.0 * fine[0] - coarse[0]);
            largest = std::max(largest, std::abs(k[l] - expected));
        }
        EXPECT_LT(largest, 1e-9) << alpha;
    }
}

TEST(Lobe, FullyRoughGgxIsTheDiffuseLobe) // D is constant at alpha = 1, which leaves the cosine
{
    const auto ggx = legendreCoefficients(ggxLobe(1.0), 64);
    const auto diffuse = legendreCoefficients(diffuseLobe(), 64);
    for (size_t l = 0; l <= 64; ++l)
        EXPECT_NEAR(ggx[l], diffuse[l], 1e-12);
}

TEST(Lobe, TabulatedSquaredCosineIsPhongTwo)
{
    std::vector<double> samples;
    for (int i = 0; i <= 2000; ++i)
        samples.push_back(std::pow(i / 2000.0, 2));
    const auto tabulated = legendreCoefficients(tabulatedLobe(samples), 20);
    const auto phong = legendreCoefficients(phongLobe(2.0), 20);
    for (size_t l = 0; l <= 20; ++l) // the table is linear between samples: c^2 is off by up to (1/2000)^2/4
        EXPECT_NEAR(tabulated[l], phong[l], 1e-6);
}

TEST(Lobe, KnowsItsWidth)
{
    EXPECT_NEAR(std::pow(std::cos(LobeShape(phongLobe(50)).halfWidth()), 50), 0.5, 1e-12);
    EXPECT_NEAR(LobeShape(phongLobe(1e9)).halfWidth(), std::sqrt(2.0 * std::log(2.0) / 1e9), 1e-12);
    EXPECT_DOUBLE_EQ(LobeShape(phongLobe(0)).halfWidth(), pi / 2);
    EXPECT_NEAR(LobeShape(diffuseLobe()).halfWidth(), pi / 3, 1e-12);
    const LobeShape ggx(ggxLobe(0.05));
    EXPECT_NEAR(ggx.relative(std::cos(ggx.halfWidth())), 0.5, 1e-9);
}

TEST(Lobe, TakesPowersInLogSpace)
{
    EXPECT_EQ(LobeShape(phongLobe(1e9)).relative(0.5), 0.0);
    EXPECT_NEAR(LobeShape(phongLobe(1e9)).logRelative(0.5), 1e9 * std::log(0.5), 1.0);
    EXPECT_EQ(LobeShape(phongLobe(1e9)).relative(1.0), 1.0);
}

TEST(Lobe, RefusesWhatIsOutOfRange)
{
    EXPECT_THROW(phongLobe(-1.0), InvalidArgument);
    EXPECT_THROW(phongLobe(std::numeric_limits<double>::quiet_NaN()), InvalidArgument);
    EXPECT_THROW(phongLobe(std::numeric_limits<double>::infinity()), InvalidArgument);
    EXPECT_THROW(ggxLobe(1.1), InvalidArgument);
    EXPECT_THROW(ggxLobe(-0.1), InvalidArgument);
    EXPECT_THROW(tabulatedLobe({1.0}), InvalidArgument);
    EXPECT_THROW(tabulatedLobe({0.0, 0.0}), InvalidArgument);
    EXPECT_THROW(tabulatedLobe({-1.0, 2.0}), InvalidArgument);
}

TEST(Lobe, IsUnresolvedUnderOneAndAHalfTexels)
{
    // Full width at half maximum of phong(n) is 2.355/sqrt(n) for large n: 1.5 texels of a 1024 map are n = 65500.
    EXPECT_FALSE(isUnresolved(phongLobe(60000), 1024));
    EXPECT_TRUE(isUnresolved(phongLobe(70000), 1024));
    EXPECT_FALSE(isUnresolved(phongLobe(70000), 2048));
    EXPECT_TRUE(isUnresolved(ggxLobe(0.0), 16384));
}

} // namespace
} // namespace mirrorball
