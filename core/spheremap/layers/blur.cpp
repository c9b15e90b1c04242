#include "blur.h"

#include "core/spheremap/math/fast_math.h"
#include "core/spheremap/math/resample.h"
#include "core/spheremap/math/span.h"

#include "core/sphere/direction.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <vector>

namespace mirrorball {

namespace {

/// What is blurred varies over sigma, so it is computed on a grid of cells about half a sigma wide and read smoothly from there. The grid
/// is azimuthal equidistant, p = theta (cos phi, sin phi) with theta the angle from +Z: the picture's own grid would do badly at the rim,
/// where it shows a wide angle in a narrow ring. Mirror directions go all around, and near -Z such a grid is stretched without bound: what
/// lies behind has a grid of its own, about -Z. So no grid is stretched by more than pi/2, and a kernel never reaches more than that many
/// cells.
constexpr float cellsPerSigma = 2.0f;
constexpr float reachInSigmas = 3.5f;

struct Grid {
    float cell;   ///< edge, radians
    float border; ///< radians past its hemisphere's edge that have a value: what the spline reads there
    int size;     ///< cells along an edge

    static constexpr float farthest = 1.57079637f; ///< theta at its hemisphere's edge

    Grid(float sigma, const Level& level)
    {
        const bool mirror = level.index == SphereMapIndex::Reflection; // theta is twice the normal's angle
        // Never finer than the map's texels at its center.
        cell = std::max(sigma / cellsPerSigma, (mirror ? 4.0f : 2.0f) / static_cast<float>(level.size));
        const int cells = mirror ? 5 : 3; // the spline reads 2 sqrt 2 further than what is asked for, which may be fade() past the edge
        border = static_cast<float>(cells) * cell;
        size = 2 * (static_cast<int>(std::ceil(farthest / cell)) + cells) + 1;
    }
    float coordinate(int i) const { return (static_cast<float>(i) - 0.5f * static_cast<float>(size - 1)) * cell; }
    float index(float p) const { return p / cell + 0.5f * static_cast<float>(size); } // image position
    /// Half of the ring about the edge in which one hemisphere's values go over into the other's.
    float fade() const { return 2.0f * cell; }
};

/// The hemisphere about +Z or about -Z.
enum class Side { Front, Back };

/// Halvings of a picture, so that a cell averages what it stands for.
std::vector<Image> halvings(const Image& picture, int levels, const JobControl& job)
{
    std::vector<Image> all;
    const Image* large = &picture;
    for (int level = 1; level <= levels && large->width > 1 && large->height > 1; ++level) {
        Image small((large->width + 1) / 2, (large->height + 1) / 2, 4);
        parallelRows(small.height, job, [&](int first, int last) {
            for (int y = first; y < last; ++y)
                for (int x = 0; x < small.width; ++x) {
                    const int x0 = 2 * x, x1 = std::min(x0 + 1, large->width - 1), y0 = 2 * y, y1 = std::min(y0 + 1, large->height - 1);
                    const float *a = large->texel(x0, y0), *b = large->texel(x1, y0), *c = large->texel(x0, y1), *d = large->texel(x1, y1);
                    for (int k = 0; k < 4; ++k)
                        small.texel(x, y)[k] = 0.25f * (a[k] + b[k] + c[k] + d[k]);
                }
        });
        all.push_back(std::move(small));
        large = &all.back();
    }
    return all;
}

/// A picture at a position of the whole map, of which it holds the part from (left, top) on. Whole and part give the same bits.
void sampleLinearly(const Image& image, float x, float y, int left, int top, float* out)
{
    x -= 0.5f;
    y -= 0.5f;
    const float floorX = std::floor(x), floorY = std::floor(y), fx = x - floorX, fy = y - floorY;
    const auto column = [&](int i) { return std::clamp(static_cast<int>(floorX) + i - left, 0, image.width - 1); };
    const auto row = [&](int j) { return std::clamp(static_cast<int>(floorY) + j - top, 0, image.height - 1); };
    const float *a = image.texel(column(0), row(0)), *b = image.texel(column(1), row(0));
    const float *c = image.texel(column(0), row(1)), *d = image.texel(column(1), row(1));
    for (int k = 0; k < 4; ++k) {
        const float upper = a[k] + fx * (b[k] - a[k]), lower = c[k] + fx * (d[k] - c[k]);
        out[k] = upper + fy * (lower - upper);
    }
}

/// The cells' directions, solid angles and colors; a channel an array, a row of the grid after the other. Cells outside the disc have no
/// weight. Padded by a border of zeros so that a kernel's window never leaves them.
struct Cells {
    Side side;
    int stride = 0;
    int pad = 0;
    std::vector<float> x, y, z, weight, r, g, b, a;

