#include "row_sums.h"

#include "core/base/multiversion.h"

#include <algorithm>
#include <cmath>

namespace mirrorball {

namespace {

/// Four sums side by side, which the compiler makes a vector of.
typedef double Lanes __attribute__((vector_size(32), aligned(8), may_alias));

typedef float Texel4 __attribute__((vector_size(16), aligned(4), may_alias)); ///< a texel's values and the one after them

/// Running sums of a rectangle of texels: columns + 1 to a row.
struct Sums {
    int left, columns, first, rows;
    const double* sums;
    size_t stride() const { return 4 * (static_cast<size_t>(columns) + 1); }
};

[[gnu::always_inline]] inline void addSumAt(const double* row, const Sums& sums, double x, double weight, Lanes& sum)
{
    int column = static_cast<int>(x) - sums.left; // towards 0: a position just before the first texel is continued from it
    column = column < 0 ? 0 : column >= sums.columns ? sums.columns - 1 : column;
    const Lanes* at = reinterpret_cast<const Lanes*>(row) + column;
    sum += weight * (at[0] + (x - (column + sums.left)) * (at[1] - at[0]));
}

/// A straight piece within one row, which it crosses by `height` between the columns xa and xb.
[[gnu::always_inline]] inline void addRowPiece(const double* row, const Sums& sums, double xa, double xb, double height, Lanes& sum)
{
    const double low = xa < xb ? xa : xb, high = xa < xb ? xb : xa;
    const int from = static_cast<int>(low), to = static_cast<int>(high);
    if (from == to) {
        addSumAt(row, sums, 0.5 * (xa + xb), height, sum);
        return;
    }
    const double perColumn = height / (high - low);
    double x = low;
    for (int edge = from + 1; edge <= to; ++edge) {
        addSumAt(row, sums, 0.5 * (x + edge), perColumn * (edge - x), sum);
        x = edge;
    }
    if (high > x)
        addSumAt(row, sums, 0.5 * (x + high), perColumn * (high - x), sum);
}

/// The integral of W dy along a straight edge, as far as it lies in the rows.
[[gnu::always_inline]] inline void addEdge(const Sums& sums, double xa, double ya, double xb, double yb, double direction, Lanes& sum)
{
    const bool rises = ya > yb;
    const double x0 = rises ? xb : xa, y0 = rises ? yb : ya, x1 = rises ? xa : xb, y1 = rises ? ya : yb;
    const double sign = rises ? -direction : direction;
    double y = y0 > sums.first ? y0 : sums.first, x = x0;
    const double last = sums.first + sums.rows, end = y1 < last ? y1 : last;
    if (!(end > y))
        return;
    const double slope = (x1 - x0) / (y1 - y0);
    if (y != y0)
        x = x0 + slope * (y - y0);
    int row = static_cast<int>(y);
    const double* at = sums.sums + static_cast<size_t>(row - sums.first) * sums.stride();
    while (y < end) {
        const double below = row + 1.0, next = below < end ? below : end;
        const double to = next == y1 ? x1 : x0 + slope * (next - y0);
        addRowPiece(at, sums, x, to, sign * (next - y), sum);
        x = to;
        y = next;
        ++row;
        at += sums.stride();
    }
}

MIRRORBALL_CLONES
void addPolygonTo(const Sums& sums, const glm::dvec2* corners, size_t count, double* out)
{
    Lanes sum{};
    for (size_t i = 0; i < count; ++i) {
        const glm::dvec2 &a = corners[i], &b = corners[i + 1 == count ? 0 : i + 1];
        addEdge(sums, a.x, a.y, b.x, b.y, 1.0, sum);
    }
    for (size_t c = 0; c < 4; ++c)
        out[c] += sum[c];
}

/// Every edge once: what lies right of a left edge and below an upper one is the cell's, what lies beyond its right and lower edge is not.
MIRRORBALL_CLONES
void addGridTo(const Sums& sums, const RowSums::Grid& grid, double* out)
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
                addEdge(sums, x[i], y[i], x[i + 1], y[i + 1], grid.sign, sum);
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
            addEdge(sums, x[i], y[i], x[static_cast<size_t>(i) + stride], y[static_cast<size_t>(i) + stride], grid.sign, sum);
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

/// Running sums of `count` texels, each of `weights`[i] or all of weights[0], and the least value among them and *least.
template <bool each>
[[gnu::always_inline]] inline void runningSums(const float* rgb, int count, const double* weights, double* sums, float* least)
{
    Lanes sum{};
    Lanes* out = reinterpret_cast<Lanes*>(sums);
    Texel4 low{least[0], least[0], least[0], 0.0f};
    const auto add = [&](const Texel4& texel, int x) {
        out[x] = sum;
        low = texel < low ? texel : low;
        Lanes values = __builtin_convertvector(texel, Lanes);
        values[3] = 1.0;
        sum += weights[each ? x : 0] * values;
    };
    for (int x = 0; x + 1 < count; ++x)
        add(*reinterpret_cast<const Texel4*>(rgb + 3 * static_cast<size_t>(x)), x);
    const float* last = rgb + 3 * (static_cast<size_t>(count) - 1);
    add(Texel4{last[0], last[1], last[2], 0.0f}, count - 1);
    out[count] = sum;
    *least = std::min({low[0], low[1], low[2]});
}

MIRRORBALL_CLONES
float sumRows(const float* rgb, size_t floatsPerRow, int count, int rows, const double* weights, size_t weightsPerRow, double* sums)
{
    float least = 0.0f;
    for (int y = 0; y < rows; ++y, rgb += floatsPerRow, weights += weightsPerRow, sums += 4 * (static_cast<size_t>(count) + 1)) {
        if (weightsPerRow > 1)
            runningSums<true>(rgb, count, weights, sums, &least);
        else
            runningSums<false>(rgb, count, weights, sums, &least);
    }
    return least;
}

} // namespace

struct RowSums::Window {
    Sums sums{};
    bool isPositive = true;
};

/// Sums of the texels about a region, as far as they lie in the band. They stay valid until this thread asks for the next.
RowSums::Window RowSums::window(double left, double right, double top, double bottom) const
{
    const int width = m_charts.layout().width();
    const int firstColumn = std::clamp(static_cast<int>(left), 0, width - 1),
              lastColumn = std::clamp(static_cast<int>(right), 0, width - 1);
    const int firstRow = std::max(m_first, static_cast<int>(top)), endRow = std::min(end(), static_cast<int>(bottom) + 1);
    Window result;
    result.sums = {firstColumn, lastColumn - firstColumn + 1, firstRow, std::max(0, endRow - firstRow), nullptr};
    if (result.sums.rows == 0)
        return result;
    thread_local std::vector<double> buffer;
    const size_t needed = result.sums.stride() * static_cast<size_t>(result.sums.rows);
    if (buffer.size() < needed)
        buffer.resize(needed);
    const size_t row = static_cast<size_t>(firstRow - m_first), column = static_cast<size_t>(firstColumn);
    const bool latlong = m_charts.layout().kind == Parameterization::Latlong;
    const size_t perRow = latlong ? 1 : static_cast<size_t>(width);
    result.isPositive =
        sumRows(m_rgb + 3 * (row * static_cast<size_t>(width) + column), 3 * static_cast<size_t>(width), result.sums.columns,
                result.sums.rows, m_weights.data() + (latlong ? row : row * perRow + column), perRow, buffer.data()) >= 0.0f;
    result.sums.sums = buffer.data();
    return result;
}

void RowSums::assign(int first, int rows, const float* rgb, const JobControl& job)
{
    m_first = first;
    m_rows = rows;
    m_rgb = rgb;
    const bool latlong = m_charts.layout().kind == Parameterization::Latlong;
    const size_t perRow = latlong ? 1 : static_cast<size_t>(m_charts.layout().width());
    m_weights.resize(static_cast<size_t>(rows) * perRow);
    parallelRows(rows, {.stop = job.stop, .progress = {}, .threads = job.threads}, [&](int from, int to) {
        for (int y = from; y < to; ++y)
            for (size_t x = 0; x < perRow; ++x)
                m_weights[static_cast<size_t>(y) * perRow + x] = std::max(0.0, m_charts.density(static_cast<int>(x), first + y));
    });
}

bool RowSums::addPolygon(std::span<const glm::dvec2> corners, double* sum) const
{
    if (corners.empty())
        return true;
    glm::dvec2 least = corners[0], most = corners[0];
    for (const glm::dvec2& p : corners) {
        least = glm::min(least, p);
        most = glm::max(most, p);
    }
    const Window about = window(least.x, most.x, least.y, most.y);
    if (about.sums.rows > 0)
        addPolygonTo(about.sums, corners.data(), corners.size(), sum);
    return about.isPositive;
}

bool RowSums::addGrid(const Grid& grid, double* sums) const
{
    const size_t count = (static_cast<size_t>(grid.columns) + 1) * (static_cast<size_t>(grid.rows) + 1);
    const auto [left, right] = std::minmax_element(grid.x, grid.x + count);
    const auto [top, bottom] = std::minmax_element(grid.y, grid.y + count);
    const Window about = window(*left, *right, *top, *bottom);
    if (about.sums.rows > 0)
        addGridTo(about.sums, grid, sums);
    return about.isPositive;
}

void RowSums::addWhole(double* sum) const
{
    const size_t width = static_cast<size_t>(m_charts.layout().width());
    const bool latlong = m_charts.layout().kind == Parameterization::Latlong;
    for (size_t i = 0; i < width * static_cast<size_t>(m_rows); ++i) {
        const double w = m_weights[latlong ? i / width : i];
        for (size_t c = 0; c < 3; ++c)
            sum[c] += w * static_cast<double>(m_rgb[3 * i + c]);
        sum[3] += w;
    }
}

} // namespace mirrorball
