#include "core/spheremap/paint_position.h"

#include "support/directions.h"

#include <gtest/gtest.h>

namespace mirrorball {
namespace {

const glm::dvec3 towardsViewer{0.0, 0.0, 1.0};

TEST(PaintPosition, UnderAnOrthographicCameraIsTheNormalSeenOnABall)
{
    for (const glm::dvec3 d : {glm::dvec3(0.3, -0.4, 0.8), glm::dvec3(0, 0, 1), glm::dvec3(-0.9, 0.1, 0.2)}) {
        const glm::dvec3 n = glm::normalize(d);
        EXPECT_LT(glm::distance(discFromNormal(n), glm::dvec2(n)), 1e-15);
        EXPECT_LT(glm::distance(discFromReflection(n), glm::dvec2(n)), 1e-15); // the disc is the picture of a mirror ball
    }
}

TEST(PaintPosition, ANormalThatFacesTheEyeIsTheCentreUnderAnyViewRay)
{
    for (const glm::dvec3 d : {glm::dvec3(0.3, -0.4, 0.8), glm::dvec3(0.1, 0.7, 0.5), glm::dvec3(0, 0, 1)}) {
        const glm::dvec3 v = glm::normalize(d);
        EXPECT_LT(glm::length(discFromNormal(v, v)), 1e-15);
    }
}

TEST(PaintPosition, ANormalAcrossTheViewRayIsOnTheRimAndOneThatFacesAwayToo)
{
    const glm::dvec3 v = glm::normalize(glm::dvec3(0.2, -0.3, 0.9));
    const glm::dvec3 across = glm::normalize(glm::cross(v, glm::dvec3(0, 1, 0)));
    EXPECT_NEAR(glm::length(discFromNormal(across, v)), 1.0, 1e-15);
    const glm::dvec3 away = glm::normalize(across - 0.3 * v);
    EXPECT_NEAR(glm::length(discFromNormal(away, v)), 1.0, 1e-15);
    EXPECT_LT(glm::distance(discFromNormal(away, v), discFromNormal(across, v)), 1e-15);
}

TEST(PaintPosition, TheRadiusIsTheSineOfTheAngleBetweenNormalAndViewRay)
{
    const glm::dvec3 v = glm::normalize(glm::dvec3(-0.4, 0.1, 0.7));
    for (const glm::dvec3 d : {glm::dvec3(0.3, -0.4, 0.8), glm::dvec3(-0.5, 0.5, 0.7), glm::dvec3(-0.4, 0.2, 0.6)}) {
        const glm::dvec3 n = glm::normalize(d);
        ASSERT_GT(glm::dot(n, v), 0.0);
        EXPECT_NEAR(glm::length(discFromNormal(n, v)), glm::length(glm::cross(n, v)), 1e-14);
    }
}

TEST(PaintPosition, ByReflectionTheMapShowsThereWhatIsMirroredThere)
{
    const glm::dvec3 v = glm::normalize(glm::dvec3(0.2, 0.1, 0.9)), n = glm::normalize(glm::dvec3(0.5, -0.3, 0.6));
    const glm::dvec3 r = sphere_map::directionFromDisc(discFromReflection(n, v));
    EXPECT_NEAR(glm::dot(r, n), glm::dot(v, n), 1e-14);                       // the angle of incidence
    EXPECT_NEAR(glm::dot(glm::cross(v, n), r), 0.0, 1e-14);                   // in the plane of incidence
    EXPECT_LT(glm::distance(glm::normalize(r + v), n), 1e-14);
}

} // namespace
} // namespace mirrorball
