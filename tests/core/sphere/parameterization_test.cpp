#include "core/sphere/parameterization.h"

#include "core/base/error.h"
#include "support/directions.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace mirrorball {
namespace {

using test::describe;
using test::layoutsOfSize;

TEST(Parameterization, NamesRoundTrip)
{
    for (const auto p : allParameterizations)
        EXPECT_EQ(parameterizationFromName(name(p)), p);
    EXPECT_FALSE(parameterizationFromName("Cube"));
    EXPECT_FALSE(parameterizationFromName(""));
}

TEST(Parameterization, RefusesLayoutsThatHoldNoMap)
{
    EXPECT_THROW(validate({Parameterization::Latlong, 0, 0}), InvalidArgument);
    EXPECT_THROW(validate({Parameterization::Cube, -4, 0}), InvalidArgument);
    EXPECT_THROW(validate({Parameterization::Cube, 16, 1}), InvalidArgument);
    EXPECT_THROW(validate({Parameterization::Paraboloid, 16, 8}), InvalidArgument);
    EXPECT_THROW(validate({Parameterization::Paraboloid, 16, -1}), InvalidArgument);
    EXPECT_NO_THROW(validate({Parameterization::Paraboloid, 16, 7}));
    EXPECT_NO_THROW(validate({Parameterization::Paraboloid, 1, 0}));
}

TEST(Parameterization, CoordinateAndDirectionAreInverse)
{
    for (const int size : {1, 2, 7, 64, 511}) {
        for (const MapLayout& layout : layoutsOfSize(size)) {
            for (const glm::dvec3& d : test::randomDirections(2000)) {
                // A position holds 16 digits, and at the rim of the sphere map theta = 2 asin(rho) turns 1e-16 into 1e-16 / cos(theta/2).
                const double rim = layout.kind == Parameterization::Sphere ? std::max(1e-8, std::sqrt(0.5 * (1.0 + d.z))) : 1.0;
                EXPECT_LT(glm::distance(direction(layout, coordinate(layout, d)), d), 1e-14 / rim * 4.0) << describe(layout);
            }
        }
    }
}

TEST(Parameterization, AxesEdgesAndCornersRoundTripAndStayOnTheImage)
{
    for (const int size : {1, 2, 7, 64}) {
        for (const MapLayout& layout : layoutsOfSize(size)) {
            for (const glm::dvec3& d : test::specialDirections()) {
                const glm::dvec2 p = coordinate(layout, d);
                EXPECT_GE(p.x, 0.0) << describe(layout);
                EXPECT_GE(p.y, 0.0) << describe(layout);
                EXPECT_LE(p.x, layout.width()) << describe(layout);
                EXPECT_LE(p.y, layout.height()) << describe(layout);
                const double tolerance = layout.kind == Parameterization::Sphere && d.z < -0.999 ? 1e-7 : 1e-14;
                EXPECT_LT(glm::distance(direction(layout, p), d), tolerance)
                    << describe(layout) << " at " << d.x << " " << d.y << " " << d.z;
            }
        }
    }
}

TEST(Parameterization, EveryImagePositionHasAUnitDirection)
{
    for (const int size : {1, 5, 16}) {
        for (const MapLayout& layout : layoutsOfSize(size)) {
            for (int y = 0; y <= 2 * layout.height(); ++y)
                for (int x = 0; x <= 2 * layout.width(); ++x)
                    EXPECT_NEAR(glm::length(direction(layout, {0.5 * x, 0.5 * y})), 1.0, 1e-14) << describe(layout);
        }
    }
}

TEST(Parameterization, TexelCentersOfTheMapRoundTrip)
{
    for (const int size : {1, 2, 7, 64}) {
        for (const MapLayout& layout : layoutsOfSize(size)) {
            for (int y = 0; y < layout.height(); ++y)
                for (int x = 0; x < layout.width(); ++x) {
                    const Texel t = acrossSeam(layout, {x, y}, x, y);
                    if (t != Texel{x, y}) // in a disc: the center is outside
                        continue;
                    const glm::dvec2 p = coordinate(layout, texelDirection(layout, x, y));
                    EXPECT_LT(glm::distance(p, glm::dvec2(x + 0.5, y + 0.5)), 1e-9) << describe(layout) << " " << x << " " << y;
                }
        }
    }
}

TEST(Parameterization, SolidAnglesSumToTheWholeSphere)
{
    for (const int size : {1, 2, 3, 4, 5, 16, 17, 64, 101, 512}) {
        for (const MapLayout& layout : layoutsOfSize(size)) {
            double sum = 0.0;
            for (int y = 0; y < layout.height(); ++y)
                for (int x = 0; x < layout.width(); ++x) {
                    const double w = texelSolidAngle(layout, x, y);
                    EXPECT_GE(w, 0.0) << describe(layout);
                    EXPECT_TRUE(isInside(layout, x, y) || w == 0.0) << describe(layout) << " at " << x << " " << y;
                    sum += w;
                }
            EXPECT_NEAR(sum / (4.0 * pi), 1.0, 1e-12) << describe(layout);
        }
    }
}

TEST(Parameterization, SolidAngleIsTheIntegralOfTheDensity)
{
    for (const int size : {6, 7}) {
        for (const MapLayout& layout : layoutsOfSize(size)) {
            for (int y = 0; y < layout.height(); ++y) {
                for (int x = 0; x < layout.width(); ++x) {
                    constexpr int steps = 64; // midpoint rule: h^2 inside, and h at a clipped edge
                    double sum = 0.0;
                    for (int j = 0; j < steps; ++j)
                        for (int i = 0; i < steps; ++i)
                            sum += density(layout, {x + (i + 0.5) / steps, y + (j + 0.5) / steps});
                    const double w = texelSolidAngle(layout, x, y);
                    EXPECT_NEAR(sum / (steps * steps), w, 2e-3 * 4.0 * pi / (size * size)) << describe(layout) << " at " << x << " " << y;
                }
            }
        }
    }
}

TEST(Parameterization, DensityIsTheJacobianOfDirection)
{
    // The area spanned by two small steps, against the closed form; positions away from the fold lines.
    constexpr double h = 1e-5;
    for (const MapLayout& layout : layoutsOfSize(32)) {
        for (const glm::dvec3& d : test::randomDirections(200, 3)) {
            const glm::dvec2 p = coordinate(layout, d);
            if (layout.kind == Parameterization::Sphere && d.z < -0.99)
                continue;
            const glm::dvec3 du = direction(layout, p + glm::dvec2(h, 0)) - direction(layout, p - glm::dvec2(h, 0));
            const glm::dvec3 dv = direction(layout, p + glm::dvec2(0, h)) - direction(layout, p - glm::dvec2(0, h));
            const double area = glm::length(glm::cross(du, dv)) / (4.0 * h * h);
            EXPECT_NEAR(area / density(layout, p), 1.0, 1e-4) << describe(layout);
        }
    }
}

TEST(Parameterization, SolidAngleTableRepeatsTheTexels)
{
    for (const MapLayout& layout : layoutsOfSize(9)) {
        const SolidAngles table(layout);
        for (int y = 0; y < layout.height(); ++y)
            for (int x = 0; x < layout.width(); ++x)
                EXPECT_NEAR(table.at(x, y), texelSolidAngle(layout, x, y), 1e-15) << describe(layout) << " at " << x << " " << y;
    }
}

TEST(Parameterization, OneStepOverAnEdgeIsANearTexel)
{
    // Wherever a step leads, the texel found lies as near in direction as neighbors inside do (within two texels of
    // the map; at the sphere map's rim theta = pi - 2 sqrt(2 (1 - rho)), and two texels may lie on opposite sides of -Z).
    for (const MapLayout& layout : layoutsOfSize(32)) {
        const double widest = layout.kind == Parameterization::Sphere ? 6.0 * std::sqrt(2.0 / 32) : 2.0 * pi / 32 * 2.0;
        for (int y = 0; y < layout.height(); ++y)
            for (int x = 0; x < layout.width(); ++x) {
                if (acrossSeam(layout, {x, y}, x, y) != Texel{x, y})
                    continue;
                const Texel steps[] = {{x - 1, y}, {x + 1, y}, {x, y - 1}, {x, y + 1}, {x - 1, y - 1}, {x + 1, y + 1}};
                for (const Texel& step : steps) {
                    const Texel t = acrossSeam(layout, {x, y}, step.x, step.y);
                    ASSERT_TRUE(isInside(layout, t.x, t.y)) << describe(layout);
                    const double angle =
                        std::acos(std::clamp(glm::dot(texelDirection(layout, t.x, t.y), texelDirection(layout, x, y)), -1.0, 1.0));
                    EXPECT_LT(angle, widest) << describe(layout) << " from " << x << " " << y << " to " << step.x << " " << step.y;
                }
            }
    }
}

TEST(Parameterization, StepsOfAChartWidthEndOnTheMap)
{
    for (const int size : {1, 2, 5, 8}) {
        for (const MapLayout& layout : layoutsOfSize(size)) {
            for (int y = 0; y < layout.height(); ++y)
                for (int x = 0; x < layout.width(); ++x)
                    for (int dy = -size; dy <= size; ++dy)
                        for (int dx = -size; dx <= size; ++dx) {
                            const Texel t = acrossSeam(layout, {x, y}, x + dx, y + dy);
                            ASSERT_TRUE(isInside(layout, t.x, t.y)) << describe(layout) << " " << x << " " << y << " " << dx << " " << dy;
                        }
        }
    }
}

} // namespace
} // namespace mirrorball
