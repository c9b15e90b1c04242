#include "target_tile.h"

#include "remap.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace mirrorball {

namespace {

constexpr int leastTargetSize = 16;  ///< smaller targets are gathered from finer texels, each much smaller than a hemisphere
constexpr double longestEdge = 16.0; ///< of a texel that is remapped at once, in source texels: straight enough away from the poles
constexpr int mostColumns = 32, mostRows = 16, leastSide = 4; ///< of a tile
constexpr double tileExtent = 64.0; ///< about a tile's in the source, in texels, whose running sums the caches hold
constexpr int tooBent = 6;          ///< halvings of a tile's edges

int refinement(double ratio, const MapLayout& target)
{
    const int side = std::max({1, (leastTargetSize + target.size - 1) / target.size, static_cast<int>(std::ceil(ratio / longestEdge))});
    // With an even number of parts folds run along their edges.
    return mapping(target.kind).oddSizesFold && target.size % 2 == 1 ? side + side % 2 : side;
}

} // namespace

TargetTiles::TargetTiles(const MapLayout& given, const MapLayout& used, const ReprojectOptions& options, bool magnifies)
    : m_given(given), m_target(options.target), m_magnifies(magnifies),
      m_ratio(std::sqrt(static_cast<double>(used.width()) * used.height() / m_target.width() / m_target.height())),
      m_side(refinement(m_ratio, m_target)), m_fine{m_target.kind, m_target.size * m_side, m_target.border * m_side}, m_charts(used),
      m_outlines(m_fine, options.yaw, options.turn, m_charts)
{
}

TargetTiles::Directions TargetTiles::directionsOf(const TargetTile& tile, const TexelOutlines::Places& places) const
{
    Directions result{.places = places};
    result.x.resize(places.count());
    result.y.resize(places.count());
    result.z.resize(places.count());
    m_outlines.directions(tile.x * m_side, tile.y * m_side, places, result.x.data(), result.y.data(), result.z.data());
    return result;
}

TargetTiles::Directions TargetTiles::cornersOf(const TargetTile& tile, const glm::dvec2& step) const
{
    const auto count = [&](int texels, double by) { return static_cast<int>(std::lround(texels * m_side / by)) + 1; };
    return directionsOf(tile, {.first = {tile.x * m_side, tile.y * m_side},
                               .step = step,
                               .columns = count(tile.columns, step.x),
                               .rows = count(tile.rows, step.y)});
}

void TargetTiles::centers(const TargetTile& tile, std::vector<double>& x, std::vector<double>& y, std::vector<double>& z) const
{
    const double half = 0.5 * m_side;
    Directions result = directionsOf(tile, {.first = {tile.x * m_side + half, tile.y * m_side + half},
                                            .step = glm::dvec2(m_side),
                                            .columns = tile.columns,
                                            .rows = tile.rows});
    x = std::move(result.x);
    y = std::move(result.y);
    z = std::move(result.z);
}

/// Whether one chart holds the tile and no point in it is singular, judged by its border: charts have no holes.
bool TargetTiles::isInOneChart(const TargetTile& tile) const
{
    unsigned common = ~0u;
    bool singular = false;
    const int x0 = tile.x * m_side, y0 = tile.y * m_side, columns = tile.columns * m_side, rows = tile.rows * m_side;
    const auto see = [&](int i, int j) {
        const glm::dvec3 d = m_outlines.directionIn(x0, y0, {x0 + i, y0 + j});
        common &= m_charts.chartsOf(d);
        singular = singular || m_charts.isSingular(d);
    };
    constexpr int step = 4;
    for (int i = 0; i <= columns; i = i < columns ? std::min(i + step, columns) : i + 1)
        for (const int j : {0, rows})
            see(i, j);
    for (int j = step; j < rows; j += step)
        for (const int i : {0, columns})
            see(i, j);
    return common != 0 && !singular;
}

