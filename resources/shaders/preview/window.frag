// A room with a window: what lies outside is one sphere map, or up to three as layers in depth; the room is lit by their mean color.
// WINDOW_LAYERS 1 to 3, the nearest first; WINDOW_SPACE as in lib/window_view.glsl.
#include "lib/output.glsl"
#include "lib/window_view.glsl"
uniform sampler2D windowLayer0;
#if WINDOW_LAYERS > 1
uniform sampler2D windowLayer1;
#endif
#if WINDOW_LAYERS > 2
uniform sampler2D windowLayer2;
#endif
uniform vec4 layerDepths;
uniform vec4 viewer;
uniform vec4 pane; // center and half size
in vec3 worldPosition;
in vec3 worldNormal;
in vec2 texCoord;
layout(location = 0) out vec4 color;

vec4 layer(sampler2D map, vec2 place)
{
    return texture(map, vec2(0.5) + vec2(0.5, -0.5) * place);
}
// Seen from above the horizon and below it alike.
vec4 meanOf(sampler2D map)
{
    return textureLod(map, vec2(0.5), 100.0);
}
vec4 above(vec4 front, vec4 back)
{
    return front + (1.0 - front.a) * back;
}

void main()
{
    vec3 sight = normalize(worldPosition * viewer.w - viewer.xyz);
    vec4 outside = layer(windowLayer0, windowPlace(worldPosition, sight, layerDepths.x));
    vec4 mean = meanOf(windowLayer0);
#if WINDOW_LAYERS > 1
    outside = above(outside, layer(windowLayer1, windowPlace(worldPosition, sight, layerDepths.y)));
    mean = above(mean, meanOf(windowLayer1));
#endif
#if WINDOW_LAYERS > 2
    outside = above(outside, layer(windowLayer2, windowPlace(worldPosition, sight, layerDepths.z)));
    mean = above(mean, meanOf(windowLayer2));
#endif
    int part = int(texCoord.x + 0.5);
    if (part == 3) {
        color = vec4(toOutput(outside.rgb), 1.0);
        return;
    }
    // The pane as a small lamp that shines by the cosine at both ends, and what the walls scatter.
    vec3 n = normalize(gl_FrontFacing ? worldNormal : -worldNormal);
    vec3 fromPane = worldPosition - vec3(pane.xy, 0.0);
    float distance2 = dot(fromPane, fromPane) + 0.2;
    vec3 d = fromPane * inversesqrt(distance2);
    float lit = 4.0 * pane.z * pane.w * max(d.z, 0.0) * max(-dot(n, d), 0.0) / (3.14159265 * distance2);
    vec3 albedo = part == 1 ? vec3(0.34, 0.2, 0.11) : part == 2 ? vec3(0.8, 0.79, 0.76) : vec3(0.62, 0.58, 0.52);
    float scattered = part == 2 ? 0.6 : 0.32;
    color = vec4(toOutput(albedo * mean.rgb * (4.0 * lit + scattered)), 1.0);
}
