#pragma once

#include <glm/glm.hpp>

namespace mirrorball::preview {

/// A direction of the camera's axes in the frame about the view ray: the shortest turn that brings v to +Z, applied to d. A normal in it
/// has z = n.v, so that its (x, y) fills the disc of a sphere map wherever on the screen the object stands: it neither slides nor warps.
/// In an orthographic view v is +Z and nothing is turned.
///   d' = (d.x - v.x s, d.y - v.y s, v.d),   s = (v.d + d.z) / (1 + v.z)
/// @param v unit, towards the viewer, z > -1
inline glm::dvec3 aboutViewRay(const glm::dvec3& v, const glm::dvec3& d)
{
    const double c = glm::dot(v, d), s = (c + d.z) / (1.0 + v.z);
    return {d.x - s * v.x, d.y - s * v.y, c};
}

} // namespace mirrorball::preview
