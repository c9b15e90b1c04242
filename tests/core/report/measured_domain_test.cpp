#include "core/report/measured_domain.h"

#include "core/base/error.h"
#include "core/image/color_scale.h"
#include "core/sphere/direction.h"

#include <glm/glm.hpp>
#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace mirrorball {
namespace {

constexpr int size = 400;

/// f for light from `light` degrees and a view `view` degrees from the normal in the plane of incidence, beyond it where positive.
MeasuredBrdf::Sample inPlane(double light, double view, double value)
{
    const double l = light * pi / 180.0, v = view * pi / 180.0;
    return {std::cos(l), std::cos(v), std::cos(l + v), glm::dvec3(value)};
}

/// Pixels that show one color exactly: a dot's inside.
std::vector<glm::ivec2> pixelsOf(const Image& picture, const glm::vec3& color)
{
    std::vector<glm::ivec2> found;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x)
            if (const float* t = picture.texel(x, y); glm::length(glm::vec3(t[0], t[1], t[2]) - color) < 1e-4f)
                found.emplace_back(x, y);
    return found;
}

glm::dvec2 middle(const std::vector<glm::ivec2>& pixels)
{
    glm::dvec2 sum(0.0);
    for (const glm::ivec2& p : pixels)
        sum += glm::dvec2(p);
    return sum / std::max(1.0, static_cast<double>(pixels.size()));
}

// Orthographic: equal angles to both sides of the normal are seen at equal distances from it, on a line with the surface's own tilt.
TEST(MeasuredDomain, ShowsTheViewsOfTheNearestLightBrightestFirst)
{
    const MeasuredBrdf brdf = scatteredBrdf(
        "paint.brdf", {inPlane(50.0, 50.0, 10.0), inPlane(50.0, -50.0, 0.1), inPlane(50.0, 0.0, 1e-9), inPlane(20.0, 60.0, 1000.0)}, {});
    const Image picture = measuredDomainPicture(brdf, 48.0 * pi / 180.0, size);
    const auto mirror = pixelsOf(picture, falseColor(1.0)), back = pixelsOf(picture, falseColor(0.5)),
               normal = pixelsOf(picture, falseColor(0.0));
    ASSERT_GT(mirror.size(), 10u) << "the strongest of the light's own: what 20 degrees has is not shown";
    ASSERT_GT(back.size(), 10u) << "a hundredth: two decades of four below";
    ASSERT_GT(normal.size(), 10u) << "below all of them";
    const glm::dvec2 m = middle(mirror), b = middle(back), n = middle(normal);
    EXPECT_GT(m.x, n.x) << "light comes from the left, and goes to the right";
    EXPECT_LT(b.x, n.x);
    EXPECT_NEAR(m.x - n.x, n.x - b.x, 1.0);
    EXPECT_LT(n.y, m.y) << "the normal stands upwards";
}

TEST(MeasuredDomain, RefusesASizeOutOfRangeAndAMeasurementOfAGrid)
{
    const MeasuredBrdf brdf = scatteredBrdf("paint.brdf", {inPlane(50.0, 50.0, 1.0)}, {});
    EXPECT_THROW(measuredDomainPicture(brdf, 0.9, 100), InvalidArgument);
    EXPECT_THROW(measuredDomainPicture(MeasuredBrdf("grid.binary", nullptr, {}), 0.9, size), InvalidArgument);
}

} // namespace
} // namespace mirrorball
