// The material: a map looked up by reflection, a map looked up by normal, the Fresnel term between them. What a material lacks is
// not compiled: HAS_SPECULAR, HAS_DIFFUSE (0 or 1), FRESNEL (0 none, 1 dielectric, 2 conductor), COAT (0 add, 1 coat), CLEAR_COAT (0 none, 1 coat, 2 add), LAMBDA_BY_ANGLE,
// MARKER (0 or 1), BRDF_LOOKUPS (how many stand for specular map and Fresnel term; 0: none), VIEW_STACK_NODES (angles of view of the exact
// maps that stand for both; 0: none), SPHERE_USE (a painted sphere map: 0 none, 1 replace, 2 multiply, 3 over, 4 tint, 5 add), FLECKS (0 or 1),
// DIFFUSE_PICTURE, FLECK_PATTERN and NORMAL_MAP (0 or 1: a picture on the mesh).
#include "lib/fresnel.glsl"
#include "lib/output.glsl"
#include "lib/surface_point.glsl"
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
uniform mat3 specularRotation; // world to map
uniform vec3 specularColor;
#if BRDF_LOOKUPS
#include "lib/brdf_lookups.glsl"
uniform sampler2D brdfTable;
#endif
#include "lib/lambda.glsl"
uniform float lambda;
uniform float lambdaGrazing;
#endif
#if VIEW_STACK_NODES
#include "lib/view_stack.glsl"
uniform mat3 specularRotation; // world to map
uniform vec3 specularColor;
#endif
#if HAS_DIFFUSE
#define MAP_RADIANCE diffuseRadiance
#define MAP_LOD diffuseLod
#define MAP_SAMPLER diffuseMap
#define MAP_LEVELS diffuseLevels
#define MAP_SETTINGS diffuseSettings
#define MAP_CUBE DIFFUSE_CUBE
#define MAP_COORDINATE DIFFUSE_COORDINATE
#define MAP_TEXEL_ANGLE DIFFUSE_TEXEL_ANGLE
#define MAP_MIPS DIFFUSE_MIPS
#define MAP_ANISOTROPY 1
#include "lib/environment_map.glsl"
uniform mat3 diffuseRotation;
uniform vec3 diffuseColor;
#endif
#if CLEAR_COAT
#define MAP_RADIANCE clearCoatRadiance
#define MAP_LOD clearCoatLod
#define MAP_SAMPLER clearCoatMap
#define MAP_LEVELS clearCoatLevels
#define MAP_SETTINGS clearCoatSettings
#define MAP_CUBE CLEAR_COAT_CUBE
#define MAP_COORDINATE CLEAR_COAT_COORDINATE
#define MAP_TEXEL_ANGLE CLEAR_COAT_TEXEL_ANGLE
#define MAP_MIPS CLEAR_COAT_MIPS
#define MAP_ANISOTROPY CLEAR_COAT_ANISOTROPY
#include "lib/environment_map.glsl"
uniform mat3 clearCoatRotation;
uniform float clearCoatWeight;
uniform float clearCoatN2m1;
#endif
#if DIFFUSE_PICTURE || FLECK_PATTERN || NORMAL_MAP
#include "lib/surface_picture.glsl"
in vec2 texCoord;
uniform sampler2D diffusePicture;
uniform sampler2D fleckPattern;
#endif
#if NORMAL_MAP
#include "lib/normal_map.glsl"
#endif

#if SPHERE_USE
#include "lib/painted_map.glsl"
uniform float sphereOpacity;
uniform vec3 sphereColor;
#if SPHERE_VERTEX
in vec2 vertexDiscPlace;
#else
#include "lib/disc_place.glsl"
#endif
#if FLECKS
#include "lib/flecks.glsl"
#endif
#endif
#if MARKER
#include "lib/marker.glsl"
uniform mat3 markerRotation; // world to the specular map
#endif
uniform vec4 viewer; // the eye's position and 1, or the direction towards an eye infinitely far away and 0
#if FRESNEL == 1
uniform float n2m1;
#elif FRESNEL == 2
uniform vec3 conductorN;
uniform vec3 conductorK;
#endif
in vec3 worldPosition;
in vec3 worldNormal;
layout(location = 0) out vec4 color;

