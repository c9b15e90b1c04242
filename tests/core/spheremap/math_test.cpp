#include "core/spheremap/math/cie_observer.h"
#include "core/spheremap/math/fast_math.h"
#include "core/spheremap/math/gradient_table.h"
#include "core/spheremap/math/oklab.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace mirrorball {
namespace {

TEST(GradientTable, LooksUpARunAsItDoesOnePlace)
{
    const std::vector<GradientStop> stops{{0.1, {1.0, 0.0, 0.2}}, {0.6, {0.0, 2.0, 0.1}, 0.25}, {0.9, {0.5, 0.5, 1.0}, 0.0}};
    const GradientTable table(stops, ColorMixing::Oklab);
    for (const int count : {1, 3, 4, 255, 256}) {
        std::vector<float> places;
        for (int i = 0; i < count; ++i)
            places.push_back(1.3f * static_cast<float>(i) / static_cast<float>(count) - 0.1f);
        ColorSpan run;
        table.look(count, places.data(), run);
        for (int i = 0; i < count; ++i) {
            const GradientTable::Entry one = table.at(places[static_cast<size_t>(i)]);
            ASSERT_EQ(glm::vec4(run.r[i], run.g[i], run.b[i], run.a[i]), glm::vec4(one.r, one.g, one.b, one.a)) << count << ": " << i;
        }
    }
}

TEST(FastMath, AgreesWithTheLibrary)
{
    for (double x = -20.0; x <= 20.0; x += 0.0137) {
        EXPECT_NEAR(fast::exp2(static_cast<float>(x)) / std::exp2(static_cast<double>(static_cast<float>(x))), 1.0, 6e-7) << x;
        const auto p = static_cast<float>(std::exp2(x));
        EXPECT_NEAR(fast::log2(p), std::log2(static_cast<double>(p)), 4e-6 * std::max(1.0, std::abs(x))) << x;
        EXPECT_EQ(fast::floor(static_cast<float>(x)), std::floor(static_cast<float>(x)));
        EXPECT_NEAR(fast::cos(static_cast<float>(x)), std::cos(x), 1e-5);
        EXPECT_NEAR(fast::atan2(static_cast<float>(std::sin(x)), static_cast<float>(std::cos(x))), std::atan2(std::sin(x), std::cos(x)),
                    1e-5);
    }
    EXPECT_EQ(fast::pow(0.0f, 0.0f), 1.0f);
    EXPECT_NEAR(fast::pow(0.9f, 400.0f), std::pow(0.9, 400.0), 1e-21);
}

TEST(Oklab, GoesThereAndBackAndKnowsWhite)
{
    EXPECT_NEAR(oklab::fromLinear({1.0, 1.0, 1.0}).x, 1.0, 1e-6); // Ottosson's definition: D65 white is L = 1, a = b = 0
    EXPECT_NEAR(oklab::fromLinear({1.0, 1.0, 1.0}).y, 0.0, 1e-6);
    for (const glm::dvec3 c : {glm::dvec3(0.2, 0.5, 0.9), glm::dvec3(30.0, 0.0, 2.0)}) {
        const glm::dvec3 back = oklab::toLinear(oklab::fromLinear(c));
        for (int k = 0; k < 3; ++k)
            EXPECT_NEAR(back[k], c[k], 1e-5 * 30.0);
    }
}

TEST(CieObserver, PeaksInTheGreenAndSeesEqualEnergyAsWhite)
{
    glm::dvec3 sum(0.0);
    double peak = 0.0;
    for (double w = 360.0; w <= 830.0; w += 1.0) {
        sum += cieObserver(w);
        if (cieObserver(w).y > cieObserver(peak).y)
            peak = w;
    }
    EXPECT_NEAR(peak, 555.0, 8.0);  // the luminosity function's peak
    EXPECT_NEAR(sum.x, 106.9, 1.5); // CIE 1931: each sums to 106.86 over 1 nm steps
    EXPECT_NEAR(sum.y, 106.9, 1.5);
    EXPECT_NEAR(sum.z, 106.9, 1.5);
}

} // namespace
} // namespace mirrorball
