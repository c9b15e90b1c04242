#pragma once
// Twin: core/sphere/cube_map. Face and place on it are the hardware's own (OpenGL 4.5 table 8.19).
// A texel of side 2/N on a face at distance 1: d omega = dA / (1 + u^2 + v^2)^(3/2) = m^3 dA, m the largest component of the direction.
float cubeTexelAngle(vec3 d, float size)
{
    vec3 a = abs(d);
    float m = max(a.x, max(a.y, a.z));
    return 2.0 / size * m * sqrt(m);
}
