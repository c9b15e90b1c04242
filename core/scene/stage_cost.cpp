#include "stage_cost.h"

#include "core/image/image_format.h"
#include "core/image/openimageio_library.h"
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

// Every texel of both maps is met once.
StageCost resamplingCost(const MapLayout& probe, const MapLayout& target)
{
    StageCost cost = mapCost(target, 4e-8);
    cost.seconds += 3e-8 * texels(probe);
    return cost;
}

StageCost pyramidCost(const MapLayout& base)
{
    const StageCost whole = mapCost(base, 9e-8);
    return {whole.seconds, whole.bytes / 3};
}

StageCost paintingCost(int size, size_t layers, bool isAuthored)
{
    const StageCost layer = mapCost({Parameterization::Sphere, size, 0}, 3.5e-8);
    return {static_cast<double>(std::max<size_t>(layers, 1)) * layer.seconds *
                (isAuthored ? 1.0 + levelOversampling * levelOversampling / 3.0 : 1.0),
            layer.bytes};
}

StageCost savingCost(const std::filesystem::path& file, std::span<const MapLayout> levels)
{
    constexpr double perFile = 1e-3;
    const ImageFormat* format = findFormat(file);
    const double texel = format ? format->writingSeconds : ImageFormat{}.writingSeconds;
    double sum = perFile;
    for (const MapLayout& level : levels)
        sum += texel * texels(level);
    return {sum, 0};
}

double loadingSeconds(const std::filesystem::path& file)
{
    const ImageFormat* format = findFormat(file);
    return format && format->needsOpenImageIo ? openimageio::loadingSeconds() : 0.0;
}

// Of the renderer without a GPU; its shaders take a fifth of a second to compile.
StageCost drawingCost(int width, int height)
{
    const double pixels = static_cast<double>(width) * height;
    return {0.2 + 5e-8 * pixels, static_cast<std::int64_t>(64.0 * pixels)};
}

// Narrow lobes have more texels, and more orders; sizes end where those of view_stack.cpp do.
StageCost viewStackCost(double alpha)
{
    const double layers = std::clamp(60.0 / std::sqrt(alpha), 100.0, 800.0), width = std::clamp(60.0 / alpha, 128.0, 1024.0);
    const double count = layers * width * width / 2.0;
    return {0.3 + 6e-8 * count, static_cast<std::int64_t>(bytesATexel * count)};
}

} // namespace mirrorball
