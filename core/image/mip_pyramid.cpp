#include "mip_pyramid.h"

#include "core/base/error.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

/// Both wishes for a level, that a constant stays and that energy stays, are wishes for a matrix M (source texel i to box X): row sums the
/// boxes' solid angles, column sums the texels'. The clipped overlap Omega(i and X) is such a matrix, exactly. Blurring over the boxes'
/// edges keeps both if it only moves radiance between two texels at a time, in equal and opposite amounts proportional to their difference:
///   L_i += (c / omega_i) (L_j - L_i),   L_j += (c / omega_j) (L_i - L_j),   c = omega_i omega_j / (2 (omega_i + omega_j)).
/// For equal texels that is a quarter of the difference, which makes [1 3 3 1]/8 of the box. No texel has to exist diagonally over a
/// corner, and a texel gives away less than a half to each neighbor, so nothing turns negative beside a sun.
namespace mirrorball {

namespace {

MapLayout halved(const MapLayout& layout)
{
    MapLayout half{layout.kind, std::max(1, layout.size / 2), 0};
    if (layout.border > 0)
        half.border = std::min((layout.border + 1) / 2, (half.size - 1) / 2);
    return half;
}

/// Where the edges of the coarser level's texels lie in the finer level, in texels from the start of a chart. Charts correspond
/// edge to edge, discs rim to rim.
struct Boxes {
    double fineMiddle;
    double coarseMiddle;
    double scale;

