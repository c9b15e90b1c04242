#pragma once

#include "light_direction.h"

#include <algorithm>

/// Where on the disc a light shows, and which light shows there: what a handle needs that is dragged on the disc. A document means the same
/// by the normal and by the mirror direction (SphereMapIndex), so these places hold for both.
namespace mirrorball {

/// A light as lightDirection() takes it; the azimuth in (-180, 180], the polar angle in [0, 180].
struct LightAngles {
    double azimuthDeg = 0.0;
    double polarDeg = 0.0;
};

/// The inverse of lightDirection(). @param l  unit
inline LightAngles lightAngles(const glm::dvec3& l)
{
    return {std::atan2(l.y, l.x) * 180.0 / pi, std::atan2(std::hypot(l.x, l.y), l.z) * 180.0 / pi};
}

/// A place at a distance from the center, in the direction of an angle.
inline glm::dvec2 polarPlace(double radius, double angleDeg)
{
    const double angle = angleDeg * pi / 180.0;
    return {radius * std::cos(angle), radius * std::sin(angle)};
}
inline double angleOf(const glm::dvec2& q) { return std::atan2(q.y, q.x) * 180.0 / pi; }

/// Where the highlight peaks, by (r.l)^n and by (n.h)^n alike: the normal halfway between light and eye.
///   |q| = sin(polar / 2)
/// So every light has its place in the disc; the rim is a light right behind. It is sphere_map::discFromDirection(l).
inline glm::dvec2 highlightPlace(const LightAngles& light)
{
    return polarPlace(std::sin(0.5 * light.polarDeg * pi / 180.0), light.azimuthDeg);
}

/// Its inverse; places past the rim stand for the nearest one on it.
inline LightAngles lightOfHighlight(const glm::dvec2& q)
{
    return {angleOf(q), 2.0 * std::asin(std::min(std::hypot(q.x, q.y), 1.0)) * 180.0 / pi};
}

/// Where the normal faces the light, so that n.l is greatest.
///   |q| = sin(polar) in front, 2 - sin(polar) behind: the ball unfolded past its rim
inline glm::dvec2 facingPlace(const LightAngles& light)
{
    const double sine = std::sin(light.polarDeg * pi / 180.0);
    return polarPlace(light.polarDeg <= 90.0 ? sine : 2.0 - sine, light.azimuthDeg);
}

/// Its inverse; places farther out than 2 stand for the direction right behind.
inline LightAngles lightOfFacing(const glm::dvec2& q)
{
    const double rho = std::min(std::hypot(q.x, q.y), 2.0);
    return {angleOf(q), rho <= 1.0 ? std::asin(rho) * 180.0 / pi : 180.0 - std::asin(2.0 - rho) * 180.0 / pi};
}

} // namespace mirrorball
