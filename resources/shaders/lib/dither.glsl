#pragma once
// What keeps dark gradients from showing steps where a picture has 8 bits: before it is rounded each pixel is moved by its place in an
// ordered pattern of 8 x 8, whose mean is 0 (Bayer 1973). The pattern stays under half a step by more than the 0.08 steps that a value loses
// on its way through a half, cut off: what 8 bits hold exactly comes out as it is. All channels move alike, so that grey stays grey.
float ditherStep(ivec2 pixel)
{
    int x = pixel.x ^ pixel.y, y = pixel.y;
    int order = (x & 1) << 5 | (y & 1) << 4 | (x & 2) << 2 | (y & 2) << 1 | (x & 4) >> 1 | (y & 4) >> 2;
    return 0.84 * ((float(order) + 0.5) / 64.0 - 0.5);
}

// Color that is encoded and multiplied by its opacity, the pixel counted from the picture's corner.
vec4 dithered(vec4 color, ivec2 pixel)
{
    return vec4(clamp(color.rgb + ditherStep(pixel) / 255.0, 0.0, color.a), color.a);
}
