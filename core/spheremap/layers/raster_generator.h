#pragma once

#include "core/spheremap/math/span.h"
#include "core/spheremap/math/texel_rect.h"
#include "core/spheremap/strokes/stroke_tiles.h"

#include "core/image/image.h"

#include <memory>

/// Texels that are there already as generators. Outside the disc the rim goes on, read a little inside it so that nothing is mixed in that
/// was painted outside.
namespace mirrorball {

/// @param picture  RGBA over the texels `rect` of a map of `size`, multiplied by its opacity
SpanGenerator rasterGenerator(std::shared_ptr<const Image> picture, const TexelRect& rect, int size);
SpanGenerator rasterGenerator(std::shared_ptr<const StrokeTiles> tiles);

} // namespace mirrorball
