#pragma once

#include "cube_map.h"
#include "disc.h"
#include "dual_paraboloid.h"
#include "parameterization.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

/// How a map is laid out for people to look at: as its image is, but for the cube, whose stack of faces is unfolded to a cross of 4N x 3N:
///
///          +Y
///      -X  +Z  +X  -Z
///          -Y
///
/// OpenGL's face axes meet along these edges as they are, so no face is turned.
namespace mirrorball {

struct SheetSize {
    int width = 0;
    int height = 0;
    bool operator==(const SheetSize&) const = default;
};

inline SheetSize sheetSize(const MapLayout& layout)
{
    return layout.kind == Parameterization::Cube ? SheetSize{4 * layout.size, 3 * layout.size} : SheetSize{layout.width(), layout.height()};
}

namespace cube_cross {

struct Cell {
    int column = 0;
    int row = 0;
};
inline constexpr std::array<Cell, 6> cells{{{2, 1}, {0, 1}, {1, 0}, {1, 2}, {1, 1}, {3, 1}}}; ///< of +X -X +Y -Y +Z -Z

} // namespace cube_cross

/// The image position that a sheet position shows; nothing beside the sheet and in the blank cells of the cross.
inline std::optional<glm::dvec2> imageFromSheet(const MapLayout& layout, const glm::dvec2& s)
{
    const SheetSize size = sheetSize(layout);
    if (!(s.x >= 0.0 && s.y >= 0.0 && s.x < size.width && s.y < size.height))
        return std::nullopt;
    if (layout.kind != Parameterization::Cube)
        return s;
    const double n = layout.size;
    const int column = static_cast<int>(s.x / n), row = static_cast<int>(s.y / n);
    for (size_t face = 0; face < 6; ++face)
        if (cube_cross::cells[face].column == column && cube_cross::cells[face].row == row)
            return glm::dvec2(s.x - column * n, s.y - row * n + static_cast<double>(face) * n);
    return std::nullopt;
}

/// The inverse of imageFromSheet().
inline glm::dvec2 sheetFromImage(const MapLayout& layout, const glm::dvec2& p)
{
    if (layout.kind != Parameterization::Cube)
        return p;
    const double n = layout.size;
    const int face = std::clamp(static_cast<int>(p.y / n), 0, 5);
    const cube_cross::Cell cell = cube_cross::cells[static_cast<size_t>(face)];
    return {p.x + cell.column * n, p.y - face * n + cell.row * n};
}

/// Distance in texels from an image position to the nearest edge at which charts meet or end: the sides of a latlong and its poles, the
/// edges of a cube's faces and of the octahedral square, the rims of discs.
inline double seamDistance(const MapLayout& layout, const glm::dvec2& p)
{
    const double n = layout.size;
    const auto fromEdges = [](double x, double y, double width, double height) {
        return std::min({std::abs(x), std::abs(width - x), std::abs(y), std::abs(height - y)});
    };
    const auto fromRim = [&](const disc::Disc& d) { return std::abs(glm::length(p - d.center) - d.radius); };
    switch (layout.kind) {
    case Parameterization::Latlong:
        return fromEdges(p.x, p.y, 2.0 * n, n);
    case Parameterization::Cube:
        return fromEdges(p.x, p.y - std::clamp(std::floor(p.y / n), 0.0, 5.0) * n, n, n);
    case Parameterization::Octahedral:
        return fromEdges(p.x, p.y, n, n);
    case Parameterization::Paraboloid:
        return fromRim(dual_paraboloid::half(layout.size, layout.border, p.x >= n));
    default:
        return fromRim(disc::inscribed(layout.size));
    }
}

} // namespace mirrorball
