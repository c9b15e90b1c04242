#pragma once
#include "lib/latlong.glsl"
// Twin: reflected() of core/filter/view_stack, where the maps are explained. VIEW_STACK_NODES angles of view are stored.
uniform sampler2DArray viewStack; // framed: a row beyond each pole
uniform vec4 viewStackNodes[VIEW_STACK_NODES]; // angle of view, first layer, largest order, factor to radiance
uniform vec4 viewStackAlbedo[64];

vec3 viewStackAlbedoAt(float c)
{
    float x = acos(c) / 1.57079633 * 63.0;
    int left = min(int(x), 62);
    return mix(viewStackAlbedo[left].rgb, viewStackAlbedo[left + 1].rgb, x - float(left));
}

// The light at one stored angle of view. azimuth: cosine and sine
vec3 viewStackAt(vec4 node, vec2 place, vec2 azimuth)
{
    vec3 sum = textureLod(viewStack, vec3(place, node.y), 0.0).rgb;
    vec2 turn = vec2(1.0, 0.0);
    for (int m = 1; m <= int(node.z); ++m) {
        turn = vec2(turn.x * azimuth.x - turn.y * azimuth.y, turn.x * azimuth.y + turn.y * azimuth.x);
        float layer = node.y + 2.0 * float(m);
        sum += turn.x * textureLod(viewStack, vec3(place, layer - 1.0), 0.0).rgb + turn.y * textureLod(viewStack, vec3(place, layer), 0.0).rgb;
    }
    return node.w * sum;
}

// What a surface of normal n reflects that mirrors the view to r, as a share of its albedo; both of unit length and in the map's space.
vec3 viewStackRadiance(vec3 n, vec3 r)
{
    float t = acos(clamp(dot(n, r), 0.0, 1.0));
    int i = 0;
    while (i + 2 < VIEW_STACK_NODES && viewStackNodes[i + 1].x <= t)
        ++i;
    int next = min(i + 1, VIEW_STACK_NODES - 1);
    float apart = viewStackNodes[next].x - viewStackNodes[i].x;
    float between = apart > 0.0 ? clamp((t - viewStackNodes[i].x) / apart, 0.0, 1.0) : 0.0;

    // Azimuth of n about r from r's meridian: tangentsAt() of core/filter/reflection_frame.
    float c = length(r.xz);
    vec2 lon = c > 0.0 ? r.xz / c : vec2(0.0, 1.0);
    vec3 north = vec3(-r.y * lon.x, c, -r.y * lon.y);
    vec2 across = vec2(dot(n, north), dot(n, cross(r, north)));
    float length2 = dot(across, across);
    vec2 azimuth = length2 > 1e-12 ? across * inversesqrt(length2) : vec2(1.0, 0.0);

    vec2 size = vec2(textureSize(viewStack, 0).xy);
    vec2 place = (latlongCoordinate(r, size.y - 2.0, 0.0).xy + vec2(0.0, 1.0)) / size;
    vec3 first = viewStackAt(viewStackNodes[i], place, azimuth), second = viewStackAt(viewStackNodes[next], place, azimuth);
    return max(mix(first, second, between), 0.0);
}
