#include "stroke_raster.h"

#include "core/spheremap/math/vector_clones.h"

#include "core/sphere/disc.h"
#include "core/sphere/parameterization.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

namespace mirrorball {

namespace {

constexpr int tileSize = TileSet::tileSize;

using Lanes __attribute__((vector_size(32))) = float;
using Texel4 __attribute__((vector_size(16))) = float;
constexpr int laneCount = 8;

/// What shines through a stroke on one tile.
struct Transmittance {
    alignas(32) std::array<float, static_cast<size_t>(tileSize) * tileSize> values;
    TexelRect touched{}; ///< within the tile
};

/// 1 - t is exactly 1 from here on, and products never become so small that the processor slows down.
constexpr float opaque = 1e-10f;

/// Lets a dab take its part of what shines through. Works on whole lanes, written out because the compiler makes branches of the clamps
/// otherwise: beyond the dab's edge p is 0 and nothing changes.
///
/// With l the lean, d^2 - (d . l)^2 = (1 - lx^2) (dx - k dy)^2 + (1 - ly^2 / (1 - lx^2)) dy^2 and k = lx ly / (1 - lx^2): a stretched tip
/// is a round one whose rows are moved and scaled.
MIRRORBALL_VECTOR_CLONES void stampRows(float* values, const TexelRect& rows, float cx, float cy, DabProfile dab, glm::vec2 lean)
{
    const float along = 1.0f - lean.x * lean.x;
    const float down = 1.0f - lean.y * lean.y / along;
    const float shift = lean.x * lean.y / along;
    const float slope = dab.slope * along;
    const Lanes steps = {0, 1, 2, 3, 4, 5, 6, 7};
    const Lanes none = {}, one = none + 1.0f, least = none + opaque;
    const int first = rows.x0 & ~(laneCount - 1);
    for (int y = rows.y0; y < rows.y1; ++y) {
        const float dy = static_cast<float>(y) - cy;
        const float base = (dab.outer2 - dy * dy * down) * dab.slope;
        const float middle = cx + shift * dy;
        float* row = values + y * tileSize;
        for (int x = first; x < rows.x1; x += laneCount) {
            const Lanes dx = steps + (static_cast<float>(x) - middle);
            Lanes u = base - dx * dx * slope;
            u = u > none ? u : none;
            u = u < one ? u : one;
            Lanes t;
            std::memcpy(&t, row + x, sizeof t);
            t = t * (1.0f - dab.strength * (u * u * (3.0f - 2.0f * u)));
            t = t > least ? t : least;
            std::memcpy(row + x, &t, sizeof t);
        }
    }
}

void composeRow(float* texels, const float* through, int count, float opacity, const glm::vec4& color)
{
    const Texel4 paint = {color.r, color.g, color.b, color.a};
    for (int x = 0; x < count; ++x) {
        const float cover = opacity * (1.0f - through[x]);
        Texel4 texel;
        std::memcpy(&texel, texels + 4 * x, sizeof texel);
        texel = texel * (1.0f - cover) + paint * cover;
        std::memcpy(texels + 4 * x, &texel, sizeof texel);
    }
}

/// Calls `visit(dab index)` for the dabs whose bounds meet the tile, in order.
template <typename Visit>
void forDabsIn(const TexelStroke& stroke, const TexelRect& tile, const Visit& visit)
{
    if (stroke.bounds.intersected(tile).empty())
        return;
    for (size_t g = 0; g < stroke.groups.size(); ++g) {
        if (stroke.groups[g].intersected(tile).empty())
            continue;
        const size_t end = std::min((g + 1) * TexelStroke::groupSize, stroke.dabs.size());
        for (size_t i = g * TexelStroke::groupSize; i < end; ++i)
            if (!stroke.dabs[i].bounds().intersected(tile).empty())
                visit(i);
    }
}

/// @param texels  of the tile, rows `stride` texels apart
void coverTile(float* texels, size_t stride, const TexelStroke& stroke, const TexelRect& tile, Transmittance& through)
{
    through.touched = {};
    forDabsIn(stroke, tile, [&](size_t i) {
        const TexelDab& dab = stroke.dabs[i];
        if (through.touched.empty())
            through.values.fill(1.0f);
        TexelRect rows = dab.bounds().intersected(tile);
        rows = {rows.x0 - tile.x0, rows.y0 - tile.y0, rows.x1 - tile.x0, rows.y1 - tile.y0};
        through.touched = through.touched.united(rows);
        stampRows(through.values.data(), rows, static_cast<float>(dab.p.x - 0.5 - tile.x0), static_cast<float>(dab.p.y - 0.5 - tile.y0),
                  dab.profile, dab.lean);
    });
    const TexelRect& t = through.touched;
    const glm::vec4 paint = stroke.mode == BrushMode::Paint ? glm::vec4(stroke.color, 1.0f) : glm::vec4(0.0f);
    for (int y = t.y0; y < t.y1; ++y)
        composeRow(texels + 4 * (static_cast<size_t>(y) * stride + static_cast<size_t>(t.x0)), through.values.data() + y * tileSize + t.x0,
                   t.width(), stroke.opacity, paint);
}

/// A copy of the part of a raster that a smudge reads.
struct Patch {
    TexelRect rect{};
    Image image{};

