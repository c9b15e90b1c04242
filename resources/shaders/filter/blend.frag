// Steps 10 and 11 of 000 section 3.2.5, for a list of directions: map S and map L magnified and blended by d^2.
#include "lib/paraboloid_kernel.glsl"
uniform sampler2D directions;
uniform sampler2D smallMap;
uniform sampler2D largeMap;
uniform vec4 halves; // side and radius in texels before shrinking, shrink factors of S and L
layout(location = 0) out vec4 radiance;

// Bilinear in single precision, which filtering hardware does not promise.
vec3 magnified(sampler2D map, int isBack, vec2 p)
{
    int side = textureSize(map, 0).y;
    vec2 corner = floor(p - 0.5), f = p - 0.5 - corner;
    ivec2 low = clamp(ivec2(corner), 0, side - 1), high = clamp(ivec2(corner) + 1, 0, side - 1);
    int left = isBack * side;
    vec3 a = texelFetch(map, ivec2(left + low.x, low.y), 0).rgb, b = texelFetch(map, ivec2(left + high.x, low.y), 0).rgb;
    vec3 c = texelFetch(map, ivec2(left + low.x, high.y), 0).rgb, d = texelFetch(map, ivec2(left + high.x, high.y), 0).rgb;
    return mix(mix(a, b, f.x), mix(c, d, f.x), f.y);
}

void main()
{
    vec3 r = texelFetch(directions, ivec2(gl_FragCoord.xy), 0).xyz;
    vec2 q = r.xy / (1.0 + abs(r.z));
    vec2 p = 0.5 * halves.x + halves.y * vec2(q.x, -q.y);
    int isBack = r.z < 0.0 ? 1 : 0;
    radiance = vec4(mix(magnified(smallMap, isBack, p / halves.z), magnified(largeMap, isBack, p / halves.w), largeKernelShare(length(q))), 1.0);
}
