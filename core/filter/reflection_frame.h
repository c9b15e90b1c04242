#pragma once

#include "core/sphere/direction.h"

#include <glm/glm.hpp>

namespace mirrorball {

/// How a surface is seen whose reflection is stored at r, the mirror direction of the view: the normal makes the angle `view` with r, and
/// lies at `azimuth` about it, 0 towards +Y along r's meridian, counted as a right-handed turn about r.
struct SurfaceView {
    double view = 0.0;    ///< radians, [0, pi/2)
    double azimuth = 0.0; ///< radians
};

/// Unit tangents at r: `north` along the meridian towards +Y, `east` = r x north, which is the way a latlong map's columns run. At the
/// poles the meridian is that of longitude 0.
struct Tangents {
    glm::dvec3 north, east;
};
inline Tangents tangentsAt(const glm::dvec3& r)
{
    const double lon = std::atan2(r.x, r.z), c = std::sqrt(r.x * r.x + r.z * r.z);
    const glm::dvec3 north(-r.y * std::sin(lon), c, -r.y * std::cos(lon));
    return {north, glm::cross(r, north)};
}

/// The normal of the surface that reflects the view to r.
inline glm::dvec3 normalAt(const glm::dvec3& r, const SurfaceView& seen)
{
    const Tangents at = tangentsAt(r);
    const glm::dvec3 across = std::cos(seen.azimuth) * at.north + std::sin(seen.azimuth) * at.east;
    return std::cos(seen.view) * r + std::sin(seen.view) * across;
}

} // namespace mirrorball
