#include "screen_picture.h"

#include "core/image/color.h"
#include "core/spheremap/math/vector_clones.h"

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

constexpr int spanLength = 128;

/// Texels of a row on their way to the screen: where their colors, not multiplied by their opacity, stand in srgbBytes(), and their
/// opacity.
struct Span {
    int red[spanLength], green[spanLength], blue[spanLength];
    float alpha[spanLength];
};

/// By itself, so that the compiler makes vector code of the square roots.
MIRRORBALL_VECTOR_CLONES void toSpan(const float* __restrict from, int count, Span& __restrict to)
{
    for (int x = 0; x < count; ++x) {
        const float alpha = std::min(std::max(0.0f, from[4 * x + 3]), 1.0f), inverse = alpha > 0.0f ? 1.0f / alpha : 0.0f;
        const auto index = [inverse](float channel) {
            const float value = std::min(std::max(0.0f, channel * inverse), 1.0f); // in this order a NaN becomes 0
            return static_cast<int>(std::sqrt(value) * tableSize + 0.5f);
        };
        to.red[x] = index(from[4 * x]);
        to.green[x] = index(from[4 * x + 1]);
        to.blue[x] = index(from[4 * x + 2]);
        to.alpha[x] = alpha;
    }
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
            Span span;
            for (int left = 0; left < map.width; left += spanLength) {
                const int count = std::min(spanLength, map.width - left);
                toSpan(from + 4 * left, count, span);
                for (int x = 0; x < count; ++x) {
                    const float alpha = span.alpha[x];
                    const auto color = [&](int index) {
                        return static_cast<QRgb>(static_cast<int>(static_cast<float>(bytes[static_cast<size_t>(index)]) * alpha + 0.5f));
                    };
                    to[left + x] = static_cast<QRgb>(static_cast<int>(alpha * 255.0f + 0.5f)) << 24 | color(span.red[x]) << 16 |
                                   color(span.green[x]) << 8 | color(span.blue[x]);
                }
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
