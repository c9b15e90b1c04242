#include "stage_cost.h"

#include "core/spheremap/evaluation/evaluate.h"

#include <algorithm>

namespace mirrorball {

namespace {

double texels(const MapLayout& layout) { return static_cast<double>(layout.width()) * layout.height(); }

constexpr int bytesATexel = 12; // three floats

StageCost mapCost(const MapLayout& layout, double secondsATexel)
{
    return {secondsATexel * texels(layout), static_cast<std::int64_t>(bytesATexel * texels(layout))};
}

} // namespace

StageCost readingCost(const MapLayout& probe, bool isBuiltin, bool isStreamed)
{
    StageCost cost = mapCost(probe, isBuiltin ? 2e-7 : 4e-8);
    if (isStreamed)
        cost.bytes = 0;
    return cost;
}

StageCost resamplingCost(const MapLayout& target) { return mapCost(target, 1.5e-7); }

StageCost pyramidCost(const MapLayout& base)
{
    const StageCost whole = mapCost(base, 2e-8);
    return {whole.seconds, whole.bytes / 3};
}

StageCost paintingCost(int size, size_t layers, bool isAuthored)
{
    const StageCost layer = mapCost({Parameterization::Sphere, size, 0}, 1.5e-8);
    return {static_cast<double>(std::max<size_t>(layers, 1)) * layer.seconds *
                (isAuthored ? 1.0 + levelOversampling * levelOversampling / 3.0 : 1.0),
            layer.bytes};
}

StageCost savingCost(const MapLayout& map) { return {3e-8 * texels(map), 0}; }

// Of the renderer without a GPU; its shaders take a fifth of a second to compile.
StageCost drawingCost(int width, int height)
{
    const double pixels = static_cast<double>(width) * height;
    return {0.2 + 5e-8 * pixels, static_cast<std::int64_t>(64.0 * pixels)};
}

} // namespace mirrorball
