#include "remap.h"

#include "row_sums.h"
#include "texel_outline.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

namespace mirrorball {

namespace {

constexpr int leastSourceSize = 384; ///< smaller sources are cut up, so that the density hardly changes within a texel
constexpr int leastTargetSize = 16;  ///< smaller targets are gathered from finer texels, each much smaller than a hemisphere
constexpr double longestEdge = 16.0; ///< of a texel that is remapped at once, in source texels: straight enough away from the poles
constexpr int tileColumns = 32, tileRows = 16, leastTileSide = 4;
constexpr double tileSide = 64.0; ///< about a tile's extent in the source, in texels: whose running sums the caches hold
constexpr size_t bandBytes = size_t{12} << 20;
constexpr int leastBandRows = 8;
constexpr int tooBent = 5; ///< halvings of a tile's sides

bool hasRim(const MapLayout& layout)
{
    return layout.kind == Parameterization::Sphere || layout.kind == Parameterization::Angular ||
           (layout.kind == Parameterization::Paraboloid && layout.border == 0);
}

/// The same map with each texel cut into side x side. Of texels that a disc's rim cuts only those whose centres it holds are sure to hold
/// radiance, the others may be black in a foreign file: they become what acrossSeam() leads to.
EnvironmentMap cutUp(const EnvironmentMap& map, int side)
{
    EnvironmentMap fine({map.layout.kind, map.layout.size * side, map.layout.border * side});
    const bool rim = hasRim(map.layout);
    for (int y = 0; y < map.image.height; ++y)
        for (int x = 0; x < map.image.width; ++x) {
            const Texel from = rim && isInside(map.layout, x, y) ? acrossSeam(map.layout, {x, y}, x, y) : Texel{x, y};
            const float* texel = map.image.texel(from.x, from.y);
            for (int j = 0; j < side; ++j)
                for (int i = 0; i < side; ++i)
                    std::copy_n(texel, 3, fine.image.texel(x * side + i, y * side + j));
        }
    return fine;
}

/// A block of target texels, what is known of their outlines, and what of the source has been added to them.
struct Tile {
    int x = 0, y = 0, columns = 0, rows = 0; ///< target texels
    int firstRow = 0;                        ///< of the source that can lie in it: it may be put off till then
    int endRow = std::numeric_limits<int>::max();
    bool begun = false, done = false;
    bool positive = true; ///< none of the source's texels about it is negative
    int grid = 0;         ///< cells along a target texel's side of the grid px, py; 0: none
    double sign = 1.0;
    std::vector<double> px{}, py{};                     ///< corners of a grid of cells with straight edges, where one chart holds the tile
    std::vector<std::pair<int, OutlinePiece>> pieces{}; ///< by texel, where not
    std::vector<char> lookedUp{};                       ///< by texel: its value is the lookup at its centre
    std::vector<double> sums{};                         ///< 4 a texel

    void putOff() { *this = Tile{.x = x, .y = y, .columns = columns, .rows = rows, .firstRow = firstRow}; }
};

/// Corners of a tile's finer grid as directions in the source.
struct Corners {
    int columns = 0, rows = 0; ///< of corners
    std::vector<double> x{}, y{}, z{};
    size_t at(int i, int j) const { return static_cast<size_t>(j) * static_cast<size_t>(columns) + static_cast<size_t>(i); }
    glm::dvec3 direction(size_t k) const { return {x[k], y[k], z[k]}; }
};

class Remapper {
public:
    /// @param whole  the source where it is in memory, as it is given; `used` may be it cut up
    Remapper(const MapLayout& given, const EnvironmentMap* whole, const MapLayout& used, const ReprojectOptions& options,
             const JobControl& job)
        : m_given(given), m_whole(whole), m_target(options.target), m_resample(options.resample),
          m_side(refinement(used, options.target)), m_fine{m_target.kind, m_target.size * m_side, m_target.border * m_side}, m_charts(used),
          m_outlines(m_fine, options.yaw, m_charts), m_band(m_charts),
          m_magnifies(whole && magnification(given, options).smallest < 1.1 * magnifiedBelow), m_result(m_target)
    {
        makeTiles(job);
    }

