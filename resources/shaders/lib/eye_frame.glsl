#pragma once
// Twin: core/preview/eye_frame. A direction of the camera's axes in the frame about the view ray: the shortest turn that brings v, the unit
// direction towards the viewer, to +Z, applied to d. In an orthographic view v is +Z and nothing is turned.
//   d' = (d.x - v.x s, d.y - v.y s, v.d),   s = (v.d + d.z) / (1 + v.z)
vec3 aboutViewRay(vec3 v, vec3 d)
{
    float c = dot(v, d);
    float s = (c + d.z) / (1.0 + v.z);
    return vec3(d.xy - s * v.xy, c);
}
