#pragma once

#include "parameterization.h"

#include <algorithm>
#include <cmath>

/// What a parameterization does to a small circle on the sphere.
namespace mirrorball {

/// The axes of the ellipse of directions that a texel's inscribed circle stands for: the singular values of d(direction)/d(texel).
struct Distortion {
    double major = 0.0; ///< radians a texel along the longer axis
    double minor = 0.0; ///< along the shorter one

    /// 1 where small circles stay circles (everywhere in a paraboloid map), infinite where the shorter axis vanishes.
    double anisotropy() const { return major / minor; }
    /// d omega / dA, steradians a square texel: what density() says in closed form.
    double solidAngle() const { return major * minor; }
};

/// Distortion at an image position, by differences over 2/1000 of a texel: good to about 1e-6 but within that distance of a seam.
///   J = d(direction)/d(x, y);  the singular values of J are the roots of the eigenvalues of J^T J
inline Distortion distortion(const MapLayout& layout, const glm::dvec2& p)
{
    constexpr double h = 1e-3;
    const glm::dvec3 alongX = (direction(layout, p + glm::dvec2(h, 0.0)) - direction(layout, p - glm::dvec2(h, 0.0))) / (2.0 * h);
    const glm::dvec3 alongY = (direction(layout, p + glm::dvec2(0.0, h)) - direction(layout, p - glm::dvec2(0.0, h))) / (2.0 * h);
    const double xx = glm::dot(alongX, alongX), xy = glm::dot(alongX, alongY), yy = glm::dot(alongY, alongY);
    const double mean = 0.5 * (xx + yy), spread = std::hypot(0.5 * (xx - yy), xy);
    const double major = std::sqrt(mean + spread);
    // The product of both is known without cancellation: the area that the tangents span.
    return {major, major > 0.0 ? glm::length(glm::cross(alongX, alongY)) / major : 0.0};
}

} // namespace mirrorball
