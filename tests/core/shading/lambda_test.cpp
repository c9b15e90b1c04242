#include "core/shading/lambda.h"

#include "core/sphere/direction.h"

#include <glm/glm.hpp>
#include <gtest/gtest.h>

namespace mirrorball {
namespace {

TEST(Lambda, IsThePublishedOneAtEveryAngleWithoutGrazing)
{
    for (const double c : {0.0, 0.1, 0.7, 1.0})
        EXPECT_EQ(lambdaAt(3.5, 0.0, c), 3.5);
    EXPECT_EQ(lambdaAt(3.5, 1.0, 1.0), 3.5) << "seen straight on nothing changes";
}

TEST(Lambda, NeverFallsBelowTheFinestLevel)
{
    EXPECT_EQ(lambdaAt(0.0, 1.0, 0.5), 0.0);
    EXPECT_EQ(lambdaAt(2.0, 1.0, 0.0), 0.0);
    EXPECT_EQ(lambdaAt(2.0, 1.0, -0.1), 0.0);
}

/// The reason for g = 1, measured: normals in a small cone about n mirror v into a patch whose solid angle shrinks with n.v, and a level's
/// texels by 4^level.
TEST(Lambda, FollowsTheSolidAngleThatASpreadOfNormalsMirrorsInto)
{
    const auto patch = [](double c) { // solid angle of the mirrored directions per solid angle of the normals, by finite differences
        const glm::dvec3 v(std::sqrt(1.0 - c * c), 0.0, c);
        constexpr double step = 1e-5;
        const glm::dvec3 r = mirrorDirection(v, {0.0, 0.0, 1.0});
        const glm::dvec3 dx = (mirrorDirection(v, glm::normalize(glm::dvec3(step, 0.0, 1.0))) - r) / step;
        const glm::dvec3 dy = (mirrorDirection(v, glm::normalize(glm::dvec3(0.0, step, 1.0))) - r) / step;
        return glm::length(glm::cross(dx, dy));
    };
    EXPECT_NEAR(patch(1.0), 4.0, 1e-3);
    for (const double c : {0.1, 0.25, 0.5, 0.8})
        EXPECT_NEAR(std::pow(4.0, lambdaAt(6.0, 1.0, c) - 6.0), patch(c) / patch(1.0), 1e-3) << c;
}

} // namespace
} // namespace mirrorball
