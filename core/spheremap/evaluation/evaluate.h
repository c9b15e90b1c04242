#pragma once

#include "core/spheremap/document/assets.h"
#include "core/spheremap/document/sphere_map_document.h"
#include "core/spheremap/math/texel_rect.h"

#include "core/base/job.h"
#include "core/image/image.h"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

/// From a document to texels.
namespace mirrorball {

inline constexpr int largestSphereMap = 8192;

/// What becomes of visible layers of a kind that this version does not know.
enum class UnknownLayers { Refuse, Skip };

/// What of a layer is painted.
enum class PaintTarget { Layer, Mask };

struct EvaluateOptions {
    int size = 512;                    ///< texels along an edge, [1, 8192]
    int level = 0;                     ///< of a chain, [0, 16]: decides which layers take part
    int levelSize = 0;                 ///< edge of the texels that a width in pixels means, where not `size`; 0: `size`; at most 8192
    std::optional<TexelRect> region{}; ///< what to evaluate; empty: the whole map
    UnknownLayers unknownLayers = UnknownLayers::Refuse;
    std::shared_ptr<SphereMapAssets> assets{}; ///< null: files are read again
    /// The strokes of a layer or of its mask by the layer's index, where they are at hand already (a StrokeCanvas): size x size, RGBA,
    /// multiplied by opacity. Null: they are evaluated.
    std::function<const Image*(size_t layer, PaintTarget)> raster{};
    /// The same of any layer that makes colors, as drawnLayer() gave them.
    std::function<const Image*(size_t layer, PaintTarget)> drawn{};
    size_t firstLayer = 0;        ///< those below it are in `below`
    size_t endLayer = SIZE_MAX;   ///< this one and those above are left out
    const Image* below = nullptr; ///< the whole map with the layers below firstLayer, as evaluate() gave it; null: nothing
};

/// The picture of a document: RGBA, linear Rec.709, colors multiplied by their opacity. The disc is inscribed in the square as in
/// sphere/sphere_map.h; outside it the color of the nearest point of the rim goes on.
///
/// The same bytes on any number of threads, and for any region: a region is a cut from the whole.
/// @return size x size, or the region alone
/// @throws InvalidArgument naming the field; FileError for an asset that is missing or damaged; Cancelled
Image evaluate(const SphereMapDocument& document, const EvaluateOptions& options, const JobControl& job = {});

/// What one layer that makes colors gives by itself, or its mask's picture: size x size, RGBA, colors *not* multiplied by their opacity,
/// neither the layer's opacity nor its mask applied. Kept, it spares making them while something else changes (EvaluateOptions::drawn).
/// @throws as evaluate(); InvalidArgument for a layer, or a mask, that makes none
Image drawnLayer(const SphereMapDocument& document, size_t layer, PaintTarget target, const EvaluateOptions& options,
                 const JobControl& job = {});

/// The part of the map that may change when layer `layer` changes in `touched`: wider where a blur lies above, everything above a twist.
/// So a stroke is shown by evaluate() over touchedBy() of its bounds.
TexelRect touchedBy(const SphereMapDocument& document, size_t layer, const TexelRect& touched, const EvaluateOptions& options);

/// The mip chain, largest first, each level half of the one before rounded down, to 1 x 1. Where a layer is made for the levels
/// (hasAuthoredLevels()), each level is evaluated by itself, finer by the factor levelOversampling and averaged; otherwise it is
/// plainChain().
/// @throws as evaluate()
std::vector<Image> evaluateLevels(const SphereMapDocument& document, int size, const JobControl& job = {});
/// The same with options; `region`, `level` and `levelSize` are not used.
std::vector<Image> evaluateLevels(const SphereMapDocument& document, const EvaluateOptions& options, const JobControl& job = {});
/// The same where the largest level is at hand: @param base evaluate() of the document with these options, or a SphereMapCache's image
std::vector<Image> levelsFrom(Image base, const SphereMapDocument& document, const EvaluateOptions& options, const JobControl& job = {});

inline constexpr int levelOversampling = 2; ///< of levels above 64 texels; smaller ones are made from 128
/// By how much finer a hand-made level of an edge of `size` texels is evaluated.
inline int oversamplingOfLevel(int size) { return std::max(levelOversampling, 128 / size); }
/// The texels `rect` of a picture averaged by blocks of factor x factor, of which it holds whole ones.
Image blockAverages(const Image& picture, const TexelRect& rect, int factor, const JobControl& job = {});

/// A picture and its halvings by averaging, to 1 x 1: the chain that hardware makes.
std::vector<Image> plainChain(Image picture, const JobControl& job = {});

} // namespace mirrorball
