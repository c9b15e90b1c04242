#pragma once
// Twin: core/filter/lookup_table. The layout of the table stands there.

// One lookup into a chain of ggx-filtered maps: where, how rough, and how much it counts.
struct BrdfLookup {
    vec3 axis;
    float alpha;
    vec3 weight;
};

int brdfLookupCount(sampler2D table) { return textureSize(table, 0).y / 2; }

// The k-th lookup of a surface of normal n that mirrors the view to r; all of unit length. The reflected radiance is the sum over k of
// weight * radiance(axis, level of alpha).
BrdfLookup brdfLookup(sampler2D table, int k, vec3 n, vec3 r)
{
    int columns = textureSize(table, 0).x;
    float nv = clamp(dot(n, r), 0.0, 1.0); // the mirrored view makes the same angle
    float x = clamp(nv * float(columns) - 0.5, 0.0, float(columns - 1));
    int left = int(x), right = min(left + 1, columns - 1);
    float t = x - float(left);
    vec3 place = mix(texelFetch(table, ivec2(left, 2 * k), 0).xyz, texelFetch(table, ivec2(right, 2 * k), 0).xyz, t);
    vec3 weight = mix(texelFetch(table, ivec2(left, 2 * k + 1), 0).rgb, texelFetch(table, ivec2(right, 2 * k + 1), 0).rgb, t);
    vec3 across = n - nv * r;
    float length2 = dot(across, across);
    across = length2 > 1e-12 ? across * inversesqrt(length2) : vec3(0.0); // seen straight on the axis is r
    vec3 axis = cos(place.z) * (cos(place.x) * r + sin(place.x) * across) + sin(place.z) * cross(r, across);
    return BrdfLookup(normalize(axis), place.y, weight);
}
