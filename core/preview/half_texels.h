#pragma once

#include "core/base/job.h"
#include "core/image/image.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>
#include <vector>

namespace mirrorball::preview {

/// The bits of the nearest half, ties to even, as Imath has it: what is too large becomes infinity, and what is no number stays none. In
/// sums and choices alone, so that the compiler makes vector code of a loop.
inline std::uint16_t halfBits(float value)
{
    const auto bits = std::bit_cast<std::int32_t>(value), magnitude = bits & 0x7fffffff;
    const int normal = (magnitude + 0xfff + (magnitude >> 13 & 1) - (112 << 23)) >> 13; // the exponent's bias goes from 127 to 15
    // A sum near 1/2 is rounded to whole 2^-24, the step of halves below 2^-14.
    const int tiny = std::bit_cast<std::int32_t>(std::bit_cast<float>(magnitude) + 0.5f) - std::bit_cast<std::int32_t>(0.5f);
    const int large = magnitude > 0x7f800000 ? 0x7e00 : 0x7c00;
    const int half = magnitude < 0x38800000 ? tiny : magnitude < 0x47800000 ? normal : large;
    return static_cast<std::uint16_t>(half | (bits >> 16 & 0x8000));
}

inline void toHalves(const float* __restrict from, size_t count, float largest, std::uint16_t* __restrict to)
{
    for (size_t i = 0; i < count; ++i)
        to[i] = halfBits(std::min(from[i], largest));
}

/// The texels as halves for an upload, what is above `largest` as that. Rounded here, on all cores: Mesa does it on one, four times as
/// slowly.
inline std::vector<std::uint16_t> halvesOf(const Image& image, float largest = std::numeric_limits<float>::infinity())
{
    std::vector<std::uint16_t> halves(image.texels.size());
    const size_t row = static_cast<size_t>(image.width) * static_cast<size_t>(image.channels);
    parallelRows(image.height, {}, [&](int first, int last) {
        const size_t begin = static_cast<size_t>(first) * row, count = static_cast<size_t>(last - first) * row;
        toHalves(image.texels.data() + begin, count, largest, halves.data() + begin);
    });
    return halves;
}

} // namespace mirrorball::preview
