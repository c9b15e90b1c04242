#pragma once

#include "direction.h"
#include "disc.h"
#include "parameterization.h"

#include <algorithm>
#include <cmath>

/// Dual paraboloid map (Heidrich and Seidel 1998): the front half (z >= 0) on the left, (x, y) = r.xy / (1 + rz); the back half on the
/// right, (x, y) = r.xy / (1 - rz); x to the right and y up in both. Each is the stereographic projection from the opposite pole, so
/// circles on the sphere are circles in the map. The inverse is r = (2x, 2y, +-(1 - rho^2)) / (1 + rho^2), which holds past the rim too,
/// where it continues into the other half: rho there is 1/rho here.
///
/// 1 - cos theta = 2 rho^2 / (1 + rho^2) and d omega = 4 dA / (1 + rho^2)^2, four times denser at the rim than in the middle.
namespace mirrorball::dual_paraboloid {

inline disc::Disc half(int n, int border, bool back) { return disc::inscribed(n, back ? n : 0, border); }

inline glm::dvec3 direction(int n, int border, const glm::dvec2& p)
{
    const bool back = p.x >= n;
    const glm::dvec2 q = half(n, border, back).fromImage(p);
    const double rho2 = glm::dot(q, q), scale = 1.0 / (1.0 + rho2);
    const double z = (1.0 - rho2) * scale;
    return {2.0 * q.x * scale, 2.0 * q.y * scale, back ? -z : z};
}

/// Without a border the rim of the front half touches the back half in the image; a direction there stays the last number before.
inline glm::dvec2 coordinate(int n, int border, const glm::dvec3& r)
{
    const bool back = r.z < 0.0;
    const glm::dvec2 p = half(n, border, back).toImage(glm::dvec2(r.x, r.y) / (1.0 + std::abs(r.z)));
    return back ? p : glm::dvec2(std::min(p.x, n * (1.0 - 0x1p-53)), p.y);
}

/// 4 / (1 + rho^2)^2 in the unit disc; 0 outside.
inline double density(int n, int border, const glm::dvec2& p)
{
    const disc::Disc d = half(n, border, p.x >= n);
    const glm::dvec2 q = d.fromImage(p);
    const double rho2 = glm::dot(q, q);
    return rho2 <= 1.0 ? 4.0 / ((1.0 + rho2) * (1.0 + rho2) * d.radius * d.radius) : 0.0;
}

/// A rectangle inside one half.
double solidAngle(int n, int border, const glm::dvec2& min, const glm::dvec2& max);
Texel acrossSeam(int n, int border, Texel chart, int x, int y);

inline constexpr Mapping mapping{
    .kind = Parameterization::Paraboloid,
    .name = "paraboloid",
    .axes = "front half (z >= 0) on the left: (x, y) = r.xy / (1 + r.z); back half on the right: (x, y) = r.xy / (1 - r.z); right is +X "
            "and top +Y in both",
    .seen = "+X right in both halves",
    .charts = Charts::Halves,
    .columns = 2,
    .rows = 1,
    .chartColumns = 1,
    .hasBorder = true,
    .rowsAreAlike = false,
    .oddSizesFold = false,
    .quarterTurns = 2,
    .leastQuarter = 4,
    .longestSide = 0.0,
    .latlongRows = 2,
    .sheetColumns = 2,
    .sheetRows = 1,
    .sheetCells = {},
    .direction = [](const MapLayout& layout, const glm::dvec2& p) { return direction(layout.size, layout.border, p); },
    .coordinate = [](const MapLayout& layout, const glm::dvec3& d) { return coordinate(layout.size, layout.border, d); },
    .density = [](const MapLayout& layout, const glm::dvec2& p) { return density(layout.size, layout.border, p); },
    .solidAngle = [](const MapLayout& layout, const glm::dvec2& min,
                     const glm::dvec2& max) { return solidAngle(layout.size, layout.border, min, max); },
    .acrossSeam = [](const MapLayout& layout, Texel chart, int x, int y) { return acrossSeam(layout.size, layout.border, chart, x, y); },
};

} // namespace mirrorball::dual_paraboloid
