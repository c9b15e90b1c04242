#include "core/report/error_metrics.h"

#include "core/base/error.h"

#include <gtest/gtest.h>

#include <cmath>

namespace mirrorball {
namespace {

TEST(ErrorMetrics, AreTheClosedFormsOfAConstantError)
{
    // R = 2, E = 2.1 everywhere: rms(E - R)/rms(R) = 0.05, and so are the other two.
    const std::vector<glm::dvec3> reference(10, glm::dvec3(2.0)), values(10, glm::dvec3(2.1));
    const ErrorMetrics m = errorMetrics(values, reference);
    EXPECT_NEAR(m.relRms, 0.05, 1e-14);
    EXPECT_NEAR(m.maxAbs, 0.05, 1e-14);
    EXPECT_NEAR(m.p99Rel, 0.05, 1e-14);
}

TEST(ErrorMetrics, WeighBySolidAngle)
{
    // An error of 1 on 1, on a quarter of the sphere: rms 1/2.
    const std::vector<glm::dvec3> reference(2, glm::dvec3(1.0)), values{glm::dvec3(2.0), glm::dvec3(1.0)};
    const std::vector<double> solidAngles{1.0, 3.0};
    EXPECT_NEAR(errorMetrics(values, reference, solidAngles).relRms, 0.5, 1e-15);
}

TEST(ErrorMetrics, TheNinetyNinthPercentileShowsWhatTheDarkHides)
{
    // Two of a hundred texels are dark and wrong by their own value: invisible in the root mean square, all of p99.
    std::vector<glm::dvec3> reference(100, glm::dvec3(1.0)), values = reference;
    for (size_t i = 0; i < 2; ++i) {
        reference[i] = glm::dvec3(1e-4);
        values[i] = glm::dvec3(2e-4);
    }
    const ErrorMetrics m = errorMetrics(values, reference);
    EXPECT_LT(m.relRms, 2e-5);
    EXPECT_NEAR(m.p99Rel, 1.0, 1e-12);
}

TEST(ErrorMetrics, AreInfiniteWhereTheReferenceIsBlackAndTheMapIsNot)
{
    const std::vector<glm::dvec3> black(4, glm::dvec3(0.0)), gray(4, glm::dvec3(0.1));
    EXPECT_EQ(errorMetrics(gray, black).relRms, HUGE_VAL);
    EXPECT_EQ(errorMetrics(black, black).relRms, 0.0);
}

TEST(ErrorMetrics, RefuseMapsOfDifferentLayouts)
{
    EXPECT_THROW(errorMetrics(EnvironmentMap({Parameterization::Cube, 4, 0}), EnvironmentMap({Parameterization::Cube, 8, 0})),
                 InvalidArgument);
}

} // namespace
} // namespace mirrorball