/// Appends the tile, halved again and again where no chart holds it, so that few texels have outlines in several.
void TargetTiles::addTiles(const TargetTile& tile, std::vector<TargetTile>& out) const
{
    if (tile.texels() == 1 || isInOneChart(tile)) {
        out.push_back(tile);
        return;
    }
    TargetTile first = tile, second = tile;
    if (tile.columns >= tile.rows) {
        first.columns = tile.columns / 2;
        second.x += first.columns;
        second.columns -= first.columns;
    } else {
        first.rows = tile.rows / 2;
        second.y += first.rows;
        second.rows -= first.rows;
    }
    addTiles(first, out);
    addTiles(second, out);
}

std::vector<TargetTile> TargetTiles::all(Order order, const JobControl& job) const
{
    // Powers of two, so that the planes between the source's charts run between tiles of most sizes.
    const double extent = std::clamp(tileExtent * m_side / m_ratio, 1.0, 1024.0); // in finer texels
    const int side = static_cast<int>(std::bit_ceil(static_cast<unsigned>(extent)));
    const int columns = std::max(1, std::clamp(side, leastSide, mostColumns) / m_side);
    const int rows = std::max(1, std::clamp(side, leastSide, mostRows) / m_side);
    // A tile lies in one chart of the target.
    const int chartColumns = m_target.chartWidth();
    std::vector<TargetTile> whole;
    for (int top = 0; top < m_target.height(); top += m_target.size)
        for (int left = 0; left < m_target.width(); left += chartColumns)
            for (int y = 0; y < m_target.size; y += rows)
                for (int x = 0; x < chartColumns; x += columns)
                    whole.push_back({.x = left + x,
                                     .y = top + y,
                                     .columns = std::min(columns, chartColumns - x),
                                     .rows = std::min(rows, m_target.size - y)});
    std::vector<std::vector<TargetTile>> parts(whole.size());
    parallelRows(static_cast<int>(whole.size()), {.stop = job.stop, .progress = {}, .threads = job.threads}, [&](int from, int to) {
        for (size_t i = static_cast<size_t>(from); i < static_cast<size_t>(to); ++i) {
            addTiles(whole[i], parts[i]);
            if (order == Order::ByRows)
                for (TargetTile& tile : parts[i])
                    tile.firstRow = earliestRow(tile);
        }
    });
    std::vector<TargetTile> result;
    for (std::vector<TargetTile>& part : parts)
        result.insert(result.end(), std::make_move_iterator(part.begin()), std::make_move_iterator(part.end()));
    return result;
}

/// A source row above which nothing of the tile lies; 0 where its border runs through several charts, or round a pole. Between two corners
/// the border may rise above both, by less than they are apart.
int TargetTiles::earliestRow(const TargetTile& tile) const
{
    const int x0 = tile.x * m_side, y0 = tile.y * m_side, x1 = x0 + tile.columns * m_side, y1 = y0 + tile.rows * m_side;
    std::vector<glm::dvec3> border;
    const auto add = [&](int x, int y) { border.push_back(m_outlines.directionIn(x0, y0, {x, y})); };
    constexpr int step = 4;
    for (int x = x0; x < x1; x += step)
        add(x, y0);
    for (int y = y0; y < y1; y += step)
        add(x1, y);
    for (int x = x1; x > x0; x -= step)
        add(x, y1);
    for (int y = y1; y > y0; y -= step)
        add(x0, y);
    unsigned common = ~0u;
    for (const glm::dvec3& d : border)
        common &= m_charts.chartsOf(d);
    if (common == 0)
        return 0;
    const int chart = std::countr_zero(common);
    double least = std::numeric_limits<double>::max(), apart = 0.0;
    glm::dvec2 before = m_charts.position(chart, border.back(), border.front());
    for (const glm::dvec3& d : border) {
        const glm::dvec2 p = m_charts.position(chart, d);
        least = std::min(least, p.y);
        apart = std::max(apart, glm::distance(p, before));
        before = p;
    }
    return std::max(0, static_cast<int>(least - apart) - 2);
}

