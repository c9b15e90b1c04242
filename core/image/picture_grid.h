#pragma once

#include "image.h"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

/// Variants side by side in one picture.
namespace mirrorball {

/// What a grid is made of: pictures of one size, and what stands above its columns and before its rows.
struct PictureGrid {
    std::vector<std::string> columns{}; ///< one or more
    std::vector<std::string> rows{};    ///< empty: one row without a label
    int cellWidth = 0, cellHeight = 0;  ///< pixels of a picture

    int rowCount() const { return rows.empty() ? 1 : static_cast<int>(rows.size()); }
};

/// Of the whole, labels and gaps included, in pixels.
struct GridSize {
    std::int64_t width = 0, height = 0;
};
GridSize sizeOf(const PictureGrid& grid);

/// Lays the pictures out, each asked for once, row by row, and let go of when it has been copied. Labels are light on dark and opaque;
/// a label that is wider than its place ends in "..". Labels are meant to be read in display pictures: their values are not radiance.
/// @param cell  RGBA of the grid's cell size, for a row and a column from 0
/// @return RGBA
Image layOut(const PictureGrid& grid, const std::function<Image(int row, int column)>& cell);

} // namespace mirrorball
