#include "core/filter/lookup_products.h"

#include "core/filter/lobe.h"
#include "core/shading/reflection_kernel.h"

#include <gtest/gtest.h>

#include <cmath>

namespace mirrorball {
namespace {

TEST(CubicTaps, ReadACubicExactlyAndStayInsideOfTheTable)
{
    const auto cubic = [](double x) { return 2.0 - x + 0.3 * x * x - 0.1 * x * x * x; };
    for (const double x : {0.0, 0.4, 1.0, 3.7, 7.2, 9.0}) {
        const CubicTaps taps = CubicTaps::at(x, 10);
        ASSERT_LE(taps.first + 4, 10u) << x;
        double sum = 0.0;
        for (size_t i = 0; i < 4; ++i)
            sum += taps.weight[i] * cubic(static_cast<double>(taps.first + i));
        EXPECT_NEAR(sum, cubic(x), 1e-12) << x;
    }
    EXPECT_EQ(CubicTaps::at(-3.0, 10).weight[0], 1.0);
    EXPECT_EQ(CubicTaps::at(30.0, 10).weight[3], 1.0);
}

TEST(LobeProducts, AreTheSumsOverDegrees)
{
    const int bandLimit = 96;
    const auto products = LobeProducts::of(bandLimit);
    EXPECT_EQ(products, LobeProducts::of(bandLimit)) << "made once";
    for (const auto& [a, b] : {std::pair{0.1, 0.1}, {0.1, 0.4}, {0.4, 1.0}})
        for (const double distance : {0.0, 0.05, 0.3, 1.2, 3.0}) {
            const auto ka = legendreCoefficients(ggxLobe(a), bandLimit), kb = legendreCoefficients(ggxLobe(b), bandLimit);
            double sum = 0.0;
            for (int l = 1; l <= bandLimit; ++l) // (2l+1)/(4 pi) of the lobes' product times p_l/(2l+1)
                sum += ka[static_cast<size_t>(l)] * kb[static_cast<size_t>(l)] *
                       std::legendre(static_cast<unsigned>(l), std::cos(distance)) / (4.0 * pi * std::pow(1.0 + l * l / 2500.0, 2.0));
            EXPECT_NEAR(products->at(LobeProducts::taps(a), LobeProducts::taps(b), std::cos(distance)), sum, 3e-5)
                << a << ' ' << b << ' ' << distance;
        }
}

// A kernel that is a lobe has in common with lobes what that lobe has. Phong's seen straight on is one about r.
TEST(KernelProducts, OfALobeAreThoseOfTheLobe)
{
    const int bandLimit = 64;
    const KernelSpectrum spectrum = kernelSpectrum(ReflectionKernel(Brdf{PhongBrdf{30.0}}, 0.0), bandLimit, 8);
    const KernelProducts products(spectrum);
    const ExactProducts exact(spectrum);
    const std::vector<double> phong = legendreCoefficients(phongLobe(30.0), bandLimit);
    for (const double offset : {-0.7, 0.0, 0.2, 1.0}) {
        const glm::dvec3 axis = lookupAxis(offset, 0.3);
        const double expected = exact.lobes(phong, exact.lobe(0.2), axis.z);
        EXPECT_NEAR(exact.kernel(exact.lobe(0.2), axis).g, expected, 1e-6) << offset;
        EXPECT_NEAR(products.at(LobeProducts::taps(0.2), axis), expected, 3e-5) << offset;
    }
    EXPECT_NEAR(products.square(), exact.lobes(phong, phong, 1.0), 1e-6);
    EXPECT_NEAR(exact.square(0), products.square(), 1e-6);
}

TEST(KernelProducts, AreTheSumsOverOrdersAlongAndAcrossThePlaneOfIncidence)
{
    const KernelSpectrum spectrum = kernelSpectrum(ReflectionKernel(Brdf{GgxBrdf{0.25}}, 1.0), 96, 24);
    const KernelProducts products(spectrum);
    const ExactProducts exact(spectrum);
    for (const double offset : {-0.5, 0.1, 0.8})
        for (const double turn : {0.0, 0.4, -0.4}) {
            const glm::dvec3 axis = lookupAxis(offset, turn);
            const double sum = exact.kernel(exact.lobe(0.15), axis).g;
            EXPECT_NEAR(products.at(LobeProducts::taps(0.15), axis), sum, 1e-4 * products.square()) << offset << ' ' << turn;
            EXPECT_NEAR(exact.kernel(exact.lobe(0.15), lookupAxis(offset, -turn)).g, sum, 1e-12) << "the sides are alike";
        }
}

TEST(OrderHarmonics, AddUpAsOneByOne)
{
    const int bandLimit = 40;
    std::vector<double> gammas, scales;
    for (int i = 0; i < 37; ++i) {
        gammas.push_back(0.003 + 0.08 * i);
        scales.push_back(std::sin(1.0 + i));
    }
    for (const int m : {0, 1, 5, 40}) {
        const OrderHarmonics harmonics(m, bandLimit);
        std::vector<double> sums(bandLimit + 1, 1.0), expected(bandLimit + 1, 1.0), lambda(bandLimit + 1);
        harmonics.addSums(gammas, scales, sums);
        for (size_t i = 0; i < gammas.size(); ++i) {
            harmonics.at(gammas[i], lambda);
            for (size_t l = 0; l < lambda.size(); ++l)
                expected[l] += scales[i] * lambda[l];
        }
        for (size_t l = 0; l < lambda.size(); ++l)
            EXPECT_NEAR(sums[l], expected[l], 1e-12) << m << ' ' << l;
    }
}

} // namespace
} // namespace mirrorball
