#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace mirrorball {

/// A float raster, a value: it copies and compares. Row 0 is the top row; channels are interleaved, R first.
/// Scene-linear Rec.709 unless a file says otherwise. Texel (x, y) has its center at (x + 1/2, y + 1/2).
struct Image {
    int width = 0;
    int height = 0;
    int channels = 3;
    std::vector<float> texels{}; ///< height * width * channels

    Image() = default;
    Image(int width_, int height_, int channels_ = 3, float fill = 0.0f)
        : width(width_), height(height_), channels(channels_),
          texels(static_cast<size_t>(width_) * static_cast<size_t>(height_) * static_cast<size_t>(channels_), fill)
    {
    }

    bool empty() const { return texels.empty(); }
    size_t index(int x, int y) const
    {
        return (static_cast<size_t>(y) * static_cast<size_t>(width) + static_cast<size_t>(x)) * static_cast<size_t>(channels);
    }
    float* texel(int x, int y) { return texels.data() + index(x, y); }
    const float* texel(int x, int y) const { return texels.data() + index(x, y); }
    float* row(int y) { return texel(0, y); }
    const float* row(int y) const { return texel(0, y); }

    bool operator==(const Image&) const = default;
};

} // namespace mirrorball
