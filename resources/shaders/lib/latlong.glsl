#pragma once
#include "lib/seams.glsl"
// Twin: core/sphere/latlong. lon = pi - 2 pi u, lat = pi/2 - pi v; the image is 2N x N texels.
// Both angles through atan: asin loses half its digits beside the poles.
vec3 latlongCoordinate(vec3 d, float size, float border)
{
    const float pi = 3.14159265358979;
    float lon = atan(d.x, d.z);
    float lat = atan(d.y, length(d.xz));
    return vec3(size * (1.0 - lon / pi), size * (0.5 - lat / pi), 0.0);
}

// Angle that a texel's longer side spans: its height, pi/N. Beside the poles texels are narrow, but the rows stay as far apart.
float latlongTexelAngle(vec3 d, float size, float border)
{
    return 3.14159265358979 / size;
}

// The seam is the meridian of -Z, from pole to pole.
Seam latlongSeam(vec3 d)
{
    return Seam(d.z < 0.0 ? vec3(1.0, 0.0, 0.0) : awayFrom(vec3(d.x, 0.0, d.z)), 0);
}
