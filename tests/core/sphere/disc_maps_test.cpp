#include "core/sphere/angular_map.h"
#include "core/sphere/dual_paraboloid.h"
#include "core/sphere/sphere_map.h"
#include "support/directions.h"

#include <gtest/gtest.h>

namespace mirrorball {
namespace {

TEST(SphereMap, IsWhatOpenGLComputes)
{
    // OpenGL 2.1 section 2.11.4, written out: m = 2 sqrt(rx^2 + ry^2 + (rz+1)^2), s = rx/m + 1/2, t = ry/m + 1/2, t upwards.
    constexpr int n = 64;
    for (const glm::dvec3& r : test::randomDirections(1000)) {
        const double m = 2.0 * std::sqrt(r.x * r.x + r.y * r.y + (r.z + 1.0) * (r.z + 1.0));
        const glm::dvec2 expected{n * (r.x / m + 0.5), n * (1.0 - (r.y / m + 0.5))};
        EXPECT_LT(glm::distance(sphere_map::coordinate(n, r), expected), 1e-11);
    }
}

TEST(SphereMap, HasPlusZInTheMiddlePlusXRightPlusYUp)
{
    constexpr int n = 100;
    const double side = 50.0 * std::sqrt(0.5); // theta = 90 degrees: rho = sin 45
    EXPECT_LT(glm::distance(sphere_map::coordinate(n, {0, 0, 1}), {50, 50}), 1e-12);
    EXPECT_LT(glm::distance(sphere_map::coordinate(n, {1, 0, 0}), {50 + side, 50}), 1e-12);
    EXPECT_LT(glm::distance(sphere_map::coordinate(n, {0, 1, 0}), {50, 50 - side}), 1e-12);
}

TEST(SphereMap, BackwardIsAValidPositionOnTheRim)
{
    for (const glm::dvec3& r : {glm::dvec3(0, 0, -1), glm::dvec3(-0.0, -0.0, -1), glm::normalize(glm::dvec3(1e-200, 0, -1)),
                                glm::normalize(glm::dvec3(1e-12, -1e-13, -1))}) {
        const glm::dvec2 q = sphere_map::discFromDirection(r);
        EXPECT_NEAR(glm::length(q), 1.0, 1e-15);
    }
}

TEST(SphereMap, EveryTexelInsideHasTheSameSolidAngle)
{
    const MapLayout layout{Parameterization::Sphere, 33, 0};
    EXPECT_NEAR(texelSolidAngle(layout, 16, 16), 16.0 / (33 * 33), 1e-15);
    EXPECT_NEAR(texelSolidAngle(layout, 8, 9), 16.0 / (33 * 33), 1e-15);
    EXPECT_LT(texelSolidAngle(layout, 4, 5), 16.0 / (33 * 33)); // at the rim
}

TEST(SphereMap, GoesOnThroughTheRimOnTheFarSide)
{
    for (const double eps : {1e-3, 0.1, 0.4}) {
        const glm::dvec3 beyond = sphere_map::directionFromDisc({1.0 + eps, 0.0}),
                         before = sphere_map::directionFromDisc({-(1.0 - eps), 0.0});
        EXPECT_LT(glm::distance(beyond, before), 1e-14);
    }
}

TEST(AngularMap, RadiusIsTheAngleOverPi)
{
    for (const glm::dvec3& d : test::randomDirections(1000)) {
        const glm::dvec2 q = angular_map::discFromDirection(d);
        EXPECT_NEAR(glm::length(q), std::acos(d.z) / pi, 1e-8);
    }
}

TEST(AngularMap, IsAPictureFromInsideLikeTheLatlong)
{
    // Right of +Z in a latlong is -X; so it is here. Debevec's definition, with the world turned half a turn about +Y.
    EXPECT_LT(glm::distance(angular_map::directionFromDisc({0.5, 0.0}), {-1, 0, 0}), 1e-15);
    EXPECT_LT(glm::distance(angular_map::directionFromDisc({0.0, 0.5}), {0, 1, 0}), 1e-15);
    for (const glm::dvec3& d : test::randomDirections(100)) {
        const glm::dvec2 q = angular_map::discFromDirection(d);
        const double theta = std::atan2(q.y, q.x), phi = pi * glm::length(q);
        // (0,0,-1) turned by phi towards +X, then by theta about -z, counterclockwise in the picture
        const glm::dvec3 debevec{std::sin(phi) * std::cos(theta), std::sin(phi) * std::sin(theta), -std::cos(phi)};
        EXPECT_LT(glm::distance(d, {-debevec.x, debevec.y, -debevec.z}), 1e-14);
    }
}

TEST(AngularMap, TheCapInsideARadiusHasItsSolidAngle)
{
    // A square around the center, against Gauss-like refinement of the same square: closed under subdivision.
    for (const int n : {1, 2, 3}) {
        const double whole = angular_map::solidAngle(n, {0, 0}, {n, n});
        double parts = 0.0;
        constexpr int steps = 32;
        for (int j = 0; j < steps; ++j)
            for (int i = 0; i < steps; ++i)
                parts += angular_map::solidAngle(n, glm::dvec2(i, j) * (1.0 * n / steps), glm::dvec2(i + 1, j + 1) * (1.0 * n / steps));
        EXPECT_NEAR(whole, 4.0 * pi, 1e-12);
        EXPECT_NEAR(parts, 4.0 * pi, 1e-12);
    }
}

TEST(DualParaboloid, IsTheFormulaOfHeidrichAndSeidel)
{
    constexpr int n = 64, border = 3;
    constexpr double radius = 0.5 * n - border;
    for (const glm::dvec3& r : test::randomDirections(1000)) {
        const glm::dvec2 p = dual_paraboloid::coordinate(n, border, r);
        const double center = r.z >= 0.0 ? 0.5 * n : 1.5 * n, w = r.z >= 0.0 ? 1.0 + r.z : 1.0 - r.z;
        EXPECT_LT(glm::distance(p, {center + radius * r.x / w, 0.5 * n - radius * r.y / w}), 1e-12);
    }
}

TEST(DualParaboloid, IsFourTimesDenserInTheMiddleThanAtTheRim)
{
    EXPECT_NEAR(dual_paraboloid::density(64, 0, {32, 32}) / dual_paraboloid::density(64, 0, {32, 1e-9}), 4.0, 1e-6);
    const MapLayout layout{Parameterization::Paraboloid, 1024, 0};
    EXPECT_NEAR(texelSolidAngle(layout, 512, 512) / texelSolidAngle(layout, 512, 1), 4.0, 0.03);
}

TEST(DualParaboloid, TheBorderContinuesIntoTheOtherHalf)
{
    const MapLayout layout{Parameterization::Paraboloid, 64, 4};
    const glm::dvec3 beyond = direction(layout, {64 - 2.0, 32.0}); // 2 texels past the front half's right rim
    EXPECT_LT(beyond.z, 0.0);
    EXPECT_GT(beyond.x, 0.9);
    EXPECT_FALSE(isInside(layout, 62, 32));
    EXPECT_EQ(texelSolidAngle(layout, 62, 32), 0.0);
    const Texel t = acrossSeam(layout, {59, 32}, 62, 32);
    EXPECT_GE(t.x, 64);
    EXPECT_LT(glm::distance(texelDirection(layout, t.x, t.y), texelDirection(layout, 62, 32)), 2.0 / 28);
}

TEST(DualParaboloid, CirclesOnTheSphereAreCirclesInTheMap)
{
    // The rim of a cone about an arbitrary axis: the images of its points have one center and one radius.
    const glm::dvec3 axis = glm::normalize(glm::dvec3(0.3, 0.5, 0.8)), u = glm::normalize(glm::cross(axis, glm::dvec3(0, 1, 0)));
    const glm::dvec3 v = glm::cross(axis, u);
    const auto at = [&](double phi) {
        return dual_paraboloid::coordinate(64, 0, 0.9 * axis + std::sqrt(1.0 - 0.81) * (std::cos(phi) * u + std::sin(phi) * v));
    };
    // Circle through three of the points.
    const glm::dvec2 a = at(0.0), b = at(2.0), c = at(4.0);
    const double d = 2.0 * (a.x * (b.y - c.y) + b.x * (c.y - a.y) + c.x * (a.y - b.y));
    const glm::dvec2 center{(glm::dot(a, a) * (b.y - c.y) + glm::dot(b, b) * (c.y - a.y) + glm::dot(c, c) * (a.y - b.y)) / d,
                            (glm::dot(a, a) * (c.x - b.x) + glm::dot(b, b) * (a.x - c.x) + glm::dot(c, c) * (b.x - a.x)) / d};
    for (double phi = 0.0; phi < 6.28; phi += 0.1)
        EXPECT_NEAR(glm::distance(at(phi), center), glm::distance(a, center), 1e-12);
}

} // namespace
} // namespace mirrorball
