#pragma once

#include "../sphere/direction.h"
#include "../sphere/sphere_map.h"

#include <glm/glm.hpp>

#include <cmath>

/// From a point on the model to the place on the sphere map that colours it: what lets an artist paint a highlight where it is seen.
/// All vectors are unit and in eye space: x to the right, y up, +Z towards the viewer; v points from the surface to the eye, which is +Z
/// itself under an orthographic camera.
namespace mirrorball {

/// The disc coordinate of a map that is indexed by the normal (a matcap): the normal's x and y in the frame whose +Z is v, reached from eye
/// space by the shortest turn. A normal that faces away belongs to the silhouette, and is put on the rim.
///   q = (n.b1, n.b2),  b1 = (1 - vx^2/(1+vz), -vx vy/(1+vz), -vx),  b2 = (-vx vy/(1+vz), 1 - vy^2/(1+vz), -vy)
/// So under perspective the map neither slides nor warps: it is the picture of a ball seen along the view ray.
inline glm::dvec2 discFromNormal(const glm::dvec3& n, const glm::dvec3& v = {0.0, 0.0, 1.0})
{
    const double a = 1.0 / std::max(1.0 + v.z, 1e-9), b = -v.x * v.y * a;
    const glm::dvec3 b1{1.0 - v.x * v.x * a, b, -v.x}, b2{b, 1.0 - v.y * v.y * a, -v.y};
    const glm::dvec2 q{glm::dot(b1, n), glm::dot(b2, n)};
    const double length = glm::length(q);
    if (glm::dot(v, n) >= 0.0 || length == 0.0)
        return length > 1.0 ? q / length : q;
    return q / length;
}

/// The disc coordinate of a map that is indexed by the reflection: GL_SPHERE_MAP's, for r = 2 (n.v) n - v. Under an orthographic camera it
/// equals that by the normal, because the disc is the picture of a mirror ball. Source: 003 section 3.4.1.
inline glm::dvec2 discFromReflection(const glm::dvec3& n, const glm::dvec3& v = {0.0, 0.0, 1.0})
{
    return sphere_map::discFromDirection(mirrorDirection(v, n));
}

} // namespace mirrorball
