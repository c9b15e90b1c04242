// The background, and over it the mean of the object's samples: BACKGROUND (0 none, 1 color, 2 environment), OBJECT_SAMPLES (0 where
// the object is not), OUTPUT_RADIANCE, DITHER (1: what follows is rounded to 8 bits).
#include "lib/output.glsl"
#if DITHER
#include "lib/dither.glsl"
#endif
#if BACKGROUND == 2
#define MAP_RADIANCE backgroundRadiance
#define MAP_LOD backgroundLod
#define MAP_SAMPLER backgroundMap
#define MAP_LEVELS backgroundLevels
#define MAP_SETTINGS backgroundSettings
#define MAP_CUBE BACKGROUND_CUBE
#define MAP_COORDINATE BACKGROUND_COORDINATE
#define MAP_TEXEL_ANGLE BACKGROUND_TEXEL_ANGLE
#define MAP_MIPS BACKGROUND_MIPS
#define MAP_ANISOTROPY 1
#include "lib/environment_map.glsl"
uniform mat3 backgroundRotation; // world to map
#elif BACKGROUND == 1
uniform vec3 backgroundColor;
#endif
#if OBJECT_SAMPLES > 1
uniform sampler2DMS objectSamples;
#elif OBJECT_SAMPLES == 1
uniform sampler2D objectSamples;
#endif

uniform vec4 corner; // xy: the pixel of the framebuffer that is the picture's lower left
in vec3 direction;
layout(location = 0) out vec4 color;

void main()
{
#if BACKGROUND == 2
    vec4 behind = vec4(toOutput(backgroundRadiance(backgroundRotation * normalize(direction), 0.0)), 1.0);
#elif BACKGROUND == 1
    vec4 behind = vec4(toOutput(backgroundColor), 1.0);
#else
    vec4 behind = vec4(0.0);
#endif
#if OBJECT_SAMPLES > 0
    vec4 object = vec4(0.0);
    for (int i = 0; i < OBJECT_SAMPLES; ++i)
        object += texelFetch(objectSamples, ivec2(gl_FragCoord.xy - corner.xy), OBJECT_SAMPLES > 1 ? i : 0);
    object /= float(OBJECT_SAMPLES);
    behind = object + (1.0 - object.a) * behind;
#endif
#if BACKGROUND == 0
    // Multiplied by opacity, light cannot be encoded: that comes between.
    float opacity = max(behind.a, 1e-6);
    color = vec4(opacity * encodeOutput(behind.rgb / opacity), behind.a);
#else
    color = vec4(encodeOutput(behind.rgb), behind.a);
#endif
#if DITHER
    color = dithered(color, ivec2(gl_FragCoord.xy - corner.xy));
#endif
}
