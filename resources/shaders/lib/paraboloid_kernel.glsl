#pragma once
// Twin: core/filter/paraboloid_kernel. The plane of the front half, in radii of its disc; the back half is the front half of (x, y, -z).

// Direction of a place in the plane: the inverse of (x, y) / (1 + z).
vec3 liftFromPlane(vec2 q)
{
    float q2 = dot(q, q), scale = 1.0 / (1.0 + q2);
    return scale * vec3(2.0 * q, 1.0 - q2);
}

// The cap of angle t about r is a circle in the plane: xy its center, z its radius.
vec3 circleOfCap(vec3 r, float cosT, float sinT)
{
    return vec3(r.xy, sinT) / (r.z + cosT);
}

// Share of the map filtered with the large kernel. Source: 000 section 3.2.5.
float largeKernelShare(float d)
{
    return min(1.0, d * d);
}