    Cells(Side hemisphere, const Grid& grid, int padding) : side(hemisphere), stride(grid.size + 2 * padding), pad(padding)
    {
        const size_t count = static_cast<size_t>(stride) * static_cast<size_t>(stride);
        for (std::vector<float>* channel : {&x, &y, &z, &weight, &r, &g, &b, &a})
            channel->assign(count, 0.0f);
    }
    size_t at(int i, int j) const { return static_cast<size_t>(j + pad) * static_cast<size_t>(stride) + static_cast<size_t>(i + pad); }
};

struct Sums {
    float weight = 0.0f, r = 0.0f, g = 0.0f, b = 0.0f, a = 0.0f;
};

/// Adds the cells of a row's part. Eight running sums a channel, so that the compiler makes vector code and the order never changes.
MIRRORBALL_VECTOR_CLONES void addRow(const Cells& cells, size_t first, int count, const glm::vec3& n, float kappa, Sums& sums)
{
    constexpr int lanes = 8;
    float w[lanes] = {}, r[lanes] = {}, g[lanes] = {}, b[lanes] = {}, a[lanes] = {};
    const float *cx = cells.x.data() + first, *cy = cells.y.data() + first, *cz = cells.z.data() + first;
    const float *cw = cells.weight.data() + first, *cr = cells.r.data() + first, *cg = cells.g.data() + first;
    const float *cb = cells.b.data() + first, *ca = cells.a.data() + first;
    for (int i = 0; i < count; i += lanes)
        for (int k = 0; k < lanes; ++k) {
            const float t = cw[i + k] * fast::exp2(kappa * (n.x * cx[i + k] + n.y * cy[i + k] + n.z * cz[i + k] - 1.0f));
            w[k] += t;
            r[k] += t * cr[i + k];
            g[k] += t * cg[i + k];
            b[k] += t * cb[i + k];
            a[k] += t * ca[i + k];
        }
    for (int k = 0; k < lanes; ++k) {
        sums.weight += w[k];
        sums.r += r[k];
        sums.g += g[k];
        sums.b += b[k];
        sums.a += a[k];
    }
}

class Blur {
public:
    Blur(float sigma, const Level& level)
        : m_mirror(level.index == SphereMapIndex::Reflection), m_size(level.size), m_sigma(sigma), m_grid(sigma, level)
    {
    }

    /// Blurring moves light at most so far in the picture: an angle a on the ball is at most a radii, and half of that by mirror
    /// directions, where however the whole rim is one direction. Behind the rim the ball has its nearest point's color, which is no
    /// farther away.
    TexelRect widened(const TexelRect& rect) const
    {
        const TexelRect all{0, 0, m_size, m_size};
        if (m_mirror)
            return all;
        const float reach =
            (reachInSigmas * m_sigma + 4.0f * m_grid.cell) * 0.5f * static_cast<float>(m_size); // cells: the grid's interpolation
        if (reach > static_cast<float>(m_size))
            return all;
        TexelRect grown = rect.grown(static_cast<int>(std::ceil(reach)) + 2, m_size);
        const int step = 1 << coarsest(); // halving a part is halving the whole
        grown.x0 -= grown.x0 % step;
        grown.y0 -= grown.y0 % step;
        return grown;
    }

