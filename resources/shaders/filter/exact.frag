// For a list of directions: the sum over the texels of both halves under the lobe, whose outline is an exact circle in each.
// Twin: paraboloidSum in core/filter/paraboloid.
#include "lib/paraboloid_kernel.glsl"
uniform sampler2D directions;
uniform sampler2D halvesMap; // radiance times solid angle, and solid angle
uniform sampler2D lobe;      // over the chord, from 0 to where the lobe ends
uniform vec4 halves;         // side and radius in texels, least of r along the axis of a half that holds anything under the lobe
uniform vec4 reach;          // cos and sin of the angle at which the lobe ends, the chord there, last texel of `lobe`
layout(location = 0) out vec4 radiance;

float lobeAt(float chord)
{
    float p = chord / reach.z * reach.w;
    int i = int(p);
    return mix(texelFetch(lobe, ivec2(i, 0), 0).r, texelFetch(lobe, ivec2(min(i + 1, int(reach.w)), 0), 0).r, p - float(i));
}

vec4 sumOver(vec3 r, int left)
{
    // A cap that holds the point of projection, or nearly, covers whatever it meets of the disc: look at all of it.
    vec3 circle = r.z + reach.x > 0.01 ? circleOfCap(r, reach.x, reach.y) : vec3(0.0, 0.0, 4.0);
    float middle = 0.5 * halves.x;
    vec2 center = middle + halves.y * vec2(circle.x, -circle.y);
    float radius = halves.y * circle.z;
    ivec2 first = max(ivec2(0), ivec2(floor(center - radius))), last = min(ivec2(halves.x - 1.0), ivec2(floor(center + radius)));
    vec4 sum = vec4(0.0);
    for (int y = first.y; y <= last.y; ++y) {
        vec4 rowSum = vec4(0.0); // by rows, so that rounding does not add up over the whole kernel
        for (int x = first.x; x <= last.x; ++x) {
            vec2 q = vec2(float(x) + 0.5 - middle, middle - float(y) - 0.5) / halves.y;
            float chord = distance(r, liftFromPlane(q));
            if (chord <= reach.z)
                rowSum += lobeAt(chord) * texelFetch(halvesMap, ivec2(left + x, y), 0);
        }
        sum += rowSum;
    }
    return sum;
}

void main()
{
    vec3 r = texelFetch(directions, ivec2(gl_FragCoord.xy), 0).xyz;
    vec4 sum = vec4(0.0);
    if (r.z >= halves.z)
        sum += sumOver(r, 0);
    if (-r.z >= halves.z)
        sum += sumOver(vec3(r.xy, -r.z), int(halves.x));
    radiance = sum.a > 0.0 ? vec4(sum.rgb / sum.a, 1.0) : vec4(0.0);
}
