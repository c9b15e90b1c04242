// What a material is computed from: SHADING 1 wireframe, 2 normals, 3 texture coordinates, 4 seams, 5 mip levels, 6 and 7 the ground that
// lines are drawn over; HAS_SPECULAR says
// whether there is a map to have levels; NORMAL_MAP whether normals are those of a picture; SEAM: the function of the mapping whose seams are shown; LEVEL_VALUE: the level itself in place of its color. Colors are meant for the display: neither exposed nor tone-mapped.
#include "lib/surface_point.glsl"
#if NORMAL_MAP
#include "lib/normal_map.glsl"
#endif
#if ENCODED // nothing comes after
#include "lib/color.glsl"
#endif
#if SHADING == 4
#include "lib/mappings.glsl"
#elif SHADING == 5
#include "lib/level_color.glsl"
#if HAS_SPECULAR
#define MAP_RADIANCE specularRadiance
#define MAP_LOD specularLod
#define MAP_SAMPLER specularMap
#define MAP_LEVELS specularLevels
#define MAP_SETTINGS specularSettings
#define MAP_CUBE SPECULAR_CUBE
#define MAP_COORDINATE SPECULAR_COORDINATE
#define MAP_TEXEL_ANGLE SPECULAR_TEXEL_ANGLE
#define MAP_MIPS SPECULAR_MIPS
#define MAP_ANISOTROPY SPECULAR_ANISOTROPY
#include "lib/environment_map.glsl"
#include "lib/lambda.glsl"
uniform float lambda;
uniform float lambdaGrazing;
#endif
#endif

uniform vec4 viewer;
uniform mat3 specularRotation; // world to map
uniform float pixelRatio;
#if SHADING == 1
in vec3 facePosition;
in vec3 faceNormal;
#define worldPosition facePosition
#define worldNormal faceNormal
noperspective in vec3 edgeDistance; // in pixels, to each side of the triangle
#else
in vec3 worldPosition;
in vec3 worldNormal;
#if SHADING == 3 || NORMAL_MAP
in vec2 texCoord;
#endif
#endif
layout(location = 0) out vec4 color;

// Coverage of a line of this width in pixels of the window, at a distance from its middle in device pixels.
float line(float distance, float width)
{
    return clamp(0.5 * width * pixelRatio + 0.5 - distance, 0.0, 1.0);
}

void main()
{
    SurfacePoint p = surfacePoint(viewer, worldPosition, worldNormal);
#if NORMAL_MAP
    p = mappedPoint(p, viewer, worldPosition, texCoord);
#endif
    float light = 0.25 + 0.75 * p.c;
#if SHADING == 1
    float distance = min(edgeDistance.x, min(edgeDistance.y, edgeDistance.z));
    color = vec4(mix(vec3(0.22 * light), vec3(0.9), line(distance, 1.0)), 1.0);
#elif SHADING == 2
    color = vec4(0.5 + 0.5 * p.n, 1.0);
#elif SHADING == 3
    // The chequer's edges are as soft as a pixel; where squares are smaller than that, it is their mean.
    vec2 cell = 16.0 * texCoord;
    vec2 width = max(fwidth(cell), 1e-6);
    vec2 wave = clamp((abs(fract(0.5 * cell) - 0.5) - 0.25) * 2.0 / width, -1.0, 1.0) * clamp(2.0 - 2.0 * width, 0.0, 1.0);
    color = vec4(vec3(texCoord - floor(texCoord), 0.1) * light * (0.75 + 0.25 * wave.x * wave.y), 1.0);
#elif SHADING == 4
    const vec3 charts[6] = vec3[6](vec3(0.75, 0.12, 0.1), vec3(0.1, 0.5, 0.55), vec3(0.2, 0.55, 0.1), vec3(0.5, 0.12, 0.5),
                                   vec3(0.12, 0.25, 0.75), vec3(0.75, 0.55, 0.08));
    vec3 d = specularRotation * p.r;
    Seam s = SEAM(d);
    float slope = max(length(vec2(dot(s.across, dFdx(d)), dot(s.across, dFdy(d)))), 1e-6);
    color = vec4(mix(light * charts[s.chart], vec3(1.0), line(abs(dot(s.across, d)) / slope, 2.0)), 1.0);
#elif SHADING >= 6
    color = vec4(vec3(0.3 * light), 1.0);
#else
#if HAS_SPECULAR
    float level = specularLod(specularRotation * p.r, lambdaAt(lambda, lambdaGrazing, p.c));
#if LEVEL_VALUE
    color = vec4(vec3(level), 1.0);
#else
    color = vec4(levelColor(level), 1.0);
#endif
#else
    color = vec4(vec3(0.1), 1.0);
#endif
#endif
#if ENCODED
    color.rgb = encodeSrgb(color.rgb);
#endif
}
