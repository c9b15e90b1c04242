#pragma once

#include "map_charts.h"

#include "core/base/job.h"

#include <cstddef>
#include <span>
#include <vector>

namespace mirrorball {

/// A band of a map's rows, from which integrals over polygons of the image are read.
///
/// With w the solid angle of a square texel at each place (MapCharts::density) and W(x, y) the integral of (w R, w G, w B, w) along row y
/// from the row's start to x, a piecewise constant map's integral over a region is by Green's theorem the integral of W dy around its
/// boundary: W is linear between the texels' edges, so each straight piece of the boundary within one texel counts with its middle,
/// exactly. Where the boundary runs along a row dy is 0, so a region's parts in different bands just add up. A constant in W adds nothing
/// around a whole boundary, so W starts where the region does: as running sums of the few texels about it, which stay in the cache.
class RowSums {
public:
    explicit RowSums(const MapCharts& charts) : m_charts(charts) {}
    /// Replaces the band by rows [first, first + rows), RGB, which must stay where they are.
    void assign(int first, int rows, const float* rgb, const JobControl& job);

    int first() const { return m_first; }
    int end() const { return m_first + m_rows; }

    /// Adds the integral over the part of a polygon that lies in the band to sum[0..3].
    /// @return whether no texel about it has a negative value
    bool addPolygon(std::span<const glm::dvec2> corners, double* sum) const;

    /// Parallel lines of edges, one line after the other, each edge a row of points: edge e of line l goes from point
    /// starts[l (edges + 1) + e] to the next start.
    struct Lines {
        std::vector<double> x{}, y{};
        std::vector<int> starts{};
    };
    /// An upright rectangle of the image.
    struct Bounds {
        glm::dvec2 least{}, most{};
        void take(const glm::dvec2& p)
        {
            least = glm::min(least, p);
            most = glm::max(most, p);
        }
    };
    /// A grid of cells between rows + 1 lines across, of `columns` edges each, and columns + 1 lines down, of `rows`.
    struct Grid {
        int columns = 0, rows = 0;
        const Lines& across;
        const Lines& down;
        const Bounds& bounds; ///< of its border
        double sign = 1.0;    ///< -1 where edges that run right and down make negative areas
    };
    /// Adds the integrals over the parts of the cells that lie in the band to sums, 4 a cell, row by row.
    /// @return whether no texel about them has a negative value
    bool addGrid(const Grid& grid, double* sums) const;

    /// Adds the integral over the whole band to sum[0..3].
    void addWhole(double* sum) const;

private:
    struct Window;
    Window window(const Bounds& bounds) const;

    MapCharts m_charts;
    int m_first = 0, m_rows = 0;
    const float* m_rgb = nullptr;
    std::vector<double> m_weights{}; ///< densities: one a row in a latlong, one a texel elsewhere
};

} // namespace mirrorball
