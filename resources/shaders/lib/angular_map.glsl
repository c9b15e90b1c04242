#pragma once
#include "lib/seams.glsl"
// Twin: core/sphere/angular_map. The distance from the center is the angle from +Z over pi; a picture from inside, -X on the right.
vec3 angularCoordinate(vec3 d, float size, float border)
{
    const float pi = 3.14159265358979;
    float s = length(d.xy);
    float radius = atan(s, d.z) / pi;
    vec2 p = s > 0.0 ? vec2(-d.x, d.y) * (radius / s) : vec2(radius, 0.0);
    return vec3(0.5 * size * (1.0 + p.x), 0.5 * size * (1.0 - p.y), 0.0);
}

// Angle that a texel spans along the radius: 2 pi over N texels. Around the rim it is less.
float angularTexelAngle(vec3 d, float size, float border)
{
    return 2.0 * 3.14159265358979 / size;
}

// The seam is the rim, which is one direction.
Seam angularSeam(vec3 d)
{
    return Seam(d.z < 0.0 ? awayFrom(vec3(d.xy, 0.0)) : d, 0);
}