    Boxes(const MapLayout& fine, const MapLayout& coarse)
        : fineMiddle(0.5 * fine.size), coarseMiddle(0.5 * coarse.size), scale((fineMiddle - fine.border) / (coarseMiddle - coarse.border))
    {
    }
    double edge(int i) const { return fineMiddle + (i - coarseMiddle) * scale; }
    bool isPairs() const { return scale == 2.0 && edge(0) == 0.0; }
};

/// How much the border between texels b - 1 and b of the finer level is an edge of a box: 1 on it, less beside an edge within a texel.
std::vector<double> edgeStrengths(const Boxes& boxes, int texels)
{
    std::vector<double> strengths(static_cast<size_t>(texels) + 1, 0.0);
    for (int i = 0; boxes.edge(i) <= texels + 1; ++i) {
        const double edge = boxes.edge(i);
        for (const double b : {std::floor(edge), std::floor(edge) + 1.0})
            if (b >= 0.0 && b <= texels)
                strengths[static_cast<size_t>(b)] = std::max(strengths[static_cast<size_t>(b)], 1.0 - std::abs(b - edge));
    }
    return strengths;
}

/// The four neighbors of a texel and the borders to them.
struct Step {
    int dx, dy;
};
constexpr std::array<Step, 4> steps{{{-1, 0}, {1, 0}, {0, -1}, {0, 1}}};

/// Exchange over the edges of boxes. Pairs over a disc's rim are left to exchangeOverRim(): there the neighbor of a neighbor need not
/// be the texel itself.
Image exchanged(const EnvironmentMap& map, const SolidAngles& solidAngles, const Boxes& boxes, const JobControl& job)
{
    const MapLayout& layout = map.layout;
    const int n = layout.size;
    const int chartWidth = layout.chartWidth();
    const bool disc = mapping(layout.kind).hasDiscs();
    const std::vector<double> across = edgeStrengths(boxes, chartWidth), down = edgeStrengths(boxes, n);
    Image result(map.image.width, map.image.height, 3);
    parallelRows(map.image.height, job, [&](int first, int last) {
        for (int y = first; y < last; ++y) {
            const int ly = y % n;
            for (int x = 0; x < map.image.width; ++x) {
                const float* own = map.image.texel(x, y);
                float* out = result.texel(x, y);
                const double w = solidAngles.at(x, y);
                if (w <= 0.0)
                    continue; // may hold anything
                const int lx = x % chartWidth;
                glm::dvec3 sum(own[0], own[1], own[2]);
                const glm::dvec3 center = sum;
                for (const Step& step : steps) {
                    const double strength = step.dy == 0 ? across[static_cast<size_t>(step.dx < 0 ? lx : lx + 1)]
                                                         : down[static_cast<size_t>(step.dy < 0 ? ly : ly + 1)];
                    if (strength <= 0.0)
                        continue;
                    Texel t{x + step.dx, y + step.dy};
                    if (lx + step.dx < 0 || lx + step.dx >= chartWidth || ly + step.dy < 0 || ly + step.dy >= n) {
                        if (disc)
                            continue;
                        t = acrossSeam(layout, {x, y}, t.x, t.y);
                    }
                    const double wt = solidAngles.at(t.x, t.y);
                    if (wt <= 0.0)
                        continue;
                    const float* other = map.image.texel(t.x, t.y);
                    sum += strength * 0.5 * wt / (w + wt) * (glm::dvec3(other[0], other[1], other[2]) - center);
                }
                for (int c = 0; c < 3; ++c)
                    out[c] = static_cast<float>(sum[c]);
            }
        }
    });
    return result;
}

/// Exchange between each texel at a disc's rim and the one that its step over the rim leads to. A texel can be met from several sides, so
/// the amounts are scaled down where they would add up to more than it has.
void exchangeOverRim(Image& image, const MapLayout& layout, const SolidAngles& solidAngles)
{
    struct Pair {
        Texel a, b;
        double amount;
    };
    std::vector<Pair> pairs;
    std::vector<double> load(static_cast<size_t>(image.width) * static_cast<size_t>(image.height), 0.0);
    const auto loadAt = [&](Texel t) -> double& {
        return load[static_cast<size_t>(t.y) * static_cast<size_t>(image.width) + static_cast<size_t>(t.x)];
    };
    const int n = layout.size;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            const double w = solidAngles.at(x, y);
            if (w <= 0.0)
                continue;
            for (const Step& step : steps) {
                const int lx = x % n + step.dx, ly = y + step.dy;
                if (lx >= 0 && lx < n && ly >= 0 && ly < n && solidAngles.at(lx, ly) > 0.0)
                    continue;
                const Texel t = acrossSeam(layout, {x, y}, x + step.dx, ly);
                const double wt = solidAngles.at(t.x, t.y);
                const double amount = 0.25 * w * wt / (w + wt); // half of a pair's: it is met again from the other side
                pairs.push_back({{x, y}, t, amount});
                loadAt({x, y}) += amount / w;
                loadAt(t) += amount / wt;
            }
        }
    }
    const Image before = image;
    for (const Pair& pair : pairs) {
        const double amount = pair.amount / std::max({1.0, loadAt(pair.a), loadAt(pair.b)});
        const double toA = amount / solidAngles.at(pair.a.x, pair.a.y), toB = amount / solidAngles.at(pair.b.x, pair.b.y);
        for (int c = 0; c < 3; ++c) {
            const double difference = static_cast<double>(before.texel(pair.b.x, pair.b.y)[c]) - before.texel(pair.a.x, pair.a.y)[c];
            image.texel(pair.a.x, pair.a.y)[c] += static_cast<float>(toA * difference);
            image.texel(pair.b.x, pair.b.y)[c] -= static_cast<float>(toB * difference);
        }
    }
}

