#include "remap.h"

#include "target_tile.h"

#include "core/sphere/disc.h"

#include <algorithm>
#include <numeric>
#include <vector>

namespace mirrorball {

namespace {

constexpr int leastSourceSize = 384; ///< smaller sources are cut up, so that the density hardly changes within a texel
constexpr size_t bandBytes = size_t{12} << 20;
constexpr int leastBandRows = 8;

/// The same map with each texel cut into side x side. Of texels that a disc's rim cuts only those whose centers it holds are sure to hold
/// radiance, the others may be black in a foreign file: they become what acrossSeam() leads to.
EnvironmentMap cutUp(const EnvironmentMap& map, int side)
{
    EnvironmentMap fine({map.layout.kind, map.layout.size * side, map.layout.border * side});
    const bool rim = disc::hasRim(map.layout);
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

class Remapper {
public:
    /// @param whole  the source where it is in memory, as it is given; `used` may be it cut up
    Remapper(const MapLayout& given, const EnvironmentMap* whole, const MapLayout& used, const ReprojectOptions& options)
        : m_whole(whole), m_resample(options.resample),
          m_outlines(given, used, options, whole && magnification(given, options).smallest < 1.1 * magnifiedBelow),
          m_band(m_outlines.charts()), m_result(options.target)
    {
    }

    EnvironmentMap run(const RowReader& readRows, const float* texels, const JobControl& job);

private:
    void add(TargetTile& tile) const;
    void write(const TargetTile& tile);

    const EnvironmentMap* m_whole;
    Resample m_resample;
    TargetTiles m_outlines;
    RowSums m_band;
    std::vector<TargetTile> m_tiles{};
    double m_total[4]{}; ///< of all bands so far, where a texel may need it
    EnvironmentMap m_result;
};

void Remapper::add(TargetTile& tile) const
{
    if (!tile.across.x.empty() &&
        !m_band.addGrid({tile.columns, tile.rows, tile.across, tile.down, tile.bounds, tile.sign}, tile.sums.data()))
        tile.positive = false;
    for (const auto& [texel, piece] : tile.pieces)
        if (!m_band.addPolygon(piece.corners, tile.sums.data() + 4 * static_cast<size_t>(texel)))
            tile.positive = false;
}

void Remapper::write(const TargetTile& tile)
{
    std::vector<float> found;
    if (std::find(tile.lookedUp.begin(), tile.lookedUp.end(), 1) != tile.lookedUp.end()) {
        std::vector<double> x, y, z;
        m_outlines.centers(tile, x, y, z);
        found.resize(3 * tile.texels());
        lookUp(*m_whole, tile.texels(), x.data(), y.data(), z.data(), m_resample, found.data());
    }
    for (int j = 0; j < tile.rows; ++j)
        for (int i = 0; i < tile.columns; ++i) {
            const size_t k = static_cast<size_t>(j) * static_cast<size_t>(tile.columns) + static_cast<size_t>(i);
            float* out = m_result.image.texel(tile.x + i, tile.y + j);
            if (tile.lookedUp[k]) {
                std::copy_n(found.data() + 3 * k, 3, out);
                continue;
            }
            // A texel that covers nothing is a point of a rim, wholly outside the map: give it what is everywhere.
            const double* sum = tile.sums.data() + 4 * k;
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
    const MapLayout& source = m_outlines.charts().layout();
    const int width = source.width(), height = source.height();
    const bool latlong = source.kind == Parameterization::Latlong;
    const size_t rowBytes = (latlong ? 12 : 20) * static_cast<size_t>(width);
    // A latlong in memory is one band: its densities are a few numbers.
    const int bandRows =
        texels && latlong ? height : std::clamp(static_cast<int>(bandBytes / rowBytes), std::min(leastBandRows, height), height);
    const JobControl quiet{.stop = job.stop, .progress = {}, .threads = job.threads};
    std::vector<float> rows(texels ? 0 : static_cast<size_t>(bandRows) * static_cast<size_t>(width) * 3);
    m_tiles = m_outlines.all(bandRows == height ? TargetTiles::Order::Any : TargetTiles::Order::ByRows, job);
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
        if (disc::hasRim(m_result.layout))
            m_band.addWhole(m_total);
        for (; next < waiting.size() && m_tiles[waiting[next]].firstRow < y + count; ++next)
            active.push_back(waiting[next]);
        const bool last = y + count == height;
        const auto share = [&](int rowsDone) { return static_cast<float>(rowsDone) / static_cast<float>(height); };
        parallelRows(
            static_cast<int>(active.size()), partOf(job, share(y), share(y + count)),
            [&](int from, int to) {
                for (int i = from; i < to; ++i) {
                    TargetTile& tile = m_tiles[active[static_cast<size_t>(i)]];
                    if (tile.firstRow >= y + count && !last)
                        continue;
                    if (!tile.begun)
                        m_outlines.begin(tile);
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
    const bool cuts = side > 1 || disc::hasRim(source.layout);
    const EnvironmentMap cut = cuts ? cutUp(source, side) : EnvironmentMap();
    const EnvironmentMap& used = cuts ? cut : source;
    return Remapper(source.layout, &source, used.layout, options).run({}, used.image.texels.data(), job);
}

EnvironmentMap remapRows(const MapLayout& source, const RowReader& readRows, const ReprojectOptions& options, const JobControl& job)
{
    return Remapper(source, nullptr, source, options).run(readRows, nullptr, job);
}

} // namespace mirrorball
