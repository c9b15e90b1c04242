#pragma once

#include "stroke_raster.h"

#include <memory>
#include <mutex>
#include <span>
#include <vector>

namespace mirrorball {

/// Strokes as texels without a raster of the whole map: each tile (tile_set.h) is painted when it is first read, by the thread that reads
/// it, and those that no stroke meets do not exist. The same bytes as paintStrokes().
class StrokeTiles {
public:
    /// @param strokes  none that smudges, because smudging reads other tiles
    /// @throws InvalidArgument as validate() does, or naming the size
    StrokeTiles(std::span<const Stroke> strokes, int size, const JobControl& job = {});

    /// Whether strokes can be painted so.
    static bool canPaint(std::span<const Stroke> strokes);

    int size() const { return m_size; }
    /// The four channels of texel (x, y) of the map, and of those to its right as far as the tile goes; null where the tile is empty.
    /// Called from many threads at once. @throws Cancelled
    const float* texel(int x, int y) const;

private:
    struct Tile {
        std::once_flag painted;
        std::unique_ptr<float[]> texels;
        bool meets = false; ///< any stroke
    };

    int m_size;
    int m_columns;
    JobControl m_job;
    std::vector<TexelStroke> m_strokes{};
    std::unique_ptr<Tile[]> m_tiles;
};

} // namespace mirrorball
