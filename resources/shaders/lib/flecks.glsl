#pragma once
// Twin: core/preview/flecks. Source: 003 section 6.2.
uniform vec4 flecks; // density, size, spread, seed
uvec3 pcg3d(uvec3 v)
{
    v = v * 1664525u + 1013904223u;
    v.x += v.y * v.z;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    v ^= v >> 16u;
    v.x += v.y * v.z;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    return v;
}
vec3 unitFloats(uvec3 hash)
{
    return vec3(hash >> 8u) * (1.0 / 16777216.0);
}
struct FleckPlace {
    vec3 own;       // offset of the lookup, and 1 for a fleck
    vec3 neighbor; // of the nearest other cell
    float border;   // to that one, in cells
};
vec3 fleckCell(uvec3 hash, float density)
{
    vec3 u = unitFloats(pcg3d(hash));
    if (u.x >= density)
        return vec3(0.0);
    float angle = 2.0 * 3.14159265358979 * u.y, radius = flecks.z * sqrt(u.z);
    return vec3(radius * cos(angle), radius * sin(angle), 1.0);
}
// density: as it is there, flecks.x times a pattern's share.
FleckPlace fleckPlace(vec3 position, float density)
{
    vec3 q = position / flecks.y;
    ivec3 corner = ivec3(floor(q - 0.5));
    uvec3 seed = uvec3(int(flecks.w)) * uvec3(3266489917u, 668265263u, 374761393u);
    float nearest = 3e38, second = 3e38;
    vec3 nearestPoint = vec3(0.0), secondPoint = vec3(0.0);
    uvec3 nearestHash = uvec3(0u), secondHash = uvec3(0u);
    for (int i = 0; i < 8; ++i) {
        ivec3 cell = corner + ivec3(i & 1, (i >> 1) & 1, i >> 2);
        uvec3 hash = pcg3d(uvec3(cell) + seed);
        vec3 point = vec3(cell) + 0.25 + 0.5 * unitFloats(hash);
        vec3 away = q - point;
        float distance2 = dot(away, away);
        if (distance2 < nearest) {
            second = nearest;
            secondPoint = nearestPoint;
            secondHash = nearestHash;
            nearest = distance2;
            nearestPoint = point;
            nearestHash = hash;
        } else if (distance2 < second) {
            second = distance2;
            secondPoint = point;
            secondHash = hash;
        }
    }
    return FleckPlace(fleckCell(nearestHash, density), fleckCell(secondHash, density),
                      (second - nearest) / (2.0 * distance(nearestPoint, secondPoint)));
}
