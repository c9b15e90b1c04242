#pragma once
// Twin: core/image/color. Tone curves map scene-linear radiance to [0, 1], per channel.
#define TONE_NONE 0
#define TONE_REINHARD 1
#define TONE_FILMIC 2

vec3 toneCurve(vec3 radiance, int curve)
{
    vec3 x = max(radiance, 0.0);
    if (curve == TONE_REINHARD)
        return x / (1.0 + x);
    if (curve == TONE_FILMIC) { // the fit to the ACES curve by K. Narkowicz (2015)
        x = min(x, 1e4);
        return min((x * (2.51 * x + 0.03)) / (x * (2.43 * x + 0.59) + 0.14), 1.0);
    }
    return min(x, 1.0);
}

// IEC 61966-2-1.
vec3 encodeSrgb(vec3 x)
{
    return mix(12.92 * x, 1.055 * pow(x, vec3(1.0 / 2.4)) - 0.055, greaterThan(x, vec3(0.0031308)));
}
