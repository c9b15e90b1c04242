#include "row_sums.h"

#include "core/base/multiversion.h"

#include <algorithm>
#include <cmath>

namespace mirrorball {

namespace {

/// Four sums side by side, which the compiler makes a vector of.
typedef double Lanes __attribute__((vector_size(32), aligned(8), may_alias));

struct Band {
    int first, rows, width;
    size_t stride;
    const double* sums;
};

[[gnu::always_inline]] inline void addSumAt(const double* row, int width, double x, double weight, Lanes& sum)
{
    int column = static_cast<int>(x); // towards 0: a position just before the first texel is continued from it
    column = column < 0 ? 0 : column >= width ? width - 1 : column;
    const Lanes* at = reinterpret_cast<const Lanes*>(row) + column;
    sum += weight * (at[0] + (x - column) * (at[1] - at[0]));
}

/// A straight piece within one row, which it crosses by `height` between the columns xa and xb.
[[gnu::always_inline]] inline void addRowPiece(const double* row, int width, double xa, double xb, double height, Lanes& sum)
{
    const double low = xa < xb ? xa : xb, high = xa < xb ? xb : xa;
    const int from = static_cast<int>(low), to = static_cast<int>(high);
    if (from == to) {
        addSumAt(row, width, 0.5 * (xa + xb), height, sum);
        return;
    }
    const double perColumn = height / (high - low);
    double x = low;
    for (int edge = from + 1; edge <= to; ++edge) {
        addSumAt(row, width, 0.5 * (x + edge), perColumn * (edge - x), sum);
        x = edge;
    }
    if (high > x)
        addSumAt(row, width, 0.5 * (x + high), perColumn * (high - x), sum);
}

/// The integral of W dy along a straight edge, as far as it lies in the band.
[[gnu::always_inline]] inline void addEdge(const Band& band, double x0, double y0, double x1, double y1, double sign, Lanes& sum)
{
    if (y0 > y1) {
        std::swap(x0, x1);
        std::swap(y0, y1);
        sign = -sign;
    }
    double y = y0 > band.first ? y0 : band.first, x = x0;
    const double last = band.first + band.rows, end = y1 < last ? y1 : last;
    if (!(end > y))
        return;
    const double slope = (x1 - x0) / (y1 - y0);
    if (y != y0)
        x = x0 + slope * (y - y0);
    int row = static_cast<int>(y);
    const double* sums = band.sums + static_cast<size_t>(row - band.first) * band.stride;
    while (y < end) {
        const double below = row + 1.0, next = below < end ? below : end;
        const double to = next == y1 ? x1 : x0 + slope * (next - y0);
        addRowPiece(sums, band.width, x, to, sign * (next - y), sum);
        x = to;
        y = next;
        ++row;
        sums += band.stride;
    }
}

MIRRORBALL_CLONES
void addPolygonTo(const Band& band, const glm::dvec2* corners, size_t count, double* out)
{
    Lanes sum{};
    for (size_t i = 0; i < count; ++i) {
        const glm::dvec2 &a = corners[i], &b = corners[i + 1 == count ? 0 : i + 1];
        addEdge(band, a.x, a.y, b.x, b.y, 1.0, sum);
    }
    for (size_t c = 0; c < 4; ++c)
        out[c] += sum[c];
}

/// Fetches what the grid will read into the cache: its columns lie apart by whole rows, which the processor does not foresee.
void prefetch(const Band& band, const RowSums::Grid& grid)
{
    const size_t count = (static_cast<size_t>(grid.columns) + 1) * (static_cast<size_t>(grid.rows) + 1);
    const auto [left, right] = std::minmax_element(grid.x, grid.x + count);
    const auto [top, bottom] = std::minmax_element(grid.y, grid.y + count);
    const int firstColumn = std::max(0, static_cast<int>(*left)), lastColumn = std::min(band.width, static_cast<int>(*right) + 1);
    const int firstRow = std::max(band.first, static_cast<int>(*top));
    const int endRow = std::min(band.first + band.rows, static_cast<int>(*bottom) + 1);
    if (firstRow >= endRow || static_cast<size_t>(lastColumn - firstColumn) > count)
        return;
    for (int y = firstRow; y < endRow; ++y) {
        const double* row = band.sums + static_cast<size_t>(y - band.first) * band.stride;
        for (int x = firstColumn; x <= lastColumn; x += 2) // two to a cache line
            __builtin_prefetch(row + 4 * static_cast<size_t>(x), 0, 2);
    }
}

/// Every edge once: what lies right of a left edge and below an upper one is the cell's, what lies beyond its right and lower edge is not.
MIRRORBALL_CLONES
void addGridTo(const Band& band, const RowSums::Grid& grid, double* out)
{
    const int columns = grid.columns, groups = columns / grid.side;
    const size_t stride = static_cast<size_t>(columns) + 1;
    for (int j = 0; j <= grid.rows; ++j) {
        const double* x = grid.x + static_cast<size_t>(j) * stride;
        const double* y = grid.y + static_cast<size_t>(j) * stride;
        double* above = j > 0 ? out + static_cast<size_t>((j - 1) / grid.side) * static_cast<size_t>(groups) * 4 : nullptr;
        double* here = j < grid.rows ? out + static_cast<size_t>(j / grid.side) * static_cast<size_t>(groups) * 4 : nullptr;
        if (above != here) // else inside a group
            for (int i = 0; i < columns; ++i) {
                Lanes sum{};
                addEdge(band, x[i], y[i], x[i + 1], y[i + 1], grid.sign, sum);
                const size_t group = static_cast<size_t>(i / grid.side) * 4;
                for (size_t c = 0; c < 4; ++c) {
                    if (here)
                        here[group + c] += sum[c];
                    if (above)
                        above[group + c] -= sum[c];
                }
            }
        if (!here)
            continue;
        for (int i = 0; i <= columns; i += grid.side) {
            Lanes sum{};
            addEdge(band, x[i], y[i], x[static_cast<size_t>(i) + stride], y[static_cast<size_t>(i) + stride], grid.sign, sum);
            const size_t group = static_cast<size_t>(i / grid.side) * 4;
            for (size_t c = 0; c < 4; ++c) {
                if (i > 0)
                    here[group - 4 + c] += sum[c];
                if (i < columns)
                    here[group + c] -= sum[c];
            }
        }
    }
}

MIRRORBALL_CLONES
void runningSums(const float* rgb, int width, double weight, double* sums)
{
    Lanes sum{};
    Lanes* out = reinterpret_cast<Lanes*>(sums);
    const Lanes w{weight, weight, weight, weight};
    for (int x = 0; x < width; ++x, rgb += 3) {
        out[x] = sum;
        const Lanes texel{rgb[0], rgb[1], rgb[2], 1.0};
        sum += w * texel;
    }
    out[width] = sum;
}

} // namespace

RowSums::RowSums(const MapCharts& charts) : m_charts(charts), m_stride(4 * (static_cast<size_t>(charts.layout().width()) + 1)) {}

void RowSums::assignRow(int y, const float* rgb, double* sums) const
{
    const MapLayout& layout = m_charts.layout();
    const int width = layout.width();
    if (layout.kind == Parameterization::Latlong) {
        runningSums(rgb, width, m_charts.density(0, y), sums);
        return;
    }
    double sum[4]{};
    for (int x = 0; x < width; ++x, rgb += 3, sums += 4) {
        std::copy_n(sum, 4, sums);
        const double w = m_charts.density(x, y);
        if (w <= 0.0)
            continue;
        for (int c = 0; c < 3; ++c)
            sum[c] += w * rgb[c];
        sum[3] += w;
    }
    std::copy_n(sum, 4, sums);
}

void RowSums::assign(int first, int rows, const float* rgb, const JobControl& job)
{
    const int width = m_charts.layout().width();
    m_first = first;
    m_rows = rows;
    if (m_sums.size() < static_cast<size_t>(rows) * m_stride)
        m_sums.resize(static_cast<size_t>(rows) * m_stride);
    std::vector<char> negative(static_cast<size_t>(rows), 0);
    parallelRows(
        rows, {.stop = job.stop, .progress = {}, .threads = job.threads},
        [&](int from, int to) {
            for (int y = from; y < to; ++y) {
                const float* row = rgb + static_cast<size_t>(y) * static_cast<size_t>(width) * 3;
                assignRow(first + y, row, m_sums.data() + static_cast<size_t>(y) * m_stride);
                float least = 0.0f;
                for (int i = 0; i < 3 * width; ++i)
                    least = row[i] < least ? row[i] : least;
                negative[static_cast<size_t>(y)] = least < 0.0f;
            }
        },
        4);
    m_positive = m_positive && std::find(negative.begin(), negative.end(), 1) == negative.end();
    for (int y = 0; y < rows; ++y)
        for (size_t c = 0; c < 4; ++c)
            m_total[c] += m_sums[static_cast<size_t>(y) * m_stride + 4 * static_cast<size_t>(width) + c];
}

void RowSums::addPolygon(std::span<const glm::dvec2> corners, double* sum) const
{
    addPolygonTo({m_first, m_rows, m_charts.layout().width(), m_stride, m_sums.data()}, corners.data(), corners.size(), sum);
}

void RowSums::addGrid(const Grid& grid, double* sums) const
{
    const Band band{m_first, m_rows, m_charts.layout().width(), m_stride, m_sums.data()};
    prefetch(band, grid);
    addGridTo(band, grid, sums);
}

} // namespace mirrorball
