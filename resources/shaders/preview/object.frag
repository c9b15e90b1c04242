// The material: a map looked up by reflection, a map looked up by normal, the Fresnel term between them. What a material lacks is
// not compiled: HAS_SPECULAR, HAS_DIFFUSE (0 or 1), FRESNEL (0 none, 1 dielectric, 2 conductor), COAT (0 add, 1 coat), LAMBDA_BY_ANGLE and
// MARKER (0 or 1).
#include "lib/fresnel.glsl"
#include "lib/output.glsl"
#include "lib/surface_point.glsl"
#if HAS_SPECULAR
#define MAP_RADIANCE specularRadiance
#define MAP_LOD specularLod
#define MAP_SAMPLER specularMap
#define MAP_LEVELS specularLevels
#define MAP_SETTINGS specularSettings
#define MAP_KIND SPECULAR_KIND
#define MAP_MIPS SPECULAR_MIPS
#define MAP_ANISOTROPY SPECULAR_ANISOTROPY
#include "lib/environment_map.glsl"
uniform mat3 specularRotation; // world to map
uniform vec3 specularColor;
#include "lib/lambda.glsl"
uniform float lambda;
uniform float lambdaGrazing;
#endif
#if HAS_DIFFUSE
#define MAP_RADIANCE diffuseRadiance
#define MAP_LOD diffuseLod
#define MAP_SAMPLER diffuseMap
#define MAP_LEVELS diffuseLevels
#define MAP_SETTINGS diffuseSettings
#define MAP_KIND DIFFUSE_KIND
#define MAP_MIPS DIFFUSE_MIPS
#define MAP_ANISOTROPY 1
#include "lib/environment_map.glsl"
uniform mat3 diffuseRotation;
uniform vec3 diffuseColor;
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

void main()
{
    SurfacePoint p = surfacePoint(viewer, worldPosition, worldNormal);
    vec3 mirrored = vec3(0.0), diffuse = vec3(0.0);
#if HAS_SPECULAR
#if LAMBDA_BY_ANGLE
    float least = lambdaAt(lambda, lambdaGrazing, p.c);
#else
    float least = lambda;
#endif
    mirrored = specularColor * specularRadiance(specularRotation * p.r, least);
#endif
#if HAS_DIFFUSE
    diffuse = diffuseColor * diffuseRadiance(diffuseRotation * p.n, 0.0);
#endif
#if FRESNEL == 1
    vec3 f = vec3(fresnelDielectric(p.c, n2m1));
#elif FRESNEL == 2
    vec3 f = fresnelConductor(p.c, conductorN, conductorK);
#else
    vec3 f = vec3(1.0);
#endif
#if COAT
    vec3 radiance = diffuse + f * (mirrored - diffuse);
#else
    vec3 radiance = f * mirrored + diffuse;
#endif
    color = vec4(toOutput(radiance), 1.0);
#if MARKER
    color.rgb = marked(color.rgb, markerRotation * p.r);
#endif
}