    Image apply(const Image& below, const TexelRect& given, const TexelRect& wanted, const JobControl& job) const
    {
        const std::vector<Image> coarse = halvings(below, coarsest(), job);
        std::vector<Cells> cells;
        for (const Side side : m_mirror ? std::vector{Side::Front, Side::Back} : std::vector{Side::Front}) {
            cells.emplace_back(side, m_grid, 8);
            fillCells(below, coarse, given, cells.back(), job);
        }
        std::vector<Image> blurred;
        for (const Cells& hemisphere : cells)
            blurred.push_back(blurCells(cells, hemisphere.side, wanted, job));
        return read(blurred, wanted, job);
    }

private:
    /// Halvings until a texel at the center of the disc is as large as a cell.
    int coarsest() const
    {
        const float texel = (m_mirror ? 2.0f : 1.0f) * 2.0f / static_cast<float>(m_size); // radians
        return std::max(0, static_cast<int>(std::floor(std::log2(m_grid.cell / texel))));
    }
    /// sin(theta/2) for mirror directions, sin(theta) for normals: the radius on the disc.
    float discRadius(float theta) const { return std::sin(m_mirror ? 0.5f * theta : theta); }

    void fillCells(const Image& below, const std::vector<Image>& coarse, const TexelRect& given, Cells& cells, const JobControl& job) const
    {
        parallelRows(m_grid.size, job, [&](int first, int last) {
            for (int j = first; j < last; ++j)
                for (int i = 0; i < m_grid.size; ++i)
                    fillCell(below, coarse, given, cells, i, j);
        });
    }

    void fillCell(const Image& below, const std::vector<Image>& coarse, const TexelRect& given, Cells& cells, int i, int j) const
    {
        const float px = m_grid.coordinate(i), py = m_grid.coordinate(j); // y up
        const float theta = std::sqrt(px * px + py * py);
        // A cell that the edge cuts counts in part, and stands in the middle of that part.
        const float inside = std::min(std::max((Grid::farthest - theta) / m_grid.cell + 0.5f, 0.0f), 1.0f);
        if (inside <= 0.0f)
            return;
        const size_t at = cells.at(i, j);
        const float held = std::min(theta, Grid::farthest - 0.5f * inside * m_grid.cell);
        const float sine = std::sin(held), inverse = theta > 0.0f ? 1.0f / theta : 0.0f;
        const glm::vec2 phi = theta > 0.0f ? glm::vec2(px, py) * inverse : glm::vec2(1.0f, 0.0f);
        cells.x[at] = sine * phi.x;
        cells.y[at] = sine * phi.y;
        cells.z[at] = cells.side == Side::Front ? std::cos(held) : -std::cos(held);
        cells.weight[at] = inside * (theta > 1e-3f ? std::max(sine, 0.0f) * inverse : 1.0f); // sin theta / theta, the cell's solid angle
        const float fromFront = cells.side == Side::Front ? held : 2.0f * Grid::farthest - held;
        const float radius = discRadius(fromFront), half = 0.5f * static_cast<float>(m_size);
        // The copy whose texels are as large as the cell's shorter side in the picture, which towards the rim is the radial one.
        const float radial = m_grid.cell * half * (m_mirror ? 0.5f * std::cos(0.5f * fromFront) : std::cos(held));
        const int level = std::clamp(static_cast<int>(std::floor(std::log2(std::max(radial, 1.0f)))), 0, static_cast<int>(coarse.size()));
        const Image& source = level == 0 ? below : coarse[static_cast<size_t>(level) - 1];
        const float scale = 1.0f / static_cast<float>(1 << level);
        // Behind, a cell is a long arc of the picture: near -Z all around the rim.
        const float arc = cells.side == Side::Front ? 0.0f : theta > 0.0f ? std::min(m_grid.cell * inverse, 6.28318531f) : 6.28318531f;
        const int samples = cells.side == Side::Front ? 1 : std::max(1, static_cast<int>(std::lround(arc * half * radius * scale)));
        glm::vec4 sum(0.0f);
        for (int k = 0; k < samples; ++k) {
            const float turn = arc * ((static_cast<float>(k) + 0.5f) / static_cast<float>(samples) - 0.5f), c = std::cos(turn),
                        sn = std::sin(turn);
            const glm::vec2 q = radius * (samples > 1 ? glm::vec2(c * phi.x - sn * phi.y, sn * phi.x + c * phi.y) : phi);
            glm::vec4 rgba;
            sampleLinearly(source, half * (1.0f + q.x) * scale, half * (1.0f - q.y) * scale, given.x0 >> level, given.y0 >> level, &rgba.x);
            sum += rgba;
        }
        sum /= static_cast<float>(samples);
        cells.r[at] = sum.r;
        cells.g[at] = sum.g;
        cells.b[at] = sum.b;
        cells.a[at] = sum.a;
    }

