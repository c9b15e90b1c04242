#pragma once
#include "lib/seams.glsl"
// Twin: core/sphere/sphere_map. (s, t) = r.xy / (2 sqrt(rx^2 + ry^2 + (rz + 1)^2)) + 1/2, which for a unit r is r.xy / sqrt(8 (1 + rz)).
// Source: 003 section 3.4.1. Beside the rim (r near -Z) 1 + rz is computed as (rx^2 + ry^2)/(1 - rz), which does not cancel; at the
// rim itself the map is singular, every point of the rim is -Z, and the one on the right is taken.
vec3 sphereCoordinate(vec3 r, float size, float border)
{
    float s2 = dot(r.xy, r.xy);
    float onePlusZ = r.z > 0.0 ? 1.0 + r.z : s2 / (1.0 - r.z);
    vec2 p = onePlusZ > 0.0 ? r.xy * inversesqrt(2.0 * onePlusZ) : vec2(1.0, 0.0);
    return vec3(0.5 * size * (1.0 + p.x), 0.5 * size * (1.0 - p.y), 0.0);
}

// The map is equal-area, d omega = 4 dA for a disc of radius 1, so a texel of side 2/N spans 4/N.
float sphereTexelAngle(vec3 r, float size, float border)
{
    return 4.0 / size;
}

// The seam is the rim, which is one direction.
Seam sphereSeam(vec3 d)
{
    return Seam(d.z < 0.0 ? awayFrom(vec3(d.xy, 0.0)) : d, 0);
}
