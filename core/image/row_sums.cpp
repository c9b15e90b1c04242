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

/// The integral of W dy along one of the lines' edges.
[[gnu::always_inline]] inline void addAlong(const Sums& sums, const RowSums::Lines& lines, size_t edge, double sign, Lanes& sum)
{
    const size_t last = static_cast<size_t>(lines.starts[edge + 1]);
    for (size_t i = static_cast<size_t>(lines.starts[edge]); i < last; ++i)
        addEdge(sums, lines.x[i], lines.y[i], lines.x[i + 1], lines.y[i + 1], sign, sum);
}

/// Every edge once: what lies right of a left edge and below an upper one is the cell's, what lies beyond its right and lower edge is not.
MIRRORBALL_CLONES
void addGridTo(const Sums& sums, const RowSums::Grid& grid, double* out)
{
    const size_t columns = static_cast<size_t>(grid.columns), rows = static_cast<size_t>(grid.rows);
    Lanes* cells = reinterpret_cast<Lanes*>(out);
    for (size_t j = 0; j <= rows; ++j)
        for (size_t i = 0; i < columns; ++i) {
            Lanes sum{};
            addAlong(sums, grid.across, j * (columns + 1) + i, grid.sign, sum);
            if (j < rows)
                cells[j * columns + i] += sum;
            if (j > 0)
                cells[(j - 1) * columns + i] -= sum;
        }
    for (size_t i = 0; i <= columns; ++i)
        for (size_t j = 0; j < rows; ++j) {
            Lanes sum{};
            addAlong(sums, grid.down, i * (rows + 1) + j, grid.sign, sum);
            if (i > 0)
                cells[j * columns + i - 1] += sum;
            if (i < columns)
                cells[j * columns + i] -= sum;
        }
}

/// A row of running sums as it grows: weight times texel, and the least value met.
struct Running {
    const float* rgb;
    const double* weights;
    Lanes* out;
    Lanes sum{};
    Texel4 least{};

    template <bool each>
    [[gnu::always_inline]] void add(const Texel4& texel, size_t x)
    {
        out[x] = sum;
        least = texel < least ? texel : least;
        Lanes values = __builtin_convertvector(texel, Lanes);
        values[3] = 1.0;
        sum += weights[each ? x : 0] * values;
    }
    [[gnu::always_inline]] const Texel4& at(size_t x) const { return *reinterpret_cast<const Texel4*>(rgb + 3 * x); }
    [[gnu::always_inline]] Texel4 last(size_t x) const { return Texel4{rgb[3 * x], rgb[3 * x + 1], rgb[3 * x + 2], 0.0f}; }
};

/// Sums of rows, each weight a texel's own or a whole row's; two rows at once, since each sum waits for the one before.
/// @return the least value, or 0
template <bool each>
[[gnu::always_inline]] inline float sumRowsOf(const float* rgb, size_t floatsPerRow, size_t count, size_t rows, const double* weights,
                                              size_t weightsPerRow, double* sums)
{
    const size_t last = count - 1;
    Texel4 least{};
    const auto row = [&](size_t y) {
        return Running{rgb + y * floatsPerRow, weights + y * weightsPerRow, reinterpret_cast<Lanes*>(sums) + y * (count + 1)};
    };
    for (size_t y = 0; y < rows; y += 2) {
        Running a = row(y), b = row(y + 1 < rows ? y + 1 : y);
        for (size_t x = 0; x < last; ++x) { // the last texel has none after it to read
            a.add<each>(a.at(x), x);
            b.add<each>(b.at(x), x);
        }
        a.add<each>(a.last(last), last);
        b.add<each>(b.last(last), last);
        a.out[count] = a.sum;
        b.out[count] = b.sum;
        least = a.least < least ? a.least : least;
        least = b.least < least ? b.least : least;
    }
    return std::min({least[0], least[1], least[2]});
}

MIRRORBALL_CLONES
float sumRows(const float* rgb, size_t floatsPerRow, size_t count, size_t rows, const double* weights, size_t weightsPerRow, double* sums)
{
    return weightsPerRow > 1 ? sumRowsOf<true>(rgb, floatsPerRow, count, rows, weights, weightsPerRow, sums)
                             : sumRowsOf<false>(rgb, floatsPerRow, count, rows, weights, weightsPerRow, sums);
}

} // namespace

struct RowSums::Window {
    Sums sums{};
    bool isPositive = true;
};

/// Sums of the texels about a region, as far as they lie in the band. They stay valid until this thread asks for the next.
RowSums::Window RowSums::window(const Bounds& bounds) const
{
    const int width = m_charts.layout().width();
    const int firstColumn = std::clamp(static_cast<int>(bounds.least.x), 0, width - 1),
              lastColumn = std::clamp(static_cast<int>(bounds.most.x), 0, width - 1);
    const int firstRow = std::max(m_first, static_cast<int>(bounds.least.y)), endRow = std::min(end(), static_cast<int>(bounds.most.y) + 1);
    Window result;
    result.sums = {firstColumn, lastColumn - firstColumn + 1, firstRow, std::max(0, endRow - firstRow), nullptr};
    if (result.sums.rows == 0)
        return result;
    thread_local std::vector<double> buffer;
    const size_t needed = result.sums.stride() * static_cast<size_t>(result.sums.rows);
    if (buffer.size() < needed)
        buffer.resize(needed);
    const size_t row = static_cast<size_t>(firstRow - m_first), column = static_cast<size_t>(firstColumn);
    const bool alike = mapping(m_charts.layout().kind).rowsAreAlike;
    const size_t perRow = alike ? 1 : static_cast<size_t>(width);
    result.isPositive =
        sumRows(m_rgb + 3 * (row * static_cast<size_t>(width) + column), 3 * static_cast<size_t>(width), result.sums.columns,
                result.sums.rows, m_weights.data() + (alike ? row : row * perRow + column), perRow, buffer.data()) >= 0.0f;
    result.sums.sums = buffer.data();
    return result;
}

void RowSums::assign(int first, int rows, const float* rgb, const JobControl& job)
{
    m_first = first;
    m_rows = rows;
    m_rgb = rgb;
    const bool alike = mapping(m_charts.layout().kind).rowsAreAlike;
    const size_t perRow = alike ? 1 : static_cast<size_t>(m_charts.layout().width());
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
    Bounds bounds{corners[0], corners[0]};
    for (const glm::dvec2& p : corners)
        bounds.take(p);
    const Window about = window(bounds);
    if (about.sums.rows > 0)
        addPolygonTo(about.sums, corners.data(), corners.size(), sum);
    return about.isPositive;
}

bool RowSums::addGrid(const Grid& grid, double* sums) const
{
    const Window about = window(grid.bounds);
    if (about.sums.rows > 0)
        addGridTo(about.sums, grid, sums);
    return about.isPositive;
}

void RowSums::addWhole(double* sum) const
{
    const size_t width = static_cast<size_t>(m_charts.layout().width());
    const bool alike = mapping(m_charts.layout().kind).rowsAreAlike;
    for (size_t i = 0; i < width * static_cast<size_t>(m_rows); ++i) {
        const double w = m_weights[alike ? i / width : i];
        for (size_t c = 0; c < 3; ++c)
            sum[c] += w * static_cast<double>(m_rgb[3 * i + c]);
        sum[3] += w;
    }
}

} // namespace mirrorball
