#pragma once

#include "stroke.h"
#include "tile_set.h"

#include "core/base/job.h"
#include "core/image/image.h"

#include <span>
#include <vector>

/// Strokes as texels: an RGBA raster, linear, premultiplied, transparent where nothing was painted. The disc is inscribed in the square as
/// in sphere_map.h; what is painted outside it is kept, for the map to bleed.
///
/// Paint   L' = (1 - c) L + c (color, 1)      with c the stroke's cover, brush.h
/// Erase   L' = (1 - c) L
/// Smudge  L'(q) = (1 - o) L(q) + o L(q_0),   o the opacity and q_0 found from the last dab to the first:
///         q <- q - sum over copies of a p(|q - q_i|) m_i,   m_i the dab's motion
/// Smudging by dabs mixes, at each, L(q) and L(q - m) in the parts 1 - a p and a p; for short motions that is L(q - a p m), and the dabs
/// in a row make a warp of the plane. As a warp it is the same at every size, where repeated mixing of texels would blur more on a
/// coarse grid than on a fine one.
namespace mirrorball {

/// A dab on a grid of texels.
struct TexelDab {
    glm::dvec2 p{0.0};      ///< image position
    glm::dvec2 motion{0.0}; ///< in texels, y down
    DabProfile profile{};
    glm::vec2 lean{0.0f};  ///< as in Dab, y down
    glm::vec2 reach{0.0f}; ///< texels: nothing happens farther from p along x or along y

    TexelRect bounds() const;
};

/// A stroke at a size of the map, with what finds its dabs quickly.
struct TexelStroke {
    BrushMode mode = BrushMode::Paint;
    glm::vec3 color{0.0f};
    float opacity = 1.0f;
    size_t copies = 1;
    std::vector<TexelDab> dabs{};    ///< as in StrokeDabs
    std::vector<TexelRect> groups{}; ///< bounds of each `groupSize` dabs in a row
    TexelRect bounds{};

    static constexpr size_t groupSize = 16;
    size_t touches() const { return dabs.size() / copies; }
    /// Tiles that the dabs from touch `first` on meet.
    TileSet tiles(int size, size_t first = 0) const;
};

/// @param size  edge of the map in texels
TexelStroke texelStroke(const Stroke& stroke, int size);

/// Paints strokes that do not smudge, in order, on one tile.
/// @param texels  of the tile, four channels, rows `stride` texels apart
void paintTile(std::span<const TexelStroke> strokes, const TexelRect& tile, float* texels, size_t stride, const JobControl& job = {});

/// Paints strokes, in order, on the given tiles of a raster. For a smudge to be right every tile that it reads must be in the set:
/// closeForSmudging() adds them.
/// @param raster  square, four channels
void paintTiles(Image& raster, std::span<const TexelStroke> strokes, const TileSet& tiles, const JobControl& job = {});

/// `tiles` and all that must be painted beside them, because a smudge carries color from there.
TileSet closeForSmudging(TileSet tiles, std::span<const TexelStroke> strokes, int size);

/// All strokes on an empty raster of size x size. The same bytes on any number of threads.
/// @throws InvalidArgument as validate() does, or naming the size; Cancelled
Image paintStrokes(std::span<const Stroke> strokes, int size, const JobControl& job = {});
/// The texels `rect` of it; costs the tiles that the rectangle meets. The same bytes as the part of the whole.
Image paintStrokes(std::span<const Stroke> strokes, int size, const TexelRect& rect, const JobControl& job = {});

} // namespace mirrorball
