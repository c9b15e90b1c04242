// Radiance by direction from one map. Included once per map, with these macros defined; it undefines them:
//   MAP_RADIANCE  name of the function to make:  vec3 MAP_RADIANCE(vec3 d, float lambda), d a unit vector
//   MAP_LOD       name of another:               float MAP_LOD(vec3 d, float lambda), the level that the former reads
//   MAP_SAMPLER, MAP_LEVELS, MAP_SETTINGS  names of the uniforms
//   MAP_CUBE      1 for a cube map, which is a texture of its own kind; 0 for an atlas
//   MAP_COORDINATE, MAP_TEXEL_ANGLE  the functions of the map's mapping (mappings.glsl)
//   MAP_MIPS      1 when the map has more than one level
//   MAP_ANISOTROPY  most lookups along the longer side of a footprint; 1 for one lookup
// Twin: EnvironmentMap::radiance in core/image/environment_map on every level.
//
// The level is not left to the hardware: that measures how fast texture coordinates run, and they jump at every seam. What runs
// smoothly is the direction itself. Neighboring pixels are |dd/dx| apart in radians, a texel of level 0 spans texelAngle, so
//   lod = log2(max(|dd/dx|, |dd/dy|) / texelAngle),
// a bias may move it, and lambda is the least level that may be used: max(lod + bias, lambda), a clamp and not a bias. Source: 002
// section 2.
#include "lib/mappings.glsl"

#if MAP_CUBE
uniform samplerCube MAP_SAMPLER;
#else
uniform sampler2D MAP_SAMPLER;
#endif
uniform vec4 MAP_LEVELS[16];  // place in the atlas, size, border
uniform vec4 MAP_SETTINGS;    // x: factor to radiance, y: last level, z: bias of the level

// One level of an atlas. Framed charts stand N + 2 texels apart.
#if !MAP_CUBE
vec3 MAP_RADIANCE(vec3 d, vec4 level)
{
    vec3 p = MAP_COORDINATE(d, level.z, level.w);
    vec2 place = level.xy + vec2(p.x + p.z * (level.z + 2.0), p.y);
    return textureLod(MAP_SAMPLER, place / vec2(textureSize(MAP_SAMPLER, 0)), 0.0).rgb;
}
#endif

// At a level of one's own choice.
vec3 MAP_RADIANCE(float lod, vec3 d)
{
#if MAP_CUBE
#if MAP_MIPS
    return MAP_SETTINGS.x * textureLod(MAP_SAMPLER, d, lod).rgb;
#else
    return MAP_SETTINGS.x * textureLod(MAP_SAMPLER, d, 0.0).rgb;
#endif
#elif MAP_MIPS
    lod = clamp(lod, 0.0, MAP_SETTINGS.y);
    int fine = int(lod);
    int coarse = min(fine + 1, int(MAP_SETTINGS.y));
    vec3 a = MAP_RADIANCE(d, MAP_LEVELS[fine]);
    vec3 b = MAP_RADIANCE(d, MAP_LEVELS[coarse]);
    return MAP_SETTINGS.x * (a + (lod - float(fine)) * (b - a));
#else
    return MAP_SETTINGS.x * MAP_RADIANCE(d, MAP_LEVELS[0]);
#endif
}

#if MAP_MIPS && MAP_ANISOTROPY > 1
// A pixel's footprint is an ellipse about d. Its axes follow from the products of the derivatives, G = (dx.dx dx.dy; dx.dy dy.dy): the
// squared lengths are G's eigenvalues. The level is that of the shorter axis, or of an equal share of the longer one where lookups run out.
struct Footprint {
    vec3 axis;   // the longer one
    float lod;
    int lookups; // along it
};
Footprint MAP_LOD(vec3 d, vec3 dx, vec3 dy, float lambda)
{
    float xx = dot(dx, dx), xy = dot(dx, dy), yy = dot(dy, dy);
    float mean = 0.5 * (xx + yy), apart = sqrt(0.25 * (xx - yy) * (xx - yy) + xy * xy);
    float longer2 = max(mean + apart, 1e-20);
    vec2 along = xx >= yy ? vec2(longer2 - yy, xy) : vec2(xy, longer2 - xx);
    along = dot(along, along) > 0.0 ? normalize(along) : vec2(1.0, 0.0);
    float texel = MAP_TEXEL_ANGLE(d, MAP_LEVELS[0].z, MAP_LEVELS[0].w);
    float shorter2 = max(mean - apart, longer2 / float(MAP_ANISOTROPY * MAP_ANISOTROPY));
    float lod = clamp(max(0.5 * log2(shorter2 / (texel * texel)) + MAP_SETTINGS.z, lambda), 0.0, MAP_SETTINGS.y);
    int lookups = int(clamp(ceil(sqrt(longer2) / (texel * exp2(lod))), 1.0, float(MAP_ANISOTROPY)));
    return Footprint(along.x * dx + along.y * dy, lod, lookups);
}
float MAP_LOD(vec3 d, float lambda)
{
    return MAP_LOD(d, dFdx(d), dFdy(d), lambda).lod;
}
vec3 MAP_RADIANCE(vec3 d, float lambda)
{
    Footprint footprint = MAP_LOD(d, dFdx(d), dFdy(d), lambda);
    vec3 sum = vec3(0.0);
    for (int i = 0; i < footprint.lookups; ++i)
        sum += MAP_RADIANCE(footprint.lod, normalize(d + ((float(i) + 0.5) / float(footprint.lookups) - 0.5) * footprint.axis));
    return sum / float(footprint.lookups);
}
#else
// The level that the pixel's footprint asks for, but not below lambda.
float MAP_LOD(vec3 d, float lambda)
{
#if MAP_MIPS
    vec3 dx = dFdx(d), dy = dFdy(d);
    float footprint2 = max(dot(dx, dx), dot(dy, dy));
    float texel = MAP_TEXEL_ANGLE(d, MAP_LEVELS[0].z, MAP_LEVELS[0].w);
    float lod = 0.5 * log2(max(footprint2, 1e-20) / (texel * texel));
    return clamp(max(lod + MAP_SETTINGS.z, lambda), 0.0, MAP_SETTINGS.y);
#else
    return 0.0;
#endif
}
vec3 MAP_RADIANCE(vec3 d, float lambda)
{
    return MAP_RADIANCE(MAP_LOD(d, lambda), d);
}
#endif

#undef MAP_COORDINATE
#undef MAP_TEXEL_ANGLE
#undef MAP_RADIANCE
#undef MAP_LOD
#undef MAP_SAMPLER
#undef MAP_LEVELS
#undef MAP_SETTINGS
#undef MAP_CUBE
#undef MAP_MIPS
#undef MAP_ANISOTROPY
