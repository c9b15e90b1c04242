#pragma once
// A painted sphere map by place in its disc. SPHERE_LEVELS 0: averages; where nothing shifts the lookup the hardware filters them along the
// footprint's longer side, elsewhere they are filtered evenly (a sampler that is to filter along a side takes no derivatives but its own:
// Mesa's llvmpipe reads others wrongly).
// SPHERE_LEVELS 1: hand-made levels. What is so many pixels wide in each of them, along the radius, is to be as wide on the screen
// (000 section 4): the level then follows the footprint along the radius alone, log2(texels a pixel), and what is longer across is averaged
// from lookups.
uniform sampler2D paintedMap;
vec2 paintedTexture(vec2 p)
{
    return vec2(0.5) + vec2(0.5, -0.5) * p;
}
#if SPHERE_LEVELS == 0
vec4 painted(vec2 p)
{
    return texture(paintedMap, paintedTexture(p));
}
#else
vec4 painted(vec2 p, vec2 dx, vec2 dy);
vec4 painted(vec2 p)
{
    return painted(p, dFdx(p), dFdy(p));
}
#endif
vec4 painted(vec2 p, vec2 dx, vec2 dy)
{
#if SPHERE_LEVELS == 0
    return textureGrad(paintedMap, paintedTexture(p), vec2(0.5, -0.5) * dx, vec2(0.5, -0.5) * dy);
#else
    float radius = length(p), size = float(textureSize(paintedMap, 0).x);
    vec2 outward = radius > 1e-4 ? p / radius : vec2(1.0, 0.0), across = vec2(-outward.y, outward.x);
    float radial = length(vec2(dot(outward, dx), dot(outward, dy))), tangential = length(vec2(dot(across, dx), dot(across, dy)));
    float lod = log2(max(0.5 * size * radial, 1e-6));
    float texel = 2.0 * exp2(max(lod, 0.0)) / size;
    int lookups = int(clamp(ceil(tangential / texel), 1.0, 16.0));
    vec4 sum = vec4(0.0);
    for (int i = 0; i < lookups; ++i) {
        vec2 q = p + ((float(i) + 0.5) / float(lookups) - 0.5) * tangential * across;
        sum += textureLod(paintedMap, paintedTexture(q * (radius / max(length(q), 1e-6))), lod); // along the circle
    }
    return sum / float(lookups);
#endif
}