/// How often the edges of the tile's finer texels must be halved till straight lines do for them, judged by nine of them. tooBent where
/// they would be many, or where a disc's rim runs through the tile.
int TargetTiles::halvings(const TargetTile& tile) const
{
    const int x0 = tile.x * m_side, y0 = tile.y * m_side, columns = tile.columns * m_side, rows = tile.rows * m_side;
    const bool inside = isInside(m_fine, x0, y0) && !m_outlines.endsAtRim(x0, y0);
    double bend = 0.0;
    for (const int j : {0, rows / 2, rows - 1})
        for (const int i : {0, columns / 2, columns - 1}) {
            const int x = x0 + i, y = y0 + j;
            if ((isInside(m_fine, x, y) && !m_outlines.endsAtRim(x, y)) != inside)
                return tooBent;
            bend = std::max({bend, m_outlines.bend(x, y, {x, y}, {x + 1, y}), m_outlines.bend(x, y, {x, y}, {x, y + 1})});
        }
    if (!inside) // a disc may still touch it
        for (int j = 0; j < rows; ++j)
            for (int i = 0; i < columns; ++i)
                if (m_outlines.endsAtRim(x0 + i, y0 + j))
                    return tooBent;
    return std::min(tooBent, TexelOutlines::halvings(bend));
}

void TargetTiles::markLookups(TargetTile& tile, const Directions& corners) const
{
    tile.lookedUp.assign(tile.texels(), 0);
    if (!m_magnifies)
        return;
    const auto unit = [&](int i, int j) { return glm::normalize(corners[corners.at(i, j)]); };
    // How much longer a texel's longer side is than the source's there.
    const auto magnified = [&](int i, int j) {
        const int x = i * m_side, y = j * m_side;
        const glm::dvec3 a = unit(x, y), b = unit(x + m_side, y), c = unit(x, y + m_side), d = unit(x + m_side, y + m_side);
        const double extent = 0.5 * std::max(glm::distance(a, b) + glm::distance(c, d), glm::distance(a, c) + glm::distance(b, d));
        return extent / texelAngle(m_given, a);
    };
    // Where the corners and the middle are all far from the limit to one side, so are the others.
    double least = std::numeric_limits<double>::max(), most = 0.0;
    for (const int j : {0, tile.rows / 2, tile.rows - 1})
        for (const int i : {0, tile.columns / 2, tile.columns - 1}) {
            const double ratio = magnified(i, j);
            least = std::min(least, ratio);
            most = std::max(most, ratio);
        }
    constexpr double clearly = 1.1;
    if (least > magnifiedBelow * clearly && most < 2.0 * least)
        return;
    if (most < magnifiedBelow / clearly && most < 2.0 * least) {
        tile.lookedUp.assign(tile.texels(), 1);
        return;
    }
    for (int j = 0; j < tile.rows; ++j)
        for (int i = 0; i < tile.columns; ++i)
            tile.lookedUp[static_cast<size_t>(j) * static_cast<size_t>(tile.columns) + static_cast<size_t>(i)] =
                magnified(i, j) < magnifiedBelow;
}

