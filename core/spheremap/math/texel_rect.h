#pragma once

#include <algorithm>

namespace mirrorball {

/// Half-open rectangle of texels: x0 <= x < x1, y0 <= y < y1.
struct TexelRect {
    int x0 = 0, y0 = 0, x1 = 0, y1 = 0;

    bool empty() const { return x0 >= x1 || y0 >= y1; }
    int width() const { return x1 - x0; }
    int height() const { return y1 - y0; }
    bool operator==(const TexelRect&) const = default;

    TexelRect intersected(const TexelRect& o) const
    {
        return {std::max(x0, o.x0), std::max(y0, o.y0), std::min(x1, o.x1), std::min(y1, o.y1)};
    }
    /// The smallest rectangle around both; an empty one adds nothing.
    TexelRect united(const TexelRect& o) const
    {
        if (empty())
            return o;
        if (o.empty())
            return *this;
        return {std::min(x0, o.x0), std::min(y0, o.y0), std::max(x1, o.x1), std::max(y1, o.y1)};
    }
    /// Grown by `by` texels on every side, within a square map.
    TexelRect grown(int by, int size) const
    {
        if (empty())
            return *this;
        return {std::max(x0 - by, 0), std::max(y0 - by, 0), std::min(x1 + by, size), std::min(y1 + by, size)};
    }
};

} // namespace mirrorball