    /// The part of the grid that `wanted` reads.
    TexelRect gridPart(const TexelRect& wanted) const
    {
        if (wanted == TexelRect{0, 0, m_size, m_size} || m_mirror)
            return {0, 0, m_grid.size, m_grid.size};
        float x0 = 1e9f, y0 = 1e9f, x1 = -1e9f, y1 = -1e9f;
        const auto add = [&](int x, int y) {
            const glm::vec2 p = position(x, y);
            x0 = std::min(x0, p.x);
            x1 = std::max(x1, p.x);
            y0 = std::min(y0, p.y);
            y1 = std::max(y1, p.y);
        };
        for (int x = wanted.x0; x < wanted.x1; ++x) {
            add(x, wanted.y0);
            add(x, wanted.y1 - 1);
        }
        for (int y = wanted.y0; y < wanted.y1; ++y) {
            add(wanted.x0, y);
            add(wanted.x1 - 1, y);
        }
        // The map to the grid stretches outwards along rays: the rectangle's image lies within its border's bounds.
        return TexelRect{static_cast<int>(std::floor(x0)) - 3, static_cast<int>(std::floor(y0)) - 3, static_cast<int>(std::ceil(x1)) + 3,
                         static_cast<int>(std::ceil(y1)) + 3}
            .intersected({0, 0, m_grid.size, m_grid.size});
    }

    /// The direction that a texel of the map stands for.
    struct Place {
        float theta; ///< from +Z
        glm::vec2 phi;
    };
    Place place(int x, int y) const
    {
        const float texel = 2.0f / static_cast<float>(m_size);
        const glm::vec2 q((static_cast<float>(x) + 0.5f) * texel - 1.0f, 1.0f - (static_cast<float>(y) + 0.5f) * texel);
        const float length = std::sqrt(q.x * q.x + q.y * q.y);
        return {(m_mirror ? 2.0f : 1.0f) * std::asin(std::min(length, 1.0f)), length > 0.0f ? q / length : q};
    }
    /// Where on the front grid's image (its row 0 at the lowest p.y) a texel of the map lies.
    glm::vec2 position(int x, int y) const
    {
        const Place at = place(x, y);
        return {m_grid.index(at.theta * at.phi.x), m_grid.index(at.theta * at.phi.y)};
    }

    Image blurCells(const std::vector<Cells>& cells, Side side, const TexelRect& wanted, const JobControl& job) const
    {
        const TexelRect part = gridPart(wanted);
        Image blurred(m_grid.size, m_grid.size, 4);
        parallelRows(
            part.height(), job,
            [&](int first, int last) {
                for (int j = part.y0 + first; j < part.y0 + last; ++j)
                    for (int i = part.x0; i < part.x1; ++i)
                        blurCell(cells, side, i, j, blurred.texel(i, j));
            },
            1);
        return blurred;
    }

    void blurCell(const std::vector<Cells>& cells, Side side, int i, int j, float* out) const
    {
        const float px = m_grid.coordinate(i), py = m_grid.coordinate(j), theta = std::sqrt(px * px + py * py);
        if (theta > Grid::farthest + m_grid.border)
            return;
        // Normals end at the rim: cells that lie beyond it stand for it.
        const float held = m_mirror ? theta : std::min(theta, Grid::farthest), inverse = theta > 0.0f ? 1.0f / theta : 0.0f;
        const glm::vec2 phi(px * inverse, py * inverse);
        const float z = std::cos(held);
        const glm::vec3 n(std::sin(held) * phi, side == Side::Front ? z : -z);
        Sums sums;
        for (const Cells& hemisphere : cells)
            addCells(hemisphere, hemisphere.side == side ? held : 2.0f * Grid::farthest - held, phi, n, sums);
        const float share = 1.0f / std::max(sums.weight, 1e-30f);
        out[0] = sums.r * share;
        out[1] = sums.g * share;
        out[2] = sums.b * share;
        out[3] = sums.a * share;
    }