/// The tile's lines across or down, from points on them: each texel's edge in 2^halvings parts. Those on the tile's border are divided as
/// each itself needs, since the tile beyond it, or a texel's own outline, will do the same: so no source texel is lost between tiles.
RowSums::Lines TargetTiles::lines(TargetTile& tile, bool down, const Directions& points, int chart, int halvings) const
{
    const int edges = (down ? tile.rows : tile.columns) * m_side, last = down ? tile.columns : tile.rows; // edges to a line, last line
    const int parts = 1 << halvings, perLine = edges * parts + 1;
    std::vector<double> px(points.x.size()), py(points.x.size());
    m_charts.positions(chart, px.size(), points.x.data(), points.y.data(), points.z.data(), px.data(), py.data());
    const auto point = [&](int line, int i) { return down ? points.at(line, i) : points.at(i, line); };

    // The middles of the border's edges, first line and last, where a straight edge would run and where it should.
    const glm::dvec2 along = down ? glm::dvec2(0, 1) : glm::dvec2(1, 0), beside = glm::dvec2(1, 1) - along;
    const glm::dvec2 origin(tile.x * m_side, tile.y * m_side);
    const Directions middles = directionsOf(tile, {.first = origin + 0.5 * along,
                                                   .step = along + static_cast<double>(last * m_side) * beside,
                                                   .columns = down ? 2 : edges,
                                                   .rows = down ? edges : 2});
    std::vector<double> mx(middles.x.size()), my(middles.x.size());
    m_charts.positions(chart, mx.size(), middles.x.data(), middles.y.data(), middles.z.data(), mx.data(), my.data());

    RowSums::Lines result;
    result.x.reserve(px.size() + 16);
    result.y.reserve(px.size() + 16);
    result.starts.reserve(static_cast<size_t>(last + 1) * static_cast<size_t>(edges / m_side + 1));
    for (int line = 0; line <= last; ++line) {
        if (halvings == 0 && m_side == 1 && line != 0 && line != last) { // most lines
            for (int i = 0; i <= edges; ++i) {
                const size_t p = point(line, i);
                result.starts.push_back(static_cast<int>(result.x.size()));
                result.x.push_back(px[p]);
                result.y.push_back(py[p]);
            }
            continue;
        }
        const size_t lineStart = result.x.size();
        for (int edge = 0; edge < edges; ++edge) {
            if (edge % m_side == 0)
                result.starts.push_back(static_cast<int>(result.x.size()));
            const size_t a = point(line, edge * parts), b = point(line, (edge + 1) * parts);
            int own = halvings;
            if (line == 0 || line == last) {
                const size_t m = down ? middles.at(line == 0 ? 0 : 1, edge) : middles.at(edge, line == 0 ? 0 : 1);
                own = TexelOutlines::halvings(std::max(std::abs(0.5 * (px[a] + px[b]) - mx[m]), std::abs(0.5 * (py[a] + py[b]) - my[m])));
            }
            for (int k = 0; k < 1 << std::min(own, halvings); ++k) {
                const size_t p = point(line, edge * parts + (k << (halvings - std::min(own, halvings))));
                result.x.push_back(px[p]);
                result.y.push_back(py[p]);
            }
            if (own <= halvings)
                continue;
            result.x.resize(result.x.size() - static_cast<size_t>(parts) + 1); // all but its start
            result.y.resize(result.x.size());
            const int more = (1 << own) - 1;
            const Directions fine =
                directionsOf(tile, {.first = origin + static_cast<double>(line * m_side) * beside + (edge + 1.0 / (more + 1)) * along,
                                    .step = glm::dvec2(1.0 / (more + 1)),
                                    .columns = down ? 1 : more,
                                    .rows = down ? more : 1});
            const size_t at = result.x.size();
            result.x.resize(at + static_cast<size_t>(more));
            result.y.resize(at + static_cast<size_t>(more));
            m_charts.positions(chart, static_cast<size_t>(more), fine.x.data(), fine.y.data(), fine.z.data(), result.x.data() + at,
                               result.y.data() + at);
        }
        result.starts.push_back(static_cast<int>(result.x.size()));
        result.x.push_back(px[point(line, perLine - 1)]);
        result.y.push_back(py[point(line, perLine - 1)]);
        if (line == 0 || line == last)
            for (size_t i = lineStart; i < result.x.size(); ++i)
                tile.bounds.take({result.x[i], result.y[i]});
    }
    return result;
}