#if SPHERE_USE
#if FLECKS
// The mean of what flecks show: over the disc of their offsets, evenly, lookups on a spiral (Vogel 1979) and on the same turned half around, so
// that they have no side in common. Each is half as wide as its part of the disc: wider, and those along its edge would see what lies beyond.
vec4 meanOfFlecks(vec2 place, vec2 dx, vec2 dy)
{
    const int lookups = 16;
    float wide = 0.5 * flecks.z * sqrt(3.14159265 / float(lookups));
    vec2 wx = vec2(max(length(dx), wide), 0.0), wy = vec2(0.0, max(length(dy), wide));
    vec4 sum = vec4(0.0);
    for (int i = 0; i < lookups; ++i) {
        float turn = float(i / 2), radius = flecks.z * sqrt((2.0 * turn + 1.0) / float(lookups));
        float angle = 2.39996323 * turn + 3.14159265 * float(i & 1);
        sum += painted(place + radius * vec2(cos(angle), sin(angle)), wx, wy);
    }
    return sum / float(lookups);
}
#endif
// Flecks that are smaller than a pixel show their mean.
vec4 paintedColor(vec2 place)
{
#if FLECKS
    vec2 dx = dFdx(place), dy = dFdy(place);
    vec3 qx = dFdx(worldPosition) / flecks.y, qy = dFdy(worldPosition) / flecks.y;
    float pixel = sqrt(max(dot(qx, qx), dot(qy, qy))); // in cells
    float far = smoothstep(0.4, 1.2, pixel);
#if FLECK_PATTERN
    float density = flecks.x * onSurface(fleckPattern, texCoord).r;
#else
    float density = flecks.x;
#endif
    vec4 near = vec4(0.0), mean = vec4(0.0);
    if (far < 1.0) {
        FleckPlace cells = fleckPlace(worldPosition, density);
        vec4 own = painted(place + cells.own.xy, dx, dy), neighbor = painted(place + cells.neighbor.xy, dx, dy);
        near = mix(neighbor, own, clamp(0.5 + cells.border / pixel, 0.5, 1.0));
    }
    if (far > 0.0)
        mean = mix(painted(place, dx, dy), meanOfFlecks(place, dx, dy), density);
    return mix(near, mean, far);
#else
    return painted(place);
#endif
}
#endif

void main()
{
    SurfacePoint p = surfacePoint(viewer, worldPosition, worldNormal);
#if NORMAL_MAP
    p = mappedPoint(p, viewer, worldPosition, texCoord);
#endif
    vec3 mirrored = vec3(0.0), diffuse = vec3(0.0);
#if HAS_SPECULAR
#if LAMBDA_BY_ANGLE
    float least = lambdaAt(lambda, lambdaGrazing, p.c);
#else
    float least = lambda;
#endif
#if BRDF_LOOKUPS
    // The levels are a ggx chain, roughness sqrt(alpha) even between them. As in engines, a pixel's footprint does not choose among them: a
    // rougher level is another material. Lambda still holds the level from below.
    vec3 f = vec3(0.0);
    for (int k = 0; k < BRDF_LOOKUPS; ++k) {
        BrdfLookup lookup = brdfLookup(brdfTable, k, p.n, p.r);
        float level = sqrt(lookup.alpha) * specularSettings.y;
        mirrored += lookup.weight * specularRadiance(max(level, least), specularRotation * lookup.axis);
        f += lookup.weight;
    }
    mirrored *= specularColor;
#else
    mirrored = specularColor * specularRadiance(specularRotation * p.r, least);
#endif
#elif VIEW_STACK_NODES
    vec3 f = viewStackAlbedoAt(p.c);
    mirrored = specularColor * f * viewStackRadiance(specularRotation * p.n, specularRotation * p.r);
#endif
#if HAS_DIFFUSE
    diffuse = diffuseColor * diffuseRadiance(diffuseRotation * p.n, 0.0);
#if DIFFUSE_PICTURE
    diffuse *= onSurface(diffusePicture, texCoord).rgb;
#endif
#endif
#if BRDF_LOOKUPS || VIEW_STACK_NODES
#elif FRESNEL == 1
    vec3 f = vec3(fresnelDielectric(p.c, n2m1));
#elif FRESNEL == 2
    vec3 f = fresnelConductor(p.c, conductorN, conductorK);
#else
    vec3 f = vec3(1.0);
#endif
#if (BRDF_LOOKUPS || VIEW_STACK_NODES) && COAT
    vec3 radiance = mirrored + max(1.0 - f, 0.0) * diffuse;
#elif BRDF_LOOKUPS || VIEW_STACK_NODES
    vec3 radiance = mirrored + diffuse;
#elif COAT
    vec3 radiance = diffuse + f * (mirrored - diffuse);
#else
    vec3 radiance = f * mirrored + diffuse;
#endif
#if CLEAR_COAT
    float coatShare = clearCoatWeight * fresnelDielectric(p.c, clearCoatN2m1);
    vec3 coatLight = coatShare * clearCoatRadiance(clearCoatRotation * p.r, 0.0);
#if CLEAR_COAT == 1 // what it reflects does not get below it
    radiance *= 1.0 - coatShare;
#endif
    radiance += coatLight;
#endif
#if SPHERE_USE
#if SPHERE_VERTEX
    vec2 place = vertexDiscPlace;
#else
    vec2 place = discPlace(p.n, normalize(viewer.xyz - viewer.w * worldPosition));
#endif
    vec4 paint = sphereOpacity * paintedColor(place);
#if SPHERE_USE == 1
    radiance = paint.rgb + (1.0 - paint.a) * sphereColor;
#elif SPHERE_USE == 2
    radiance = (paint.rgb + 1.0 - paint.a) * sphereColor;
#elif SPHERE_USE == 3
    radiance = paint.rgb + (1.0 - paint.a) * radiance;
#elif SPHERE_USE == 5
    radiance += paint.rgb;
#else
    radiance *= paint.rgb + 1.0 - paint.a;
#endif
#endif
    color = vec4(toOutput(radiance), 1.0);
#if MARKER
    color.rgb = marked(color.rgb, markerRotation * p.r);
#endif
}
