#pragma once

#include "eye_frame.h"

#include "core/scene/scene_kinds.h"
#include "core/sphere/direction.h"
#include "core/sphere/sphere_map.h"
#include "core/spheremap/math/level.h"

namespace mirrorball::preview {

/// Seen edge-on an interpolated normal can lean away, and would mirror the view ray straight on, to a place on the rim that only rounding
/// chooses. It is taken for one that hardly faces the eye, whose place on the rim lies where it points.
inline constexpr double leastFacing = 1e-3;

/// Where a surface looks a painted sphere map up: a place in the disc of radius 1, x to the right, y up.
/// Twin: resources/shaders/lib/disc_place.glsl, where the cases are explained.
/// @param n, v unit normal and unit direction towards the viewer, in the axes of the map: the camera's or the world's
inline glm::dvec2 discPlace(SphereMapIndex index, MapSpace space, glm::dvec3 n, const glm::dvec3& v)
{
    if (index == SphereMapIndex::Reflection) {
        const glm::dvec3 r = glm::normalize(2.0 * glm::max(glm::dot(n, v), leastFacing) * n - v);
        const double onePlusZ = r.z > 0.0 ? 1.0 + r.z : (r.x * r.x + r.y * r.y) / (1.0 - r.z);
        return onePlusZ > 0.0 ? glm::dvec2(r.x, r.y) / glm::sqrt(2.0 * onePlusZ) : glm::dvec2(1.0, 0.0);
    }
    if (space == MapSpace::Eye)
        n = aboutViewRay(v, n);
    const glm::dvec2 place(n.x, n.y);
    return n.z >= 0.0 ? place : place / glm::max(glm::length(place), 1e-20);
}

} // namespace mirrorball::preview