void TargetTiles::outlineGrid(TargetTile& tile, const Directions& corners, int chart, int halvings) const
{
    const double fine = 1.0 / (1 << halvings), whole = m_side;
    tile.bounds = {glm::dvec2(std::numeric_limits<double>::max()), glm::dvec2(std::numeric_limits<double>::lowest())};
    if (halvings == 0 && m_side == 1) {
        tile.across = lines(tile, false, corners, chart, 0);
        tile.down = lines(tile, true, corners, chart, 0);
    } else {
        tile.across = lines(tile, false, cornersOf(tile, {fine, whole}), chart, halvings);
        tile.down = lines(tile, true, cornersOf(tile, {whole, fine}), chart, halvings);
    }
    // The sense in which the border runs: the sum of x dy along it, from the first corner, so that little cancels.
    const glm::dvec2 origin{tile.across.x.front(), tile.across.y.front()};
    const auto along = [&](const RowSums::Lines& lines, int line, int edges) {
        const size_t perLine = static_cast<size_t>(edges) + 1, first = static_cast<size_t>(line) * perLine;
        double sum = 0.0;
        for (size_t i = static_cast<size_t>(lines.starts[first]); i < static_cast<size_t>(lines.starts[first + perLine - 1]); ++i)
            sum += (0.5 * (lines.x[i] + lines.x[i + 1]) - origin.x) * (lines.y[i + 1] - lines.y[i]);
        return sum;
    };
    const double area = along(tile.across, 0, tile.columns) + along(tile.down, tile.columns, tile.rows) -
                        along(tile.across, tile.rows, tile.columns) - along(tile.down, 0, tile.rows);
    tile.sign = area < 0.0 ? -1.0 : 1.0;
    tile.firstRow = std::max(0, static_cast<int>(tile.bounds.least.y));
    tile.endRow = static_cast<int>(std::ceil(tile.bounds.most.y));
}

void TargetTiles::outlineTexels(TargetTile& tile) const
{
    double first = m_charts.layout().height(), last = 0.0;
    for (int j = 0; j < tile.rows * m_side; ++j)
        for (int i = 0; i < tile.columns * m_side; ++i) {
            const int texel = j / m_side * tile.columns + i / m_side, x = tile.x * m_side + i, y = tile.y * m_side + j;
            if (tile.lookedUp[static_cast<size_t>(texel)])
                continue;
            // Beside a rim only the finer texels that the disc holds a part of count, unless it holds none of the whole.
            if (m_side > 1 && !isInside(m_fine, x, y) && isInside(m_target, tile.x + i / m_side, tile.y + j / m_side) &&
                m_target.border == 0)
                continue;
            for (OutlinePiece& piece : m_outlines.pieces(x, y)) {
                for (const glm::dvec2& p : piece.corners) {
                    first = std::min(first, p.y);
                    last = std::max(last, p.y);
                }
                tile.pieces.emplace_back(texel, std::move(piece));
            }
        }
    tile.firstRow = std::max(0, static_cast<int>(first));
    tile.endRow = static_cast<int>(std::ceil(last));
}

void TargetTiles::begin(TargetTile& tile) const
{
    const Directions corners = cornersOf(tile, {1.0, 1.0});
    tile.begun = true;
    tile.sums.assign(4 * tile.texels(), 0.0);
    markLookups(tile, corners);
    if (std::find(tile.lookedUp.begin(), tile.lookedUp.end(), 0) == tile.lookedUp.end()) {
        tile.endRow = 0;
        return;
    }
    unsigned common = ~0u;
    bool singular = false;
    const auto see = [&](int i, int j) {
        const glm::dvec3 d = corners[corners.at(i, j)];
        common &= m_charts.chartsOf(d);
        singular = singular || m_charts.isSingular(d);
    };
    for (int i = 0; i < corners.places.columns; ++i)
        for (const int j : {0, corners.places.rows - 1})
            see(i, j);
    for (int j = 0; j < corners.places.rows; ++j)
        for (const int i : {0, corners.places.columns - 1})
            see(i, j);
    const int halved = common != 0 && !singular ? halvings(tile) : tooBent;
    if (halved < tooBent)
        outlineGrid(tile, corners, std::countr_zero(common), halved);
    else
        outlineTexels(tile);
}

} // namespace mirrorball
