#pragma once
// Where a surface looks a painted sphere map up: a place in the disc of radius 1, x to the right, y up. SPHERE_INDEX 0 by normal, 1 by
// reflection; SPHERE_SPACE 0 in the eye's frame, 1 in the world's. Twin: core/preview/disc_place.
//   by normal, eye:     the normal in the frame about the view ray: its (x, y), whatever the perspective
//   by reflection, eye: GL_SPHERE_MAP, r.xy / sqrt(2 (1 + r.z)) of the mirror direction in the camera's axes (003 section 3.4.1)
//   world:              the same of world directions, so that highlights stay where they are while the camera moves (003 section 5.2.2)
#include "lib/eye_frame.glsl"
#include "lib/sphere_map.glsl"
uniform mat3 sphereRotation; // world to the map's axes
vec2 discPlace(vec3 n, vec3 v)
{
    n = sphereRotation * n;
    v = sphereRotation * v;
#if SPHERE_INDEX == 1
    // Seen edge-on an interpolated normal can lean away: the rim, where it points.
    vec3 place = sphereCoordinate(normalize(2.0 * max(dot(n, v), 1e-3) * n - v), 2.0, 0.0);
    return vec2(place.x - 1.0, 1.0 - place.y);
#else
#if SPHERE_SPACE == 0
    n = aboutViewRay(v, n);
#endif
    // Seen edge-on an interpolated normal can lean away: the rim.
    return n.z >= 0.0 ? n.xy : n.xy / max(length(n.xy), 1e-20);
#endif
}
