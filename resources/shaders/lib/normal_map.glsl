#pragma once
// Normals of a picture on the mesh, in the frame of its texture coordinates: x towards u, y towards v, z along the mesh's own normal. The
// frame comes from how position and coordinates change on the screen, so that a mesh needs no tangents. Source: C. Schueler, Normal Mapping
// without Precomputed Tangents, ShaderX 5 (2006), and Followup (2013). Include after surface_point.glsl.
#include "lib/surface_picture.glsl"
uniform sampler2D normalMap;
uniform float normalStrength; // of x and y

// Gradients of the texture coordinates along the surface, both divided by the length of the longer; where a mesh has none, 0.
mat2x3 coordinateFrame(vec3 n, vec3 position, vec2 coordinate)
{
    vec3 px = dFdx(position), py = dFdy(position);
    vec2 tx = dFdx(coordinate), ty = dFdy(coordinate);
    vec3 acrossX = cross(py, n), acrossY = cross(n, px);
    vec3 u = acrossX * tx.x + acrossY * ty.x, v = acrossX * tx.y + acrossY * ty.y;
    float longer = max(dot(u, u), dot(v, v));
    // Where an interpolated normal leans away from the viewer, the frame is seen from behind.
    float side = dot(px, acrossX) < 0.0 ? -1.0 : 1.0;
    return longer > 0.0 ? (side * inversesqrt(longer)) * mat2x3(u, v) : mat2x3(0.0);
}

// How far the mirror direction of v by n stands above the surface whose own normal is `own`.
float mirroredHeight(vec3 n, vec3 own, vec3 v)
{
    return 2.0 * dot(n, v) * dot(n, own) - dot(v, own);
}

// A normal by which light would be mirrored into the surface is turned back to its own until it just is not.
vec3 aboveHorizon(vec3 n, vec3 own, vec3 v)
{
    if (dot(n, v) > 0.0 && mirroredHeight(n, own, v) >= 0.0)
        return n;
    float valid = 0.0, beyond = 1.0; // shares of n
    for (int i = 0; i < 12; ++i) {
        float share = 0.5 * (valid + beyond);
        vec3 between = mix(own, n, share);
        float size = max(length(between), 1e-6);
        if (dot(between, v) > 0.0 && mirroredHeight(between / size, own, v) >= 0.0)
            valid = share;
        else
            beyond = share;
    }
    return normalize(mix(own, n, valid));
}

// The point with the picture's normal in place of its own.
SurfacePoint mappedPoint(SurfacePoint p, vec4 viewer, vec3 position, vec2 coordinate)
{
    vec3 m = onSurface(normalMap, coordinate).xyz;
    // From behind, what was a bump is a dent.
    vec2 tilt = (gl_FrontFacing ? normalStrength : -normalStrength) * m.xy;
    vec3 v = normalize(viewer.xyz - viewer.w * position);
    vec3 n = normalize(max(m.z, 1e-3) * p.n + coordinateFrame(p.n, position, coordinate) * tilt);
    p.n = aboveHorizon(n, p.n, v);
    p.c = max(dot(p.n, v), 0.0);
    p.r = normalize(2.0 * p.c * p.n - v);
    return p;
}
