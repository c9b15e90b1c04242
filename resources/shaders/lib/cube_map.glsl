#pragma once
#include "lib/seams.glsl"
// Twin: core/sphere/cube_map. Face and place on it are the hardware's own (OpenGL 4.5 table 8.19).
// A texel of side 2/N on a face at distance 1: d omega = dA / (1 + u^2 + v^2)^(3/2) = m^3 dA, m the largest component of the direction.
float cubeTexelAngle(vec3 d, float size, float border)
{
    vec3 a = abs(d);
    float m = max(a.x, max(a.y, a.z));
    return 2.0 / size * m * sqrt(m);
}

// The seam is the edges of the cube: the two largest components are equal.
Seam cubeSeam(vec3 d)
{
    vec3 a = abs(d), s = sign(d) * inversesqrt(2.0);
    int face = a.x >= a.y && a.x >= a.z ? 0 : a.y >= a.z ? 1 : 2;
    int beside = face == 0 ? (a.y >= a.z ? 1 : 2) : face == 1 ? (a.x >= a.z ? 0 : 2) : a.x >= a.y ? 0 : 1;
    vec3 across = vec3(0.0);
    across[face] = s[face];
    across[beside] = -s[beside];
    return Seam(across, 2 * face + (d[face] > 0.0 ? 0 : 1));
}
