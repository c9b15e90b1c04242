#pragma once

#include "core/image/image.h"

#include <algorithm>
#include <cmath>

namespace mirrorball {

/// Weights of a Catmull-Rom spline for the texels floor(x) - 1 to floor(x) + 2, at the fraction f of x.
struct CatmullRom {
    float w[4];
    explicit CatmullRom(float f)
        : w{f * (-0.5f + f * (1.0f - 0.5f * f)), 1.0f + f * f * (-2.5f + 1.5f * f), f * (0.5f + f * (2.0f - 1.5f * f)),
            f * f * (-0.5f + 0.5f * f)}
    {
    }
};

/// A texel of four channels as one vector of the compiler's; loads need no alignment.
typedef float FourChannels __attribute__((vector_size(16), aligned(4), may_alias)); // an attribute that `using` cannot carry

/// A picture at an image position (texel centers at i + 1/2), by Catmull-Rom splines over its nearest 4 x 4 texels; texels outside count as
/// the nearest inside. Not below 0: the spline would undershoot beside a highlight.
template <int channels>
void sampleSmoothly(const Image& image, float x, float y, float* out)
{
    x = std::min(static_cast<float>(image.width) + 1.0f, std::max(-2.0f, x - 0.5f)); // in this order NaN lands at the edge
    y = std::min(static_cast<float>(image.height) + 1.0f, std::max(-2.0f, y - 0.5f));
    const float fx = std::floor(x), fy = std::floor(y);
    const int ix = static_cast<int>(fx) - 1, iy = static_cast<int>(fy) - 1;
    const CatmullRom u(x - fx), v(y - fy);
    float sum[channels] = {};
    const bool inside = ix >= 0 && iy >= 0 && ix + 3 < image.width && iy + 3 < image.height;
    if constexpr (channels == 4) {
        if (inside) { // the same sums, in the same order
            FourChannels all{};
            for (int j = 0; j < 4; ++j) {
                const auto* texel = reinterpret_cast<const FourChannels*>(image.texel(ix, iy + j));
                FourChannels line{};
                for (int i = 0; i < 4; ++i)
                    line += u.w[i] * texel[i];
                all += v.w[j] * line;
            }
            for (int c = 0; c < 4; ++c)
                out[c] = std::max(all[c], 0.0f);
            return;
        }
    }
    for (int j = 0; j < 4; ++j) {
        float line[channels] = {};
        if (inside) {
            const float* texel = image.texel(ix, iy + j);
            for (int i = 0; i < 4; ++i, texel += channels)
                for (int c = 0; c < channels; ++c)
                    line[c] += u.w[i] * texel[c];
        } else {
            const float* row = image.row(std::clamp(iy + j, 0, image.height - 1));
            for (int i = 0; i < 4; ++i)
                for (int c = 0; c < channels; ++c)
                    line[c] += u.w[i] * row[channels * std::clamp(ix + i, 0, image.width - 1) + c];
        }
        for (int c = 0; c < channels; ++c)
            sum[c] += v.w[j] * line[c];
    }
    for (int c = 0; c < channels; ++c)
        out[c] = std::max(sum[c], 0.0f);
}

} // namespace mirrorball
