#pragma once

#include "core/spheremap/document/layer.h"
#include "core/spheremap/math/level.h"
#include "core/spheremap/math/span.h"
#include "core/spheremap/math/texel_rect.h"

#include "core/base/job.h"

#include <algorithm>

/// Layers laid over each other, a run of texels at a time. Colors of a run that has been composited are multiplied by their opacity.
namespace mirrorball::compositing {

/// One visible layer, made ready.
struct Step {
    const Layer* layer = nullptr;
    SpanGenerator generate{};
    SpanAdjustment adjust{}; ///< in place of `generate`
    SpanGenerator mask{};    ///< empty: the layer shows everywhere
};

/// Lays a layer over `result`, or adjusts it.
void run(const Step& step, const DiscSpan& at, ColorSpan& result);
/// Lays what a step without `adjust` made of the whole picture over that picture. @param moved  of the new picture; not needed afterwards
void runMoved(const Step& step, const DiscSpan& at, ColorSpan& moved, ColorSpan& backdrop);

/// RGBA texels to a run and back, as they are.
void read(const float* __restrict texels, int count, ColorSpan& __restrict colors);
void write(const ColorSpan& __restrict colors, int count, float* __restrict texels);
/// No light, and nothing there.
void clear(ColorSpan& colors, int count);
/// Keeps colors that are multiplied by their opacity within what layers may give.
void boundMultiplied(int count, ColorSpan& colors);

/// Where the texels of a run lie; `row`, `column` and `count` are given.
void setPositions(DiscSpan& at, const Level& level);

/// Calls body(span) for the runs of a rectangle's rows, in parallel.
template <typename Body>
void forEachRun(const TexelRect& rect, const Level& level, const JobControl& job, const Body& body)
{
    parallelRows(rect.height(), job, [&](int first, int last) {
        DiscSpan at;
        for (at.row = rect.y0 + first; at.row < rect.y0 + last; ++at.row)
            for (at.column = rect.x0; at.column < rect.x1; at.column += spanLength) {
                at.count = std::min(spanLength, rect.x1 - at.column);
                setPositions(at, level);
                body(at);
            }
    });
}

} // namespace mirrorball::compositing
