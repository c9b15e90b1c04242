#pragma once
// What is seen through a window in the plane z = 0, the room towards +Z: the place in a sphere map whose center lies straight ahead. Twin:
// core/preview/window_view. Source: 003 section 4. A layer at depth D is a picture that is right for an eye at `reference` before the pane's
// middle; seen from elsewhere it shifts with D / (D + reference distance), as what stands there does.
// WINDOW_SPACE 0: indexed by the reflected eye vector in the camera's axes, its roll cancelled, as hardware of 1999 could: it turns with the
// camera. WINDOW_SPACE 1: by the line of sight through the layer: it depends on where the eye is, and on nothing else.
#include "lib/sphere_map.glsl"
uniform vec4 reference;     // in front of the pane
uniform mat3 worldToCamera;
uniform vec4 rollCancelled; // xy: cosine and sine of the turn that brings the world's up to the screen's
vec2 straightAhead(vec3 direction)
{
    vec3 place = sphereCoordinate(normalize(vec3(direction.xy, -direction.z)), 2.0, 0.0);
    return vec2(place.x - 1.0, 1.0 - place.y);
}
vec2 windowPlace(vec3 position, vec3 sight, float depth)
{
#if WINDOW_SPACE == 1
    vec3 behind = position + sight * (depth / max(-sight.z, 1e-6));
    return straightAhead(behind - reference.xyz);
#else
    vec3 place = sphereCoordinate(worldToCamera * vec3(sight.xy, -sight.z), 2.0, 0.0);
    vec2 p = vec2(place.x - 1.0, 1.0 - place.y);
    p = vec2(rollCancelled.x * p.x - rollCancelled.y * p.y, rollCancelled.y * p.x + rollCancelled.x * p.y);
    return mix(straightAhead(position - reference.xyz), p, depth / (depth + reference.z));
#endif
}