/// The common case in one pass: boxes of 2 x 2 texels in charts without a rim. Twelve texels, the box and the eight beside it.
EnvironmentMap halvePairs(const EnvironmentMap& fine, const SolidAngles& solidAngles, const JobControl& job)
{
    struct Weighted {
        int dx, dy;         // from the box's upper left texel
        int fromDx, fromDy; // for the eight outer texels: the box's texel that they exchange with
    };
    constexpr std::array<Weighted, 4> own{{{0, 0, 0, 0}, {1, 0, 1, 0}, {0, 1, 0, 1}, {1, 1, 1, 1}}};
    constexpr std::array<Weighted, 8> outer{
        {{-1, 0, 0, 0}, {0, -1, 0, 0}, {2, 0, 1, 0}, {1, -1, 1, 0}, {-1, 1, 0, 1}, {0, 2, 0, 1}, {2, 1, 1, 1}, {1, 2, 1, 1}}};
    const MapLayout& layout = fine.layout;
    const int n = layout.size, chartWidth = layout.chartWidth();
    EnvironmentMap coarse(halved(layout));
    parallelRows(coarse.image.height, job, [&](int first, int last) {
        std::array<float, 12> weights{};
        for (int y = first; y < last; ++y)
            for (int x = 0; x < coarse.image.width; ++x) {
                const int fx = 2 * x, fy = 2 * y, lx = fx % chartWidth, ly = fy % n;
                const bool interior = lx > 0 && ly > 0 && lx + 2 < chartWidth && ly + 2 < n;
                std::array<const float*, 12> texels{};
                std::array<Texel, 8> outside{};
                for (size_t k = 0; k < 4; ++k)
                    texels[k] = fine.image.texel(fx + own[k].dx, fy + own[k].dy);
                for (size_t k = 0; k < 8; ++k) {
                    outside[k] = {fx + outer[k].dx, fy + outer[k].dy};
                    if (!interior)
                        outside[k] = acrossSeam(layout, {fx, fy}, outside[k].x, outside[k].y);
                    texels[4 + k] = fine.image.texel(outside[k].x, outside[k].y);
                }
                if (!mapping(layout.kind).rowsAreAlike || x == 0) { // else they are those of the box before
                    std::array<double, 4> w{}, kept{};
                    double total = 0.0;
                    for (size_t k = 0; k < 4; ++k)
                        total += kept[k] = w[k] = solidAngles.at(fx + own[k].dx, fy + own[k].dy);
                    for (size_t k = 0; k < 8; ++k) {
                        const size_t from = static_cast<size_t>(outer[k].fromDx + 2 * outer[k].fromDy);
                        const double wo = solidAngles.at(outside[k].x, outside[k].y);
                        const double amount = 0.5 * wo * w[from] / (wo + w[from]);
                        kept[from] -= amount;
                        weights[4 + k] = static_cast<float>(amount / total);
                    }
                    for (size_t k = 0; k < 4; ++k)
                        weights[k] = static_cast<float>(kept[k] / total);
                }
                float r = 0.0f, g = 0.0f, b = 0.0f;
                for (size_t k = 0; k < 12; ++k) {
                    r += weights[k] * texels[k][0];
                    g += weights[k] * texels[k][1];
                    b += weights[k] * texels[k][2];
                }
                float* out = coarse.image.texel(x, y);
                out[0] = r;
                out[1] = g;
                out[2] = b;
            }
    });
    return coarse;
}

EnvironmentMap halve(const EnvironmentMap& fine, const JobControl& job)
{
    EnvironmentMap coarse(halved(fine.layout));
    const Boxes boxes(fine.layout, coarse.layout);
    const SolidAngles solidAngles(fine.layout, job);
    if (boxes.isPairs() && !mapping(fine.layout.kind).hasDiscs())
        return halvePairs(fine, solidAngles, job);
    Image source = exchanged(fine, solidAngles, boxes, job);
    if (mapping(fine.layout.kind).hasDiscs())
        exchangeOverRim(source, fine.layout, solidAngles);

    const int n = fine.layout.size, half = coarse.layout.size;
    parallelRows(coarse.image.height, job, [&](int first, int last) {
        for (int y = first; y < last; ++y) {
            const int chartY = y / half * n;
            const double y0 = boxes.edge(y % half), y1 = boxes.edge(y % half + 1);
            for (int x = 0; x < coarse.image.width; ++x) {
                // The paraboloid's halves are two charts; a latlong's two squares are one and meet edge to edge.
                const int chartX = x / half * n;
                const double x0 = boxes.edge(x % half), x1 = boxes.edge(x % half + 1);
                glm::dvec3 sum(0.0);
                double total = 0.0;
                for (int fy = std::max(0, static_cast<int>(std::floor(y0))); fy < std::min<double>(n, y1); ++fy)
                    for (int fx = std::max(0, static_cast<int>(std::floor(x0))); fx < std::min<double>(n, x1); ++fx) {
                        double w;
                        if (boxes.isPairs())
                            w = solidAngles.at(fx, fy);
                        else
                            w = solidAngle(fine.layout, {chartX + std::max<double>(fx, x0), chartY + std::max<double>(fy, y0)},
                                           {chartX + std::min<double>(fx + 1, x1), chartY + std::min<double>(fy + 1, y1)});
                        if (w <= 0.0)
                            continue;
                        const float* t = source.texel(chartX + fx, chartY + fy);
                        sum += w * glm::dvec3(t[0], t[1], t[2]);
                        total += w;
                    }
                const glm::vec3 value = total > 0.0 ? glm::vec3(sum / total) : fine.radiance(texelDirection(coarse.layout, x, y));
                std::copy_n(&value.x, 3, coarse.image.texel(x, y));
            }
        }
    });
    return coarse;
}

} // namespace

