#pragma once

#include "image.h"

#include <algorithm>

namespace mirrorball {

/// The first three of four channels. Of colors that are multiplied by their opacity that is the picture over black.
inline Image withoutOpacity(const Image& rgba)
{
    Image rgb(rgba.width, rgba.height, 3);
    for (size_t i = 0; i < rgb.texels.size() / 3; ++i)
        std::copy_n(&rgba.texels[4 * i], 3, &rgb.texels[3 * i]);
    return rgb;
}

} // namespace mirrorball
