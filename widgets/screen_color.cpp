#include "screen_color.h"

#include <array>

namespace mirrorball::studio {

namespace {

constexpr int tableSize = 1 << 14;

/// sRGB's byte for a linear value, by a table over the square root, which is about as even in steps as the eye is.
const std::array<unsigned char, tableSize + 1>& srgbBytes()
{
    static const std::array<unsigned char, tableSize + 1> table = [] {
        std::array<unsigned char, tableSize + 1> bytes{};
        for (int i = 0; i <= tableSize; ++i) {
            const float root = static_cast<float>(i) / tableSize;
            bytes[static_cast<size_t>(i)] = toByte(encodeSrgb(root * root));
        }
        return bytes;
    }();
    return table;
}

} // namespace

void putOnScreen(const Image& part, const TexelRect& at, QImage& picture)
{
    const auto& bytes = srgbBytes();
    for (int y = 0; y < part.height; ++y) {
        const float* from = part.row(y);
        unsigned char* to = picture.scanLine(at.y0 + y) + 4 * at.x0;
        for (int x = 0; x < part.width; ++x, from += 4, to += 4) {
            const float alpha = std::clamp(from[3], 0.0f, 1.0f), inverse = alpha > 0.0f ? 1.0f / alpha : 0.0f;
            for (int c = 0; c < 3; ++c) {
                const float value = std::clamp(from[c] * inverse, 0.0f, 1.0f); // a NaN becomes 0
                const int index = static_cast<int>(std::sqrt(value == value ? value : 0.0f) * tableSize + 0.5f);
                to[c] = static_cast<unsigned char>(static_cast<float>(bytes[static_cast<size_t>(index)]) * alpha + 0.5f);
            }
            to[3] = static_cast<unsigned char>(alpha * 255.0f + 0.5f);
        }
    }
}

} // namespace mirrorball::studio
