#include "disc_picture.h"

#include "core/spheremap/math/resample.h"

#include <algorithm>

namespace mirrorball {

DiscPicture::DiscPicture(Image picture)
{
    m_levels.push_back(std::move(picture));
    while (m_levels.back().width > 4 && m_levels.back().height > 4) {
        const Image& large = m_levels.back();
        Image small(large.width / 2, large.height / 2, large.channels);
        for (int y = 0; y < small.height; ++y)
            for (int x = 0; x < small.width; ++x)
                for (int c = 0; c < large.channels; ++c)
                    small.texel(x, y)[c] = 0.25f * (large.texel(2 * x, 2 * y)[c] + large.texel(2 * x + 1, 2 * y)[c] +
                                                    large.texel(2 * x, 2 * y + 1)[c] + large.texel(2 * x + 1, 2 * y + 1)[c]);
        m_levels.push_back(std::move(small));
    }
}

size_t DiscPicture::bytes() const
{
    size_t sum = 0;
    for (const Image& level : m_levels)
        sum += level.texels.size() * sizeof(float);
    return sum;
}

const Image& DiscPicture::levelFor(double texel) const
{
    size_t level = 0;
    // The level whose texels are nearest in size, on a logarithmic scale.
    while (level + 1 < m_levels.size() && m_levels[level].width * texel > 2.0 * std::sqrt(2.0))
        ++level;
    return m_levels[level];
}

void DiscLookup::read(const Image& level, const DiscSpan& at, ColorSpan& out) const
{
    const float halfWidth = 0.5f * static_cast<float>(level.width), halfHeight = 0.5f * static_cast<float>(level.height);
    for (int i = 0; i < at.count; ++i) {
        const float x = scale * (cosine * at.x[i] + sine * at.y[i]), y = scale * (cosine * at.y[i] - sine * at.x[i]);
        if (level.channels == 4) {
            float rgba[4];
            sampleSmoothly<4>(level, halfWidth * (1.0f + x), halfHeight * (1.0f - y), rgba);
            const float alpha = std::clamp(rgba[3], 0.0f, 1.0f), scaled = alpha > 0.0f ? 1.0f / alpha : 0.0f;
            out.r[i] = rgba[0] * scaled;
            out.g[i] = rgba[1] * scaled;
            out.b[i] = rgba[2] * scaled;
            out.a[i] = alpha;
            continue;
        }
        float rgb[3];
        sampleSmoothly<3>(level, halfWidth * (1.0f + x), halfHeight * (1.0f - y), rgb);
        out.r[i] = rgb[0];
        out.g[i] = rgb[1];
        out.b[i] = rgb[2];
    }
}

} // namespace mirrorball