int levelCount(const MapLayout& base) { return std::bit_width(static_cast<unsigned>(base.size)); }

MapLayout levelLayout(const MapLayout& base, int level)
{
    MapLayout layout = base;
    for (int i = 0; i < level; ++i)
        layout = halved(layout);
    return layout;
}

MipPyramid buildMipPyramid(const EnvironmentMap& map, const JobControl& job)
{
    validate(map.layout);
    const JobControl quiet{.stop = job.stop, .progress = {}, .threads = job.threads};
    MipPyramid pyramid;
    pyramid.levels.push_back(map);
    while (pyramid.levels.back().layout.size > 1) {
        pyramid.levels.push_back(halve(pyramid.levels.back(), quiet));
        if (job.progress) // a level costs a quarter of the one before
            job.progress(static_cast<float>(1.0 - std::pow(0.25, static_cast<double>(pyramid.levels.size() - 1))));
    }
    if (job.progress)
        job.progress(1.0f);
    return pyramid;
}

MipPyramid buildFacePyramid(const EnvironmentMap& cube, const JobControl& job)
{
    validate(cube.layout);
    if (cube.layout.kind != Parameterization::Cube)
        throw InvalidArgument("mip pyramid: only a cube has faces to filter by themselves; this is a " +
                              std::string(name(cube.layout.kind)) + " map");
    MipPyramid pyramid;
    pyramid.levels.push_back(cube);
    while (pyramid.levels.back().layout.size > 1) {
        job.checkStop();
        const EnvironmentMap& fine = pyramid.levels.back();
        EnvironmentMap coarse(halved(fine.layout));
        const int n = fine.layout.size, half = coarse.layout.size;
        for (int y = 0; y < coarse.image.height; ++y) {
            const int fineY = y / half * n + 2 * (y % half);
            for (int x = 0; x < half; ++x)
                for (int c = 0; c < 3; ++c)
                    coarse.image.texel(x, y)[c] =
                        0.25f * (fine.image.texel(2 * x, fineY)[c] + fine.image.texel(2 * x + 1, fineY)[c] +
                                 fine.image.texel(2 * x, fineY + 1)[c] + fine.image.texel(2 * x + 1, fineY + 1)[c]);
        }
        pyramid.levels.push_back(std::move(coarse));
    }
    return pyramid;
}

glm::vec3 radiance(const MipPyramid& pyramid, const glm::dvec3& d, double level)
{
    const double last = static_cast<double>(pyramid.levels.size() - 1);
    const double clamped = std::clamp(level, 0.0, last);
    const size_t fine = static_cast<size_t>(clamped);
    const float fraction = static_cast<float>(clamped - static_cast<double>(fine));
    const glm::vec3 a = pyramid.levels[fine].radiance(d);
    return fraction > 0.0f ? glm::mix(a, pyramid.levels[fine + 1].radiance(d), fraction) : a;
}

} // namespace mirrorball
