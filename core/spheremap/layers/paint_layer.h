#pragma once

#include "core/spheremap/document/layer_kind.h"
#include "core/spheremap/math/level.h"
#include "core/spheremap/math/texel_rect.h"
#include "core/spheremap/strokes/stroke.h"

#include "core/base/job.h"
#include "core/image/image.h"

#include <vector>

namespace mirrorball {

/// What an artist painted: strokes, which keep their look at every size (stroke_raster.h). With widths in pixels the tips are as many
/// pixels wide on every level as they are on one of `reference` texels, so that painted lines keep their width on the screen. Source: 000
/// section 4.
struct PaintLayer {
    static constexpr LayerKind kind{"paint", "Paint", "strokes of a brush"};
    WidthUnit unit = WidthUnit::Disc;
    int reference = 512;
    std::vector<Stroke> strokes{};
    UnknownKeys unknown{};

    bool operator==(const PaintLayer&) const = default;
    template <typename Self, typename Visit>
    static void visitFields(Self& self, Visit&& visit)
    {
        visit(Field{"unit", "disc: tips are part of the picture; pixels: as many pixels wide on every level"}, self.unit);
        visit(Field{"reference", "pixels: edge of the level on which the tips are as wide as they were drawn", 1, 8192, "texels"},
              self.reference);
        visit(Field{"strokes", "in the order in which they were drawn", 0, mostStrokes}, self.strokes);
    }
};

/// Whether two layers would paint the same strokes alike.
bool sameButStrokes(const PaintLayer& a, const PaintLayer& b);

/// The strokes as they are drawn on a level: with widths in pixels the radii are scaled.
std::vector<Stroke> strokesAt(const PaintLayer& layer, const Level& level);

/// The texels `rect` of the layer on a level: RGBA, colors multiplied by their opacity. @throws InvalidArgument; Cancelled
Image paintedRaster(const PaintLayer& layer, const Level& level, const TexelRect& rect, const JobControl& job);

} // namespace mirrorball
