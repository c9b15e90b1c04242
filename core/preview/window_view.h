#pragma once

#include "disc_place.h"

#include <cmath>

namespace mirrorball::preview {

/// Twin of resources/shaders/lib/window_view.glsl, where the terms are explained.
inline constexpr glm::dvec3 windowReference{0.0, 0.15, 2.5};

/// By the line of sight: depends on where the eye is, and on nothing else. @param sight unit, away from the eye, sight.z < 0
inline glm::dvec2 windowPlace(const glm::dvec3& position, const glm::dvec3& sight, double depth)
{
    const glm::dvec3 d = glm::normalize(position + sight * (depth / -sight.z) - windowReference);
    return glm::dvec2(d.x, d.y) / std::sqrt(2.0 * (1.0 - d.z));
}

/// The turn that cancels a camera's roll: the signed angle on the screen from the world's up, as the camera sees it, to the screen's up.
/// Source: 003 section 4
inline double rollToCancel(const glm::dmat3& cameraToWorld)
{
    const glm::dvec3 up = glm::transpose(cameraToWorld) * glm::dvec3(0, 1, 0);
    return std::atan2(up.x, up.y);
}

} // namespace mirrorball::preview
