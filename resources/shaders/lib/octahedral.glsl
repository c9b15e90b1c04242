#pragma once
#include "lib/seams.glsl"
// Twin: core/sphere/octahedral. The octahedron |x| + |y| + |z| = 1 seen from +Y, its lower half folded out to the corners.
vec3 octahedralCoordinate(vec3 d, float size, float border)
{
    vec2 p = d.xz / (abs(d.x) + abs(d.y) + abs(d.z));
    if (d.y < 0.0)
        p = (1.0 - abs(p.yx)) * vec2(p.x >= 0.0 ? 1.0 : -1.0, p.y >= 0.0 ? 1.0 : -1.0);
    return vec3(0.5 * size * (1.0 + p), 0.0);
}

// A texel of side 2/N on the plan lies at the distance 1/s from the center, s = |x| + |y| + |z|: d omega = s^3 dA.
float octahedralTexelAngle(vec3 d, float size, float border)
{
    float s = abs(d.x) + abs(d.y) + abs(d.z);
    return 2.0 / size * s * sqrt(s);
}

// The seam is the edge of the unfolded sheet: four meridians of the lower half.
Seam octahedralSeam(vec3 d)
{
    vec3 across = abs(d.x) < abs(d.z) ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 0.0, 1.0);
    return Seam(d.y < 0.0 ? across : awayFrom(across * d + vec3(0.0, d.y, 0.0)), d.y >= 0.0 ? 0 : 1);
}
