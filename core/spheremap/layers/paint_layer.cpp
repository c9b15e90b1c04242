#include "paint_layer.h"

#include "core/spheremap/strokes/stroke_raster.h"

#include <algorithm>

namespace mirrorball {

bool sameButStrokes(const PaintLayer& a, const PaintLayer& b) { return a.unit == b.unit && a.reference == b.reference; }

std::vector<Stroke> strokesAt(const PaintLayer& layer, const Level& level)
{
    std::vector<Stroke> strokes = layer.strokes;
    if (layer.unit == WidthUnit::Pixels)
        for (Stroke& stroke : strokes)
            stroke.brush.radius = std::clamp(stroke.brush.radius * layer.reference / level.levelSize, smallestRadius, largestRadius);
    return strokes;
}

Image paintedRaster(const PaintLayer& layer, const Level& level, const TexelRect& rect, const JobControl& job)
{
    return layer.unit == WidthUnit::Pixels ? paintStrokes(strokesAt(layer, level), level.size, rect, job)
                                           : paintStrokes(layer.strokes, level.size, rect, job);
}

} // namespace mirrorball
