#include "raster_generator.h"

#include <algorithm>
#include <cmath>

namespace mirrorball {

namespace {

/// Texels multiplied by their opacity to colors that are not.
MIRRORBALL_VECTOR_CLONES void unmultiplied(const float* __restrict texels, int count, ColorSpan& __restrict out, int first)
{
    for (int i = 0; i < count; ++i) {
        const float alpha = texels[4 * i + 3], inverse = 1.0f / std::max(alpha, 1e-20f);
        out.r[first + i] = texels[4 * i] * inverse;
        out.g[first + i] = texels[4 * i + 1] * inverse;
        out.b[first + i] = texels[4 * i + 2] * inverse;
        out.a[first + i] = alpha;
    }
}

/// Transparent runs are the common case of a painted layer.
bool transparent(const float* texels, int count)
{
    for (int i = 0; i < count; ++i)
        if (texels[4 * i + 3] != 0.0f)
            return false;
    return true;
}

constexpr float nothing[4] = {};

/// @param texel  of (column, row), clamped to where there are any
/// @param run    the longest run of texels in memory from (column, row) on, at most `count`: run(column, row, count, visit(texels,
/// length));
///               null where all are transparent
template <typename TexelAt, typename Runs>
void readRow(const DiscSpan& at, int size, const TexelAt& texel, const Runs& runs, ColorSpan& out)
{
    const float half = 0.5f * static_cast<float>(size), rim = std::max(half - 1.0f, 0.75f * half);
    fill(out, at.count, 0.0f, 0.0f, 0.0f);
    const auto readRim = [&](int i) {
        const float x = half + rim * at.x[i] - 0.5f, y = half - rim * at.y[i] - 0.5f;
        const int x0 = static_cast<int>(std::floor(x)), y0 = static_cast<int>(std::floor(y));
        const float fx = x - static_cast<float>(x0), fy = y - static_cast<float>(y0);
        const float *p = texel(x0, y0), *q = texel(x0 + 1, y0), *r = texel(x0, y0 + 1), *t = texel(x0 + 1, y0 + 1);
        float rgba[4];
        for (int c = 0; c < 4; ++c) {
            const float top = p[c] + fx * (q[c] - p[c]), low = r[c] + fx * (t[c] - r[c]);
            rgba[c] = top + fy * (low - top);
        }
        unmultiplied(rgba, 1, out, i);
    };
    int first = 0, last = at.count; // a row crosses the disc once
    while (first < last && at.rho[first] >= 1.0f)
        readRim(first++);
    while (last > first && at.rho[last - 1] >= 1.0f)
        readRim(--last);
    runs(at.column + first, at.row, last - first, [&](const float* texels, int count) {
        if (texels && !transparent(texels, count))
            unmultiplied(texels, count, out, first);
        else
            std::fill_n(out.a + first, count, 0.0f);
        first += count;
    });
}

} // namespace

SpanGenerator rasterGenerator(std::shared_ptr<const Image> picture, const TexelRect& rect, int size)
{
    return [picture = std::move(picture), rect, size](const DiscSpan& at, ColorSpan& out) {
        const auto texel = [&](int x, int y) {
            return picture->texel(std::clamp(x, rect.x0, rect.x1 - 1) - rect.x0, std::clamp(y, rect.y0, rect.y1 - 1) - rect.y0);
        };
        const auto runs = [&](int x, int y, int count, const auto& visit) {
            if (count > 0)
                visit(picture->texel(x - rect.x0, y - rect.y0), count);
        };
        readRow(at, size, texel, runs, out);
    };
}

SpanGenerator rasterGenerator(std::shared_ptr<const StrokeTiles> tiles)
{
    return [tiles = std::move(tiles)](const DiscSpan& at, ColorSpan& out) {
        const int size = tiles->size();
        const auto texel = [&](int x, int y) {
            const float* found = tiles->texel(std::clamp(x, 0, size - 1), std::clamp(y, 0, size - 1));
            return found ? found : nothing;
        };
        const auto runs = [&](int x, int y, int count, const auto& visit) {
            while (count > 0) {
                const int length = std::min(count, TileSet::tileSize - x % TileSet::tileSize);
                visit(tiles->texel(x, y), length);
                x += length;
                count -= length;
            }
        };
        readRow(at, size, texel, runs, out);
    };
}

} // namespace mirrorball
