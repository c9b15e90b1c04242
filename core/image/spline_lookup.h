#pragma once

#include "environment_map.h"

namespace mirrorball {

/// A latlong whose rows are averaged along the longitude over the length of a texel at the equator: towards the poles texels become slivers
/// finer than what samples of that spacing can see. Other maps are returned as they are. Exact for the energy of every row.
EnvironmentMap smoothedPoles(EnvironmentMap map);

/// A map prepared for smooth lookups by a uniform cubic B-spline over its texels: what minification samples.
///
/// The spline's weights sum to one, and sampled at half a texel's spacing they do so from the texel's side too, to 3e-4: both a
/// constant and a single sun come out right. (Linear interpolation would miss by 1e-2.) What is left is that a basis function near a
/// latlong's pole does not have its texel's solid angle; the coefficients make up for that.
class SplineLookup {
public:
    /// Size at least 4: the spline reaches two texels over an edge.
    explicit SplineLookup(EnvironmentMap map);
    glm::vec3 radiance(const glm::dvec3& d) const;

private:
    EnvironmentMap m_map;
};

} // namespace mirrorball
