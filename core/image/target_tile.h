#pragma once

#include "reproject.h"
#include "row_sums.h"
#include "texel_outline.h"

#include <limits>
#include <utility>
#include <vector>

namespace mirrorball {

/// A block of target texels, what is known of their outlines, and what of the source has been added to them.
struct TargetTile {
    int x = 0, y = 0, columns = 0, rows = 0; ///< target texels
    int firstRow = 0;                        ///< of the source that can lie in it: it may be put off till then
    int endRow = std::numeric_limits<int>::max();
    bool begun = false, done = false;
    bool positive = true;     ///< none of the source's texels about it is negative
    RowSums::Lines across{};  ///< the texels' edges that run right, line by line, where one chart holds the tile; else empty
    RowSums::Lines down{};    ///< and those that run down
    RowSums::Bounds bounds{}; ///< of both
    double sign = 1.0;        ///< -1 where the edges run round a texel the other way in the source's image
    std::vector<std::pair<int, OutlinePiece>> pieces{}; ///< by texel, where no chart holds the tile
    std::vector<char> lookedUp{};                       ///< by texel: its value is the lookup at its center
    std::vector<double> sums{};                         ///< 4 a texel

    size_t texels() const { return static_cast<size_t>(columns) * static_cast<size_t>(rows); }
    void putOff() { *this = TargetTile{.x = x, .y = y, .columns = columns, .rows = rows, .firstRow = firstRow}; }
};

/// Cuts a target into tiles and finds their outlines in a source's image.
class TargetTiles {
public:
    /// @param given  the source's layout; `used` is it or one cut up into smaller texels
    /// @param magnifies  some texels may be lookups
    TargetTiles(const MapLayout& given, const MapLayout& used, const ReprojectOptions& options, bool magnifies);

    enum class Order { Any, ByRows };
    /// All tiles; for Order::ByRows with the first row of the source that they need.
    std::vector<TargetTile> all(Order order, const JobControl& job) const;
    /// Finds a tile's outlines and which of its texels are lookups.
    void begin(TargetTile& tile) const;
    const MapCharts& charts() const { return m_charts; }
    /// Directions in the source of the centers of a tile's texels, row by row, not normalized.
    void centers(const TargetTile& tile, std::vector<double>& x, std::vector<double>& y, std::vector<double>& z) const;

private:
    /// Places of a tile as directions in the source.
    struct Directions {
        TexelOutlines::Places places{};
        std::vector<double> x{}, y{}, z{};
        size_t at(int i, int j) const { return static_cast<size_t>(j) * static_cast<size_t>(places.columns) + static_cast<size_t>(i); }
        glm::dvec3 operator[](size_t k) const { return {x[k], y[k], z[k]}; }
    };

    Directions directionsOf(const TargetTile& tile, const TexelOutlines::Places& places) const;
    /// Every texelStep-th corner of finer texels in the tile.
    Directions cornersOf(const TargetTile& tile, const glm::dvec2& step) const;
    void addTiles(const TargetTile& tile, std::vector<TargetTile>& out) const;
    bool isInOneChart(const TargetTile& tile) const;
    int earliestRow(const TargetTile& tile) const;
    int halvings(const TargetTile& tile) const;
    void markLookups(TargetTile& tile, const Directions& corners) const;
    void outlineGrid(TargetTile& tile, const Directions& corners, int chart, int halvings) const;
    RowSums::Lines lines(TargetTile& tile, bool down, const Directions& points, int chart, int halvings) const;
    void outlineTexels(TargetTile& tile) const;

    MapLayout m_given;
    MapLayout m_target;
    bool m_magnifies;
    double m_ratio; ///< about the extent of a target texel in texels of the source
    int m_side;     ///< of the square of finer texels that make a target texel
    MapLayout m_fine;
    MapCharts m_charts;
    TexelOutlines m_outlines;
};

} // namespace mirrorball
