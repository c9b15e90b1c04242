#pragma once
// Where a fragment lies and what it mirrors. Twin of r: mirrorDirection in core/sphere/direction.
struct SurfacePoint {
    vec3 n;  // unit normal, on the side that is seen
    float c; // n.v, at least 0
    vec3 r;  // mirror direction of v
};

// At a silhouette the interpolated normal can lean away from the viewer, most of all in pixels that a triangle only grazes. The true
// surface is seen edge-on there: c is 0 and r runs straight on.
SurfacePoint surfacePoint(vec4 viewer, vec3 position, vec3 normal)
{
    SurfacePoint p;
    p.n = normalize(gl_FrontFacing ? normal : -normal);
    vec3 v = normalize(viewer.xyz - viewer.w * position);
    p.c = max(dot(p.n, v), 0.0);
    p.r = normalize(2.0 * p.c * p.n - v); // 000 eq. 4
    return p;
}
