#pragma once
#include "lib/seams.glsl"
// Twin: core/sphere/dual_paraboloid. Source: 000 section 2.3.1, equations 4 to 12: the reflected direction r is the mirror image of
// d0 = (0, 0, 1) at a point (x, y) of the paraboloid, d0 + r is parallel to the normal (x, y, 1) there (equations 7 and 8), and
// dividing by its z gives x and y. Directions with z < 0 take -d0 and the second half. Both halves in one pass: the half is chosen
// per direction, and each is continued past its disc, so that there is no line between them.
// The third component is the half, 0 in front and 1 behind.
vec3 paraboloidCoordinate(vec3 r, float size, float border)
{
    vec2 p = r.xy / (1.0 + abs(r.z));
    float radius = 0.5 * size - border;
    return vec3(0.5 * size + radius * p.x, 0.5 * size - radius * p.y, r.z >= 0.0 ? 0.0 : 1.0);
}

// The projection is stereographic, d omega = 4 dA / (1 + x^2 + y^2)^2 = (1 + |z|)^2 dA (equation 3): conformal, so texels are square.
float paraboloidTexelAngle(vec3 r, float size, float border)
{
    return (1.0 + abs(r.z)) / (0.5 * size - border);
}

// The seam is the equator between the halves.
Seam paraboloidSeam(vec3 d)
{
    return Seam(vec3(0.0, 0.0, 1.0), d.z >= 0.0 ? 0 : 1);
}
