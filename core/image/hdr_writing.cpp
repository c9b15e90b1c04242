#include "hdr_format.h"

#include "hdr_header.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace mirrorball::hdr {
namespace {

/// Nearest RGBE: the exponent is the brightest channel's, mantissas are rounded, and a mantissa that rounds up to 256 moves it up.
Rgbe encode(const float* texel, int channels)
{
    constexpr float largest = 0x1.FEp126f; // 255 * 2^(255 - 136)
    std::array<float, 3> rgb{};
    for (size_t c = 0; c < 3; ++c) {
        const float value = texel[channels < 3 ? 0 : c];
        rgb[c] = value > 0.0f ? std::min(value, largest) : 0.0f; // NaN compares false
    }
    const float brightest = std::max({rgb[0], rgb[1], rgb[2]});
    if (brightest < 0x1p-128f)
        return {0, 0, 0, 0};
    int exponent = 0;
    std::frexp(brightest, &exponent);
    float scale = std::ldexp(1.0f, 8 - exponent);
    if (brightest * scale >= 255.5f) {
        ++exponent;
        scale *= 0.5f;
    }
    Rgbe result{0, 0, 0, static_cast<std::uint8_t>(exponent + 128)};
    for (size_t c = 0; c < 3; ++c)
        result[c] = static_cast<std::uint8_t>(rgb[c] * scale + 0.5f);
    return result;
}

/// One component of a scanline as runs of 4 to 127 equal values and literals of up to 128 others.
void appendRuns(const std::uint8_t* values, size_t count, std::vector<std::uint8_t>& bytes)
{
    const auto runAt = [&](size_t start) {
        size_t length = 1;
        while (start + length < count && length < 127 && values[start + length] == values[start])
            ++length;
        return length;
    };
    for (size_t i = 0; i < count;) {
        size_t run = runAt(i);
        if (run >= 4) {
            bytes.push_back(static_cast<std::uint8_t>(128 + run));
            bytes.push_back(values[i]);
            i += run;
            continue;
        }
        const size_t start = i;
        do {
            i += run;
            run = i < count ? runAt(i) : 4;
        } while (run < 4 && i + run - start <= 128);
        bytes.push_back(static_cast<std::uint8_t>(i - start));
        bytes.insert(bytes.end(), values + start, values + i);
    }
}

} // namespace

void write(AtomicFile& file, const Image& image)
{
    const std::string header =
        "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y " + std::to_string(image.height) + " +X " + std::to_string(image.width) + "\n";
    file.write(header.data(), header.size());
    const auto width = static_cast<size_t>(image.width);
    const bool runs = image.width >= smallestRleWidth && image.width <= largestRleWidth;
    std::vector<std::uint8_t> planes(4 * width);
    std::vector<std::uint8_t> bytes;
    for (int y = 0; y < image.height; ++y) {
        bytes.clear();
        for (size_t x = 0; x < width; ++x) {
            const Rgbe texel = encode(image.row(y) + x * static_cast<size_t>(image.channels), image.channels);
            for (size_t c = 0; c < 4; ++c)
                planes[runs ? c * width + x : 4 * x + c] = texel[c];
        }
        if (runs) {
            bytes = {2, 2, static_cast<std::uint8_t>(width >> 8), static_cast<std::uint8_t>(width & 0xff)};
            for (size_t c = 0; c < 4; ++c)
                appendRuns(planes.data() + c * width, width, bytes);
        }
        const std::vector<std::uint8_t>& stored = runs ? bytes : planes;
        file.write(stored.data(), stored.size());
    }
}

} // namespace mirrorball::hdr