    Patch(const Image& raster, const TexelRect& r) : rect(r), image(r.width(), r.height(), 4)
    {
        for (int y = rect.y0; y < rect.y1; ++y)
            std::copy_n(raster.texel(rect.x0, y), static_cast<size_t>(rect.width()) * 4, image.row(y - rect.y0));
    }
    const float* texel(int x, int y) const { return image.texel(x - rect.x0, y - rect.y0); }
    /// Bilinear; past the patch's edge its last texels go on.
    glm::vec4 at(const glm::dvec2& p) const
    {
        const double x = std::clamp(p.x - 0.5, static_cast<double>(rect.x0), rect.x1 - 1.0);
        const double y = std::clamp(p.y - 0.5, static_cast<double>(rect.y0), rect.y1 - 1.0);
        const int x0 = static_cast<int>(x), y0 = static_cast<int>(y);
        const int x1 = std::min(x0 + 1, rect.x1 - 1), y1 = std::min(y0 + 1, rect.y1 - 1);
        const float fx = static_cast<float>(x - x0), fy = static_cast<float>(y - y0);
        glm::vec4 sum;
        for (int c = 0; c < 4; ++c) {
            const float top = texel(x0, y0)[c] * (1.0f - fx) + texel(x1, y0)[c] * fx;
            const float low = texel(x0, y1)[c] * (1.0f - fx) + texel(x1, y1)[c] * fx;
            sum[c] = top * (1.0f - fy) + low * fy;
        }
        return sum;
    }
};

/// Where what the stroke pushes to p came from; the dabs of touches from `touches` on do not reach it.
glm::dvec2 cameFrom(const TexelStroke& stroke, glm::dvec2 p, size_t touches)
{
    const size_t all = stroke.touches();
    for (size_t i = touches; i-- > 0;) {
        glm::dvec2 motion(0.0);
        for (size_t copy = 0; copy < stroke.copies; ++copy) {
            const TexelDab& dab = stroke.dabs[copy * all + i];
            const glm::dvec2 d = p - dab.p;
            const double along = glm::dot(d, glm::dvec2(dab.lean));
            const float d2 = static_cast<float>(d.x * d.x + d.y * d.y - along * along);
            if (d2 < dab.profile.outer2)
                motion += dab.motion * static_cast<double>(dab.profile.at(d2));
        }
        p -= motion;
    }
    return p;
}

void smudgeTile(Image& raster, const TexelStroke& stroke, const TexelRect& tile, const Patch& before)
{
    size_t touches = 0;
    TexelRect touched;
    forDabsIn(stroke, tile, [&](size_t i) {
        touches = std::max(touches, i % stroke.touches() + 1);
        touched = touched.united(stroke.dabs[i].bounds().intersected(tile));
    });
    for (int y = touched.y0; y < touched.y1; ++y) {
        for (int x = touched.x0; x < touched.x1; ++x) {
            const glm::dvec2 p{x + 0.5, y + 0.5};
            const glm::dvec2 from = cameFrom(stroke, p, touches);
            if (from == p)
                continue;
            const glm::vec4 carried = before.at(from);
            float* texel = raster.texel(x, y);
            for (int c = 0; c < 4; ++c)
                texel[c] = texel[c] * (1.0f - stroke.opacity) + carried[c] * stroke.opacity;
        }
    }
}

/// Half the sides of the box about d^2 - (d . lean)^2 = outer^2: the ellipse's matrix inverted is 1 + lean lean^T / (1 - |lean|^2).
glm::vec2 reachOf(const DabProfile& profile, const glm::vec2& lean)
{
    return std::sqrt(profile.outer2) * glm::sqrt(1.0f + lean * lean / (1.0f - glm::dot(lean, lean)));
}

} // namespace

TexelRect TexelDab::bounds() const
{
    return {static_cast<int>(std::ceil(p.x - reach.x - 0.5)), static_cast<int>(std::ceil(p.y - reach.y - 0.5)),
            static_cast<int>(std::floor(p.x + reach.x - 0.5)) + 1, static_cast<int>(std::floor(p.y + reach.y - 0.5)) + 1};
}

TileSet TexelStroke::tiles(int size, size_t first) const
{
    TileSet set(size);
    const size_t all = touches();
    for (size_t copy = 0; copy < copies; ++copy)
        for (size_t i = first; i < all; ++i)
            set.add(dabs[copy * all + i].bounds());
    return set;
}

TexelStroke texelStroke(const Stroke& stroke, int size)
{
    const disc::Disc disc = disc::inscribed(size);
    const StrokeDabs source = strokeDabs(stroke);
    TexelStroke result{.mode = stroke.brush.mode,
                       .color = glm::vec3(stroke.brush.color),
                       .opacity = static_cast<float>(stroke.brush.opacity),
                       .copies = source.copies};
    result.dabs.reserve(source.dabs.size());
    for (const Dab& dab : source.dabs) {
        const DabProfile profile = dabProfile(dab.radius * disc.radius, stroke.brush.hardness, dab.strength);
        const glm::vec2 lean(dab.lean.x, -dab.lean.y);
        result.dabs.push_back(
            {disc.toImage(dab.q), glm::dvec2(dab.motion.x, -dab.motion.y) * disc.radius, profile, lean, reachOf(profile, lean)});
        if ((result.dabs.size() - 1) % TexelStroke::groupSize == 0)
            result.groups.emplace_back();
        const TexelRect bounds = result.dabs.back().bounds();
        result.groups.back() = result.groups.back().united(bounds);
        result.bounds = result.bounds.united(bounds);
    }
    return result;
}

void paintTile(std::span<const TexelStroke> strokes, const TexelRect& tile, float* texels, size_t stride, const JobControl& job)
{
    Transmittance through;
    for (size_t s = 0; s < strokes.size(); ++s) {
        if (s % 64 == 0)
            job.checkStop();
        coverTile(texels, stride, strokes[s], tile, through);
    }
}

void paintTiles(Image& raster, std::span<const TexelStroke> strokes, const TileSet& tiles, const JobControl& job)
{
    const std::vector<int> list = tiles.list();
    const TexelRect map{0, 0, raster.width, raster.height};
    for (size_t first = 0; first < strokes.size();) {
        if (strokes[first].mode == BrushMode::Smudge) {
            const TexelStroke& stroke = strokes[first++];
            const TexelRect reads = stroke.bounds.intersected(map).grown(1, raster.width);
            if (reads.empty() || !tiles.meets(stroke.tiles(raster.width)))
                continue;
            const Patch before(raster, reads);
            parallelRows(
                static_cast<int>(list.size()), job,
                [&](int a, int b) {
                    for (int i = a; i < b; ++i)
                        smudgeTile(raster, stroke, tiles.rect(list[static_cast<size_t>(i)]), before);
                },
                1);
            continue;
        }
        size_t end = first;
        while (end < strokes.size() && strokes[end].mode != BrushMode::Smudge)
            ++end;
        parallelRows(
            static_cast<int>(list.size()), job,
            [&](int a, int b) {
                for (int i = a; i < b; ++i) {
                    const TexelRect tile = tiles.rect(list[static_cast<size_t>(i)]);
                    paintTile(strokes.subspan(first, end - first), tile, raster.texel(tile.x0, tile.y0), static_cast<size_t>(raster.width),
                              job);
                }
            },
            1);
        first = end;
    }
}

TileSet closeForSmudging(TileSet tiles, std::span<const TexelStroke> strokes, int size)
{
    // A tile that is added for one smudge is painted by the others too, so go on until nothing is missing.
    for (bool grew = true; grew;) {
        grew = false;
        for (const TexelStroke& stroke : strokes) {
            if (stroke.mode != BrushMode::Smudge || !stroke.tiles(size).meets(tiles))
                continue;
            TileSet reads(size);
            reads.add(stroke.bounds.intersected({0, 0, size, size}).grown(1, size));
            grew = grew || !tiles.containsAll(reads);
            tiles.add(reads);
        }
    }
    return tiles;
}

Image paintStrokes(std::span<const Stroke> strokes, int size, const JobControl& job)
{
    return paintStrokes(strokes, size, {0, 0, size, size}, job);
}

Image paintStrokes(std::span<const Stroke> strokes, int size, const TexelRect& rect, const JobControl& job)
{
    validate(MapLayout{Parameterization::Sphere, size, 0});
    validate(strokes);
    TileSet tiles(size);
    tiles.add(rect);
    std::vector<TexelStroke> texelStrokes;
    texelStrokes.reserve(strokes.size());
    for (const Stroke& stroke : strokes)
        texelStrokes.push_back(texelStroke(stroke, size));
    Image raster(size, size, 4);
    paintTiles(raster, texelStrokes, closeForSmudging(tiles, texelStrokes, size), job);
    if (rect == TexelRect{0, 0, size, size})
        return raster;
    Image part(std::max(rect.width(), 0), std::max(rect.height(), 0), 4);
    for (int y = 0; y < part.height; ++y)
        std::copy_n(raster.texel(rect.x0, rect.y0 + y), static_cast<size_t>(part.width) * 4, part.row(y));
    return part;
}

} // namespace mirrorball
