#pragma once

#include "core/sphere/direction.h"

#include <glm/glm.hpp>

namespace mirrorball {

/// The built-in probe `sky` (builtin_probes.h): clear daylight over a sunlit ground. RGB radiance from the unit direction d; one unit is
/// 10 kcd/m^2. Source: Preetham et al. 1999; the sun's after Darula, Kittler, Gueymard 2005.
glm::dvec3 skyRadiance(const glm::dvec3& d);
/// The same without the sun's disc, which is smaller than most texels: smooth, so that a few samples tell its mean.
glm::dvec3 skyWithoutSun(const glm::dvec3& d);

/// Direction of the center of the sun in `sky`: longitude 40 degrees (left of +Z when looking along it), elevation 35 degrees.
glm::dvec3 skySunDirection();
/// Angular radius of the sun's disc in `sky`, in radians: 0.2665 degrees, its mean as seen from the earth.
inline constexpr double skySunRadius = 0.2665 * pi / 180.0;
/// Radiance of the sun's disc in `sky`: (1.44, 1.17, 0.90) 10^5.
glm::dvec3 skySunRadiance();

} // namespace mirrorball
