#pragma once

#include "core/image/image.h"
#include "core/spheremap/math/texel_rect.h"

#include <algorithm>

namespace mirrorball::studio {

/// The texels of a rectangle inside a picture of four channels.
inline Image cutOut(const Image& picture, const TexelRect& rect)
{
    Image part(rect.width(), rect.height(), 4);
    for (int y = 0; y < part.height; ++y)
        std::copy_n(picture.texel(rect.x0, rect.y0 + y), static_cast<size_t>(part.width) * 4, part.row(y));
    return part;
}

} // namespace mirrorball::studio
