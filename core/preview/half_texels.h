#pragma once

#include "core/base/job.h"
#include "core/image/image.h"

#include <half.h>

#include <algorithm>
#include <limits>
#include <vector>

namespace mirrorball::preview {

/// The texels as halves for an upload, what is above `largest` as that. Rounded here, on all cores: Mesa does it on one, four times as
/// slowly.
inline std::vector<half> halvesOf(const Image& image, float largest = std::numeric_limits<float>::infinity())
{
    std::vector<half> halves(image.texels.size());
    const size_t row = static_cast<size_t>(image.width) * static_cast<size_t>(image.channels);
    parallelRows(image.height, {}, [&](int first, int last) {
        for (size_t i = static_cast<size_t>(first) * row; i < static_cast<size_t>(last) * row; ++i)
            halves[i] = half(std::min(image.texels[i], largest));
    });
    return halves;
}

} // namespace mirrorball::preview
