#pragma once

#include "core/sphere/direction.h"

namespace mirrorball {

/// A direction as artists set it on the ball, unit, in eye space. Azimuth: around the view axis, 0 to the right, 90 up. Polar: away from
/// the viewer; 0 is the eye itself (the miner's hat of 003 section 5.2.1), 90 comes from the side, 180 from behind.
inline glm::dvec3 lightDirection(double azimuthDeg, double polarDeg)
{
    const double azimuth = azimuthDeg * pi / 180.0, polar = polarDeg * pi / 180.0;
    return {std::sin(polar) * std::cos(azimuth), std::sin(polar) * std::sin(azimuth), std::cos(polar)};
}

} // namespace mirrorball
