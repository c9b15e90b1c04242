#include "screen_picture.h"

#include "core/image/color.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

namespace mirrorball::studio {

namespace {

constexpr int tableSize = 1 << 14;
constexpr int smallestLevel = 32;

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

QRgb average(QRgb a, QRgb b, QRgb c, QRgb d)
{
    const auto channel = [&](int shift) {
        return (((a >> shift & 0xffu) + (b >> shift & 0xffu) + (c >> shift & 0xffu) + (d >> shift & 0xffu) + 2u) >> 2) << shift;
    };
    return channel(0) | channel(8) | channel(16) | channel(24);
}

} // namespace

QImage onScreen(const Image& map, const JobControl& job)
{
    QImage picture(map.width, map.height, QImage::Format_ARGB32_Premultiplied);
    uchar* const bits = picture.bits(); // once: it may copy
    const auto& bytes = srgbBytes();
    parallelRows(map.height, job, [&](int first, int last) {
        for (int y = first; y < last; ++y) {
            const float* from = map.row(y);
            auto* to = reinterpret_cast<QRgb*>(bits + static_cast<qsizetype>(y) * picture.bytesPerLine());
            for (int x = 0; x < map.width; ++x, from += 4) {
                const float alpha = std::clamp(from[3], 0.0f, 1.0f), inverse = alpha > 0.0f ? 1.0f / alpha : 0.0f;
                QRgb color[3];
                for (int c = 0; c < 3; ++c) {
                    const float value = std::clamp(from[c] * inverse, 0.0f, 1.0f); // a NaN becomes 0
                    const int index = static_cast<int>(std::sqrt(value == value ? value : 0.0f) * tableSize + 0.5f);
                    color[c] = static_cast<QRgb>(static_cast<float>(bytes[static_cast<size_t>(index)]) * alpha + 0.5f);
                }
                to[x] = static_cast<QRgb>(alpha * 255.0f + 0.5f) << 24 | color[0] << 16 | color[1] << 8 | color[2];
            }
        }
    });
    return picture;
}

void ScreenPicture::put(const QImage& part, const TexelRect& at, int size)
{
    if (this->size() != size) {
        m_levels.clear();
        for (int edge = size; m_levels.empty() || edge >= smallestLevel; edge /= 2) {
            m_levels.emplace_back(edge, edge, QImage::Format_ARGB32_Premultiplied);
            m_levels.back().fill(Qt::transparent);
        }
    }
    for (int y = 0; y < part.height(); ++y)
        std::memcpy(m_levels.front().scanLine(at.y0 + y) + 4 * at.x0, part.constScanLine(y), 4 * static_cast<size_t>(part.width()));
    TexelRect rect = at;
    for (size_t i = 1; i < m_levels.size(); ++i) {
        const QImage& finer = m_levels[i - 1];
        const int edge = m_levels[i].width();
        rect = {rect.x0 / 2, rect.y0 / 2, std::min((rect.x1 + 1) / 2, edge), std::min((rect.y1 + 1) / 2, edge)};
        for (int y = rect.y0; y < rect.y1; ++y) {
            const auto* upper = reinterpret_cast<const QRgb*>(finer.constScanLine(2 * y));
            const auto* lower = reinterpret_cast<const QRgb*>(finer.constScanLine(2 * y + 1));
            auto* to = reinterpret_cast<QRgb*>(m_levels[i].scanLine(y));
            for (int x = rect.x0; x < rect.x1; ++x)
                to[x] = average(upper[2 * x], upper[2 * x + 1], lower[2 * x], lower[2 * x + 1]);
        }
    }
}

const QImage& ScreenPicture::forPixels(double pixels) const
{
    static const QImage none;
    if (m_levels.empty())
        return none;
    size_t level = 0;
    while (level + 1 < m_levels.size() && m_levels[level + 1].width() >= pixels)
        ++level;
    return m_levels[level];
}

} // namespace mirrorball::studio
