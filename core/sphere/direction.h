#pragma once

#include <glm/glm.hpp>

#include <cmath>
#include <numbers>

/// The conventions that every part shares. Cite this header, do not repeat it.
///
/// * Space is right-handed with +Y up. A map answers one question: the radiance arriving from direction d, where d is a unit
///   vector that points away from the object. Radiance is scene-linear RGB.
/// * n is the surface normal, v the direction to the viewer, l the direction to the light, r = reflect(v, n) the mirror direction
///   of v, h the half vector; eta an index of refraction (relative, the far side over the near one); alpha the GGX width.
/// * Angles are radians; only the command line and the interface speak degrees, in names that end in Deg.
/// * Longitude runs from +Z (0) towards +X (pi/2); latitude is pi/2 at +Y. Texel centers lie at (i + 1/2)/N, row 0 is the top row.
/// * Yaw turns the environment about +Y, counterclockwise seen from above (from +Z towards +X): the turned map is
///   L'(d) = L(yawed(d, -yaw)).
namespace mirrorball {

inline constexpr double pi = std::numbers::pi;

/// Direction of a longitude and a latitude: (sin lon cos lat, sin lat, cos lon cos lat).
inline glm::dvec3 directionFromLonLat(double lon, double lat)
{
    const double c = std::cos(lat);
    return {std::sin(lon) * c, std::sin(lat), std::cos(lon) * c};
}

/// Mirror direction of v about the unit normal n, both pointing away from the surface: r = 2 (n.v) n - v. Source: 000 eq. 4.
inline glm::dvec3 mirrorDirection(const glm::dvec3& v, const glm::dvec3& n) { return 2.0 * glm::dot(n, v) * n - v; }

/// d turned about +Y by `yaw` radians, from +Z towards +X.
inline glm::dvec3 yawed(const glm::dvec3& d, double yaw)
{
    const double c = std::cos(yaw), s = std::sin(yaw);
    return {c * d.x + s * d.z, d.y, -s * d.x + c * d.z};
}

} // namespace mirrorball
