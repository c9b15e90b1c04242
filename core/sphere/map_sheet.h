#pragma once

#include "disc.h"
#include "parameterization.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

/// How a map is laid out for people to look at: as its image is, but for those whose rows unfold them (the cube, to a cross).
namespace mirrorball {

struct SheetSize {
    int width = 0;
    int height = 0;
    bool operator==(const SheetSize&) const = default;
};

inline SheetSize sheetSize(const MapLayout& layout)
{
    const Mapping& row = mapping(layout.kind);
    return {row.sheetColumns * layout.size, row.sheetRows * layout.size};
}

/// The image position that a sheet position shows; nothing beside the sheet and in the blank cells of the cross.
inline std::optional<glm::dvec2> imageFromSheet(const MapLayout& layout, const glm::dvec2& s)
{
    const SheetSize size = sheetSize(layout);
    if (!(s.x >= 0.0 && s.y >= 0.0 && s.x < size.width && s.y < size.height))
        return std::nullopt;
    const std::span<const SheetCell> cells = mapping(layout.kind).sheetCells;
    if (cells.empty())
        return s;
    const double n = layout.size;
    const int column = static_cast<int>(s.x / n), row = static_cast<int>(s.y / n);
    for (size_t chart = 0; chart < cells.size(); ++chart)
        if (cells[chart].column == column && cells[chart].row == row)
            return glm::dvec2(s.x - column * n, s.y - row * n + static_cast<double>(chart) * n);
    return std::nullopt;
}

/// The inverse of imageFromSheet().
inline glm::dvec2 sheetFromImage(const MapLayout& layout, const glm::dvec2& p)
{
    const std::span<const SheetCell> cells = mapping(layout.kind).sheetCells;
    if (cells.empty())
        return p;
    const double n = layout.size;
    const int chart = std::clamp(static_cast<int>(p.y / n), 0, static_cast<int>(cells.size()) - 1);
    const SheetCell cell = cells[static_cast<size_t>(chart)];
    return {p.x + cell.column * n, p.y - chart * n + cell.row * n};
}

/// Distance in texels from an image position to the nearest edge at which charts meet or end: the sides of a latlong and its poles, the
/// edges of a cube's faces and of the octahedral square, the rims of discs.
inline double seamDistance(const MapLayout& layout, const glm::dvec2& p)
{
    if (mapping(layout.kind).hasDiscs()) {
        const disc::Disc d = disc::at(layout, p.x);
        return std::abs(glm::length(p - d.center) - d.radius);
    }
    const double n = layout.size, width = layout.chartWidth(), charts = mapping(layout.kind).rows;
    const double y = p.y - std::clamp(std::floor(p.y / n), 0.0, charts - 1.0) * n;
    return std::min({std::abs(p.x), std::abs(width - p.x), std::abs(y), std::abs(n - y)});
}

} // namespace mirrorball
