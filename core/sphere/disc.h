#pragma once

#include "parameterization.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>

/// What the maps on a disc (sphere map, angular map, dual paraboloid) have in common. q is the position in the unit disc: x to the
/// right, y up (against the rows of the image), |q| = 1 at the rim.
namespace mirrorball::disc {

struct Disc {
    glm::dvec2 center{0.0}; ///< image position, texels
    double radius = 1.0;    ///< texels

    glm::dvec2 fromImage(const glm::dvec2& p) const { return {(p.x - center.x) / radius, (center.y - p.y) / radius}; }
    glm::dvec2 toImage(const glm::dvec2& q) const { return {center.x + radius * q.x, center.y - radius * q.y}; }

    /// Whether the center of a texel lies in the disc: only such texels are sure to hold radiance.
    bool holdsCenter(int x, int y) const
    {
        const double dx = x + 0.5 - center.x, dy = y + 0.5 - center.y;
        return dx * dx + dy * dy <= radius * radius;
    }
    /// Whether any part of a texel lies in the disc.
    bool holdsPart(int x, int y) const
    {
        const double dx = std::max({x - center.x, center.x - (x + 1), 0.0}), dy = std::max({y - center.y, center.y - (y + 1), 0.0});
        return dx * dx + dy * dy < radius * radius;
    }
    /// The texel at p, or the nearest one towards the center that the disc holds the center of.
    Texel innerTexel(const glm::dvec2& p) const
    {
        int x = static_cast<int>(std::floor(p.x)), y = static_cast<int>(std::floor(p.y));
        while (!holdsCenter(x, y)) {
            const double dx = x + 0.5 - center.x, dy = y + 0.5 - center.y;
            if (std::abs(dx) >= std::abs(dy))
                x += dx > 0.0 ? -1 : 1;
            else
                y += dy > 0.0 ? -1 : 1;
        }
        return {x, y};
    }
};

/// The disc inscribed in a square of n texels whose left edge is at x.
inline Disc inscribed(int n, double x = 0.0, int border = 0) { return {{x + 0.5 * n, 0.5 * n}, 0.5 * n - border}; }

/// The disc of a map that has discs: of the chart at column x, which for this may lie beyond the image.
inline Disc at(const MapLayout& layout, double x)
{
    const bool second = mapping(layout.kind).charts == Charts::Halves && x >= layout.size;
    return inscribed(layout.size, second ? layout.size : 0.0, layout.border);
}

/// Whether the map ends at the rims of discs: beyond a border it goes on.
inline bool hasRim(const MapLayout& layout) { return mapping(layout.kind).hasDiscs() && layout.border == 0; }

/// Solid angle of the part of a rectangle that lies in the unit disc, for a map whose colatitude theta depends on rho = |q| alone.
///
/// d omega = sin(theta) d theta d phi = d((1 - cos theta) d phi), so by Green's theorem the solid angle of a region is the integral of
/// (1 - cos theta) d phi along its boundary. On a straight edge at distance h from the center d phi = h dt / rho^2, with t the way
/// along the edge; on the rim 1 - cos theta is constant. Neighboring texels share their edges' terms, so the sum over a map is exact.
/// @param edge  (h, t0, t1) -> integral over t of (1 - cos theta) h / rho^2
/// @param rim   1 - cos theta at rho = 1
template <class Edge>
double solidAngle(const glm::dvec2& min, const glm::dvec2& max, double rim, const Edge& edge)
{
    const auto chord = [](double h) { return h < 1.0 ? std::sqrt((1.0 - h) * (1.0 + h)) : 0.0; };
    // A piece in the first quadrant: 0 <= x0 < x1, 0 <= y0 < y1.
    const auto quadrant = [&](double x0, double x1, double y0, double y1) {
        if (x0 >= x1 || y0 >= y1 || x0 * x0 + y0 * y0 >= 1.0)
            return 0.0;
        double sum = 0.0;
        const auto side = [&](double sign, double h, double t0, double t1) {
            t1 = std::min(t1, chord(h));
            if (h > 0.0 && t1 > t0)
                sum += sign * edge(h, t0, t1);
        };
        side(1.0, x1, y0, y1);
        side(1.0, y1, x0, x1);
        side(-1.0, x0, y0, y1);
        side(-1.0, y0, x0, x1);
        if (x1 * x1 + y1 * y1 > 1.0) {
            const double low = chord(x1) > y0 ? std::atan2(chord(x1), x1) : std::atan2(y0, chord(y0));
            const double high = chord(y1) > x0 ? std::atan2(y1, chord(y1)) : std::atan2(chord(x0), x0);
            sum += rim * (high - low);
        }
        return std::max(sum, 0.0);
    };
    const auto band = [&](double y0, double y1) {
        return quadrant(std::max(min.x, 0.0), max.x, y0, y1) + quadrant(std::max(-max.x, 0.0), -min.x, y0, y1);
    };
    return band(std::max(min.y, 0.0), max.y) + band(std::max(-max.y, 0.0), -min.y);
}

} // namespace mirrorball::disc
