#include "picture_grid.h"

#include "text_picture.h"

#include <algorithm>

namespace mirrorball {

namespace {

constexpr int gap = 4;                ///< pixels between pictures
constexpr int mostMarginLetters = 24; ///< of the labels before rows
constexpr float ground = 0.1f, ink = 0.9f;

/// Pixels to a dot of the labels: a line of text is about a twentieth of a picture's height.
int scaleOf(const PictureGrid& grid) { return std::clamp(grid.cellHeight / (20 * textHeight), 1, 16); }

int lineHeight(const PictureGrid& grid) { return textHeight * scaleOf(grid) + 2 * gap; }

/// Width of what stands before the rows.
int marginWidth(const PictureGrid& grid)
{
    size_t longest = 0;
    for (const std::string& row : grid.rows)
        longest = std::max(longest, row.size());
    if (longest == 0)
        return 0;
    return letterWidth * scaleOf(grid) * std::min(static_cast<int>(longest), mostMarginLetters) + 2 * gap;
}

/// The text as far as it fits into so many pixels.
std::string fitting(const std::string& text, int width, int scale)
{
    const auto most = static_cast<size_t>(std::max(0, width / (letterWidth * scale)));
    if (text.size() <= most)
        return text;
    return most < 3 ? text.substr(0, most) : text.substr(0, most - 2) + "..";
}

/// A label in the middle of a part of the picture. What of it is higher or wider than that is left out.
void putLabel(Image& picture, const std::string& text, int x, int y, int width, int height, int scale)
{
    const Image label = textPicture(fitting(text, width, scale), scale);
    const int left = x + (width - label.width) / 2, top = y + (height - label.height) / 2;
    for (int row = std::max(0, y - top); row < std::min(label.height, y + height - top); ++row)
        for (int column = std::max(0, x - left); column < std::min(label.width, x + width - left); ++column)
            if (*label.texel(column, row) > 0.0f)
                std::fill_n(picture.texel(left + column, top + row), 3, ink);
}

} // namespace

GridSize sizeOf(const PictureGrid& grid)
{
    const auto columns = static_cast<std::int64_t>(grid.columns.size()), rows = static_cast<std::int64_t>(grid.rowCount());
    return {marginWidth(grid) + columns * grid.cellWidth + (columns - 1) * gap,
            lineHeight(grid) + rows * grid.cellHeight + (rows - 1) * gap};
}

Image layOut(const PictureGrid& grid, const std::function<Image(int row, int column)>& cell)
{
    const GridSize size = sizeOf(grid);
    const int scale = scaleOf(grid), margin = marginWidth(grid), line = lineHeight(grid);
    Image picture(static_cast<int>(size.width), static_cast<int>(size.height), 4, ground);
    for (size_t i = 3; i < picture.texels.size(); i += 4)
        picture.texels[i] = 1.0f;
    for (int row = 0; row < grid.rowCount(); ++row) {
        const int top = line + row * (grid.cellHeight + gap);
        if (!grid.rows.empty())
            putLabel(picture, grid.rows[static_cast<size_t>(row)], 0, top, margin, grid.cellHeight, scale);
        for (int column = 0; column < static_cast<int>(grid.columns.size()); ++column) {
            const int left = margin + column * (grid.cellWidth + gap);
            if (row == 0)
                putLabel(picture, grid.columns[static_cast<size_t>(column)], left, 0, grid.cellWidth, line, scale);
            const Image drawn = cell(row, column);
            for (int y = 0; y < grid.cellHeight; ++y)
                std::copy_n(drawn.row(y), static_cast<size_t>(grid.cellWidth) * 4, picture.texel(left, top + y));
        }
    }
    return picture;
}

} // namespace mirrorball