    EnvironmentMap run(const RowReader& readRows, const float* texels, const JobControl& job);

private:
    static double ratio(const MapLayout& source, const MapLayout& target);
    static int refinement(const MapLayout& source, const MapLayout& target);
    Corners cornersOf(const Tile& tile, int perFine) const;
    void makeTiles(const JobControl& job);
    int earliestRow(const Tile& tile) const;
    int halvings(const Tile& tile) const;
    void begin(Tile& tile) const;
    void markLookups(Tile& tile, const Corners& corners) const;
    void outlineGrid(Tile& tile, const Corners& corners, int chart) const;
    void outlineTexels(Tile& tile, const Corners& corners, bool straight) const;
    void add(Tile& tile) const;
    void write(const Tile& tile);

    MapLayout m_given;
    const EnvironmentMap* m_whole;
    MapLayout m_target;
    Resample m_resample;
    int m_side; ///< of the square of finer texels that make a target texel
    MapLayout m_fine;
    MapCharts m_charts;
    TexelOutlines m_outlines;
    RowSums m_band;
    bool m_magnifies; ///< some texels may be lookups
    std::vector<Tile> m_tiles{};
    double m_total[4]{}; ///< of all bands so far, where a texel may need it
    EnvironmentMap m_result;
};

/// About the extent of a target texel in texels of the source.
double Remapper::ratio(const MapLayout& source, const MapLayout& target)
{
    return std::sqrt(static_cast<double>(source.width()) * source.height() / target.width() / target.height());
}

int Remapper::refinement(const MapLayout& source, const MapLayout& target)
{
    const int side =
        std::max({1, (leastTargetSize + target.size - 1) / target.size, static_cast<int>(std::ceil(ratio(source, target) / longestEdge))});
    // The folds of an octahedron run along texels' edges where the size is even.
    return target.kind == Parameterization::Octahedral && target.size % 2 == 1 ? side + side % 2 : side;
}

/// @param perFine  cells along the side of a finer texel
Corners Remapper::cornersOf(const Tile& tile, int perFine) const
{
    Corners corners{.columns = tile.columns * m_side * perFine + 1, .rows = tile.rows * m_side * perFine + 1};
    const size_t count = static_cast<size_t>(corners.columns) * static_cast<size_t>(corners.rows);
    corners.x.resize(count);
    corners.y.resize(count);
    corners.z.resize(count);
    m_outlines.directionsOfGrid(tile.x * m_side, tile.y * m_side, 1.0 / perFine, corners.columns, corners.rows, corners.x.data(),
                                corners.y.data(), corners.z.data());
    return corners;
}

/// A source row above which nothing of the tile lies; 0 where its border runs through several charts, or round a pole. Between two corners
/// the border may rise above both, by less than they are apart.
int Remapper::earliestRow(const Tile& tile) const
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

void Remapper::makeTiles(const JobControl& job)
{
    // A power of two, so that the planes between the source's charts run between tiles of most sizes.
    const double extent = std::clamp(tileSide * m_side / ratio(m_charts.layout(), m_target), 1.0, 1024.0); // in finer texels
    const int side = static_cast<int>(std::bit_ceil(static_cast<unsigned>(extent)));
    const int columns = std::max(1, std::clamp(side, leastTileSide, tileColumns) / m_side);
    const int rows = std::max(1, std::clamp(side, leastTileSide, tileRows) / m_side);
    // A tile lies in one chart of the m_target.
    const int chartColumns = m_target.kind == Parameterization::Latlong ? 2 * m_target.size : m_target.size;
    for (int top = 0; top < m_target.height(); top += m_target.size)
        for (int left = 0; left < m_target.width(); left += chartColumns)
            for (int y = 0; y < m_target.size; y += rows)
                for (int x = 0; x < chartColumns; x += columns)
                    m_tiles.push_back({.x = left + x,
                                       .y = top + y,
                                       .columns = std::min(columns, chartColumns - x),
                                       .rows = std::min(rows, m_target.size - y)});
    if (m_whole && m_charts.layout().kind == Parameterization::Latlong)
        return; // one band: nothing waits for its rows
    parallelRows(static_cast<int>(m_tiles.size()), {.stop = job.stop, .progress = {}, .threads = job.threads}, [&](int first, int last) {
        for (int i = first; i < last; ++i)
            m_tiles[static_cast<size_t>(i)].firstRow = earliestRow(m_tiles[static_cast<size_t>(i)]);
    });
}

/// How often the sides of the tile's finer texels must be halved till straight lines do for them, judged by nine of them: a bend falls to a
/// quarter each time. tooBent where they would be many, or where a disc's rim runs through the tile.
int Remapper::halvings(const Tile& tile) const
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
    int count = 0;
    for (; bend > outlineTolerance && count < tooBent; bend *= 0.25)
        ++count;
    return count;
}

void Remapper::markLookups(Tile& tile, const Corners& corners) const
{
    tile.lookedUp.assign(static_cast<size_t>(tile.columns) * static_cast<size_t>(tile.rows), 0);
    if (!m_magnifies)
        return;
    const auto unit = [&](size_t k) { return glm::normalize(corners.direction(k)); };
    const auto length = [&](size_t a, size_t b) { return glm::distance(unit(a), unit(b)); };
    for (int j = 0; j < tile.rows; ++j)
        for (int i = 0; i < tile.columns; ++i) {
            const int x = i * m_side, y = j * m_side;
            const size_t a = corners.at(x, y), b = corners.at(x + m_side, y), c = corners.at(x, y + m_side),
                         d = corners.at(x + m_side, y + m_side);
            const double extent = 0.5 * std::max(length(a, b) + length(c, d), length(a, c) + length(b, d));
            const double own = texelAngle(m_given, unit(a));
            tile.lookedUp[static_cast<size_t>(j) * static_cast<size_t>(tile.columns) + static_cast<size_t>(i)] =
                extent < magnifiedBelow * own;
        }
}

void Remapper::outlineGrid(Tile& tile, const Corners& corners, int chart) const
{
    const size_t count = corners.x.size();
    tile.px.resize(count);
    tile.py.resize(count);
    m_charts.positions(chart, count, corners.x.data(), corners.y.data(), corners.z.data(), tile.px.data(), tile.py.data());
    // The sense in which the grid's corners run: of all its cells, since those at a pole have no area to their first corner.
    double twice = 0.0;
    for (int j = 0; j + 1 < corners.rows; ++j)
        for (int i = 0; i + 1 < corners.columns; ++i) {
            const size_t a = corners.at(i, j), b = corners.at(i + 1, j + 1), c = corners.at(i + 1, j), d = corners.at(i, j + 1);
            twice += (tile.px[b] - tile.px[a]) * (tile.py[d] - tile.py[c]) - (tile.py[b] - tile.py[a]) * (tile.px[d] - tile.px[c]);
        }
    tile.sign = twice < 0.0 ? -1.0 : 1.0;
    const auto [least, most] = std::minmax_element(tile.py.begin(), tile.py.end());
    tile.firstRow = std::max(0, static_cast<int>(*least));
    tile.endRow = static_cast<int>(std::ceil(*most));
}

/// Texel by texel: a quadrilateral where straight edges do and one chart holds it.
void Remapper::outlineTexels(Tile& tile, const Corners& corners, bool straight) const
{
    double first = m_charts.layout().height(), last = 0.0;
    for (int j = 0; j + 1 < corners.rows; ++j)
        for (int i = 0; i + 1 < corners.columns; ++i) {
            const int texel = j / m_side * tile.columns + i / m_side, x = tile.x * m_side + i, y = tile.y * m_side + j;
            if (tile.lookedUp[static_cast<size_t>(texel)])
                continue;
            // Beside a rim only the finer texels that the disc holds a part of count, unless it holds none of the whole.
            if (m_side > 1 && !isInside(m_fine, x, y) && isInside(m_target, tile.x + i / m_side, tile.y + j / m_side) &&
                m_target.border == 0)
                continue;
            const std::array<size_t, 4> at{corners.at(i, j), corners.at(i + 1, j), corners.at(i + 1, j + 1), corners.at(i, j + 1)};
            unsigned common = straight && !m_outlines.endsAtRim(x, y) ? ~0u : 0u;
            for (const size_t k : at)
                common = m_charts.isSingular(corners.direction(k)) ? 0u : common & m_charts.chartsOf(corners.direction(k));
            std::vector<OutlinePiece> pieces;
            if (common != 0) {
                OutlinePiece piece;
                for (const size_t k : at)
                    piece.corners.push_back(m_charts.position(std::countr_zero(common), corners.direction(k)));
                const glm::dvec2 a = piece.corners[2] - piece.corners[0], b = piece.corners[3] - piece.corners[1];
                if (a.x * b.y - b.x * a.y < 0.0)
                    std::reverse(piece.corners.begin(), piece.corners.end());
                pieces.push_back(std::move(piece));
            } else {
                pieces = m_outlines.pieces(x, y);
            }
            for (OutlinePiece& piece : pieces) {
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

void Remapper::begin(Tile& tile) const
{
    const Corners corners = cornersOf(tile, 1);
    tile.begun = true;
    tile.sums.assign(4 * static_cast<size_t>(tile.columns) * static_cast<size_t>(tile.rows), 0.0);
    markLookups(tile, corners);
    if (std::find(tile.lookedUp.begin(), tile.lookedUp.end(), 0) == tile.lookedUp.end()) {
        tile.endRow = 0;
        return;
    }
    unsigned common = ~0u;
    bool singular = false;
    // Charts have no holes: what holds the tile's border holds the tile.
    const auto see = [&](int i, int j) {
        const glm::dvec3 d = corners.direction(corners.at(i, j));
        common &= m_charts.chartsOf(d);
        singular = singular || m_charts.isSingular(d);
    };
    for (int i = 0; i < corners.columns; ++i)
        for (const int j : {0, corners.rows - 1})
            see(i, j);
    for (int j = 0; j < corners.rows; ++j)
        for (const int i : {0, corners.columns - 1})
            see(i, j);
    const int halved = halvings(tile);
    if (halved < tooBent && common != 0 && !singular) {
        tile.grid = m_side << halved;
        outlineGrid(tile, halved == 0 ? corners : cornersOf(tile, 1 << halved), std::countr_zero(common));
    } else {
        outlineTexels(tile, corners, halved == 0);
    }
}

void Remapper::add(Tile& tile) const
{
    if (tile.grid > 0 &&
        !m_band.addGrid({tile.columns * tile.grid, tile.rows * tile.grid, tile.grid, tile.px.data(), tile.py.data(), tile.sign},
                        tile.sums.data()))
        tile.positive = false;
    for (const auto& [texel, piece] : tile.pieces)
        if (!m_band.addPolygon(piece.corners, tile.sums.data() + 4 * static_cast<size_t>(texel)))
            tile.positive = false;
}

void Remapper::write(const Tile& tile)
{
    for (int j = 0; j < tile.rows; ++j)
        for (int i = 0; i < tile.columns; ++i) {
            const size_t k = static_cast<size_t>(j) * static_cast<size_t>(tile.columns) + static_cast<size_t>(i);
            const double* sum = tile.sums.data() + 4 * k;
            float* out = m_result.image.texel(tile.x + i, tile.y + j);
            if (tile.lookedUp[k]) {
                const glm::dvec2 centre = static_cast<double>(m_side) * glm::dvec2(tile.x + i + 0.5, tile.y + j + 0.5);
                const glm::vec3 value = lookUp(*m_whole, m_outlines.directionIn(tile.x * m_side, tile.y * m_side, centre), m_resample);
                std::copy_n(&value.x, 3, out);
                continue;
            }
            // A texel that covers nothing is a point of a rim, wholly outside the map: give it what is everywhere.
            const double* from = sum[3] > 0.0 ? sum : m_total;
            for (int c = 0; c < 3; ++c) {
                const double value = from[c] / from[3];
                out[c] = static_cast<float>(tile.positive ? std::max(value, 0.0) : value);
            }
        }
}

/// Rows come from `readRows`, or lie at `texels`.
EnvironmentMap Remapper::run(const RowReader& readRows, const float* texels, const JobControl& job)
{
    const MapLayout& source = m_charts.layout();
    const int width = source.width(), height = source.height();
    const bool latlong = source.kind == Parameterization::Latlong;
    const size_t rowBytes = (latlong ? 12 : 20) * static_cast<size_t>(width);
    // A latlong in memory is one band: its densities are a few numbers.
    const int bandRows =
        texels && latlong ? height : std::clamp(static_cast<int>(bandBytes / rowBytes), std::min(leastBandRows, height), height);
    const JobControl quiet{.stop = job.stop, .progress = {}, .threads = job.threads};
    std::vector<float> rows(texels ? 0 : static_cast<size_t>(bandRows) * static_cast<size_t>(width) * 3);
    std::vector<size_t> waiting(m_tiles.size());
    std::iota(waiting.begin(), waiting.end(), size_t{0});
    std::stable_sort(waiting.begin(), waiting.end(), [&](size_t a, size_t b) { return m_tiles[a].firstRow < m_tiles[b].firstRow; });
    std::vector<size_t> active;
    size_t next = 0;
    for (int y = 0; y < height; y += bandRows) {
        const int count = std::min(bandRows, height - y);
        const float* band = texels ? texels + static_cast<size_t>(y) * static_cast<size_t>(width) * 3 : rows.data();
        if (!texels)
            readRows(y, count, rows.data());
        m_band.assign(y, count, band, quiet);
        if (hasRim(m_target))
            m_band.addWhole(m_total);
        for (; next < waiting.size() && m_tiles[waiting[next]].firstRow < y + count; ++next)
            active.push_back(waiting[next]);
        const bool last = y + count == height;
        const auto share = [&](int rowsDone) { return static_cast<float>(rowsDone) / static_cast<float>(height); };
        parallelRows(
            static_cast<int>(active.size()), partOf(job, share(y), share(y + count)),
            [&](int from, int to) {
                for (int i = from; i < to; ++i) {
                    Tile& tile = m_tiles[active[static_cast<size_t>(i)]];
                    if (tile.firstRow >= y + count && !last)
                        continue;
                    if (!tile.begun)
                        begin(tile);
                    if (tile.firstRow >= y + count && !last) { // too early after all: what is known of it would lie about till then
                        tile.putOff();
                        continue;
                    }
                    add(tile);
                    if (tile.endRow > y + count && !last)
                        continue;
                    write(tile);
                    tile = {.done = true};
                }
            },
            4);
        std::erase_if(active, [&](size_t i) { return m_tiles[i].done; });
    }
    return std::move(m_result);
}

} // namespace

EnvironmentMap remap(const EnvironmentMap& source, const ReprojectOptions& options, const JobControl& job)
{
    const int side = (leastSourceSize + source.layout.size - 1) / source.layout.size;
    const bool cuts = side > 1 || hasRim(source.layout);
    const EnvironmentMap cut = cuts ? cutUp(source, side) : EnvironmentMap();
    const EnvironmentMap& used = cuts ? cut : source;
    return Remapper(source.layout, &source, used.layout, options, job).run({}, used.image.texels.data(), job);
}

EnvironmentMap remapRows(const MapLayout& source, const RowReader& readRows, const ReprojectOptions& options, const JobControl& job)
{
    return Remapper(source, nullptr, source, options, job).run(readRows, nullptr, job);
}

} // namespace mirrorball