    /// Adds the cells of a hemisphere that the kernel about n reaches. Those within an angle of n are within that angle of the point of the
    /// hemisphere that is nearest to n, and the grid is stretched by at most pi/2.
    /// @param theta  of n, from the hemisphere's pole
    void addCells(const Cells& cells, float theta, const glm::vec2& phi, const glm::vec3& n, Sums& sums) const
    {
        const float angle = reachInSigmas * m_sigma;
        if (theta - angle > Grid::farthest)
            return;
        const float kappa = 1.44269504f / (m_sigma * m_sigma); // for 2^x
        const int reach = static_cast<int>(std::ceil(1.6f * std::ceil(angle / m_grid.cell)));
        const float nearest = std::min(theta, Grid::farthest) / m_grid.cell, middle = 0.5f * static_cast<float>(m_grid.size - 1);
        const int ci = static_cast<int>(std::lround(nearest * phi.x + middle)),
                  cj = static_cast<int>(std::lround(nearest * phi.y + middle));
        const int i0 = std::max(ci - reach, 0), i1 = std::min(ci + reach, m_grid.size - 1);
        const int count = (i1 - i0 + 8) / 8 * 8; // the padding holds zeros
        for (int row = std::max(cj - reach, 0); row <= std::min(cj + reach, m_grid.size - 1); ++row)
            addRow(cells, cells.at(i0, row), count, n, kappa, sums);
    }

    /// @param blurred  of the front, and of the back where there is one
    Image read(const std::vector<Image>& blurred, const TexelRect& wanted, const JobControl& job) const
    {
        Image result(wanted.width(), wanted.height(), 4);
        parallelRows(result.height, job, [&](int first, int last) {
            for (int y = first; y < last; ++y)
                for (int x = 0; x < result.width; ++x) {
                    const Place at = place(wanted.x0 + x, wanted.y0 + y);
                    const float behind = m_mirror ? smooth(0.5f + 0.5f * (at.theta - Grid::farthest) / m_grid.fade()) : 0.0f;
                    const auto sampled = [&](size_t side, float theta) {
                        glm::vec4 rgba;
                        sampleSmoothly<4>(blurred[side], m_grid.index(theta * at.phi.x), m_grid.index(theta * at.phi.y), &rgba.x);
                        return rgba;
                    };
                    glm::vec4 rgba(0.0f);
                    if (behind < 1.0f)
                        rgba += (1.0f - behind) * sampled(0, at.theta);
                    if (behind > 0.0f)
                        rgba += behind * sampled(1, 2.0f * Grid::farthest - at.theta);
                    rgba.a = std::min(rgba.a, 1.0f);
                    std::copy_n(&rgba.x, 4, result.texel(x, y));
                }
        });
        return result;
    }

    bool m_mirror;
    int m_size;
    float m_sigma;
    Grid m_grid;
};

} // namespace

Warp prepare(const BlurLayer& layer, const Level& level)
{
    const double sigma = layer.sigmaDeg * pi / 180.0;
    if (sigma < 0.25 * level.texel()) // less than a quarter of a texel: nothing to see
        return {.needs = [](const TexelRect& r) { return r; },
                .reaches = [](const TexelRect& r) { return r; },
                .apply =
                    [](const Image& below, const TexelRect& given, const TexelRect& wanted, const JobControl&) {
                        Image part(wanted.width(), wanted.height(), 4);
                        for (int y = 0; y < part.height; ++y)
                            std::copy_n(below.texel(wanted.x0 - given.x0, wanted.y0 - given.y0 + y), 4 * static_cast<size_t>(part.width),
                                        part.row(y));
                        return part;
                    }};
    const Blur blur(static_cast<float>(sigma), level);
    const auto widened = [blur](const TexelRect& rect) { return blur.widened(rect); };
    return {.needs = widened,
            .reaches = widened,
            .apply = [blur](const Image& below, const TexelRect& given, const TexelRect& wanted, const JobControl& job) {
                return blur.apply(below, given, wanted, job);
            }};
}

} // namespace mirrorball
