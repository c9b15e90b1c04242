#pragma once
// The two kinds of picture. OUTPUT_RADIANCE 1: scene-linear radiance as it is. OUTPUT_RADIANCE 0: exposed, through the tone curve
// TONE_CURVE, and sRGB-encoded once the samples of a pixel have been averaged. The curve comes before the mean: a sample of a sun then
// counts as one white sample and not as thousands, and edges against it stay smooth.
// DISPLAY_OCIO 1: what OpenColorIO made of the display's view, ocioDisplay(), stands in for curve and encoding; the mean is then that of
// encoded values.
#include "lib/color.glsl"
#if OUTPUT_RADIANCE
vec3 toOutput(vec3 radiance)
{
    return radiance;
}
vec3 encodeOutput(vec3 mean)
{
    return mean;
}
#else
uniform float exposure; // factor
#if DISPLAY_OCIO
vec3 toOutput(vec3 radiance)
{
    return clamp(ocioDisplay(vec4(exposure * radiance, 1.0)).rgb, 0.0, 1.0);
}
vec3 encodeOutput(vec3 mean)
{
    return mean;
}
#else
vec3 toOutput(vec3 radiance)
{
    return toneCurve(exposure * radiance, TONE_CURVE);
}
vec3 encodeOutput(vec3 mean)
{
    return encodeSrgb(mean);
}
#endif
#endif
