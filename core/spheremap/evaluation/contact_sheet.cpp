#include "contact_sheet.h"

#include <algorithm>
#include <cmath>

namespace mirrorball {

SheetLayout sheetLayout(size_t count, double aspect)
{
    const int cells = std::max(1, static_cast<int>(count));
    const auto with = [&](int columns) { return SheetLayout{columns, (cells + columns - 1) / columns}; };
    const int nearest = std::clamp(static_cast<int>(std::lround(std::sqrt(cells * aspect))), 1, cells);
    SheetLayout best = with(nearest);
    for (const int columns : {nearest - 1, nearest + 1})
        if (columns >= 1 && columns <= cells && with(columns).columns * with(columns).rows < best.columns * best.rows)
            best = with(columns);
    return best;
}

Image contactSheet(std::span<const Image> pictures, int columns, float background)
{
    if (pictures.empty())
        return {};
    const int width = pictures.front().width, height = pictures.front().height;
    const int rows = (static_cast<int>(pictures.size()) + columns - 1) / columns;
    Image sheet(columns * width, rows * height, 3, background);
    for (size_t k = 0; k < pictures.size(); ++k) {
        const int left = static_cast<int>(k) % columns * width, top = static_cast<int>(k) / columns * height;
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                const float* texel = pictures[k].texel(x, y);
                const float through = pictures[k].channels == 4 ? 1.0f - texel[3] : 0.0f;
                for (int c = 0; c < 3; ++c)
                    sheet.texel(left + x, top + y)[c] = texel[c] + through * background;
            }
    }
    return sheet;
}

Image cutToDisc(Image map)
{
    const float half = 0.5f * static_cast<float>(map.width);
    for (int y = 0; y < map.height; ++y)
        for (int x = 0; x < map.width; ++x) {
            const float dx = static_cast<float>(x) + 0.5f - half, dy = static_cast<float>(y) + 0.5f - half;
            const float inside = std::clamp(half - std::sqrt(dx * dx + dy * dy), 0.0f, 1.0f);
            for (int c = 0; c < 4; ++c)
                map.texel(x, y)[c] *= inside;
        }
    return map;
}

} // namespace mirrorball
