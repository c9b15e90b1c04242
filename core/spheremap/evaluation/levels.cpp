#include "evaluate.h"

#include "core/spheremap/math/resample.h"

#include <algorithm>

namespace mirrorball {

namespace {

/// The average over factor x factor texels; rows and columns beyond the last whole block are left out only where a size is odd, and then
/// spread over all.
Image averaged(const Image& picture, int size, const JobControl& job)
{
    const int whole = picture.width / size;
    if (whole * size == picture.width)
        return blockAverages(picture, {0, 0, picture.width, picture.height}, whole, job);
    Image result(size, size, 4);
    // An odd size halved and rounded down: each texel averages a window a little over two texels wide.
    const double scale = static_cast<double>(picture.width) / size;
    parallelRows(size, job, [&](int first, int last) {
        for (int y = first; y < last; ++y)
            for (int x = 0; x < size; ++x) {
                double sum[4] = {};
                for (int sy = static_cast<int>(y * scale); sy < picture.height && sy < (y + 1) * scale; ++sy)
                    for (int sx = static_cast<int>(x * scale); sx < picture.width && sx < (x + 1) * scale; ++sx) {
                        const double cover = (std::min(sy + 1.0, (y + 1) * scale) - std::max<double>(sy, y * scale)) *
                                             (std::min(sx + 1.0, (x + 1) * scale) - std::max<double>(sx, x * scale));
                        for (int c = 0; c < 4; ++c)
                            sum[c] += cover * static_cast<double>(picture.texel(sx, sy)[c]);
                    }
                for (int c = 0; c < 4; ++c)
                    result.texel(x, y)[c] = static_cast<float>(sum[c] / (scale * scale));
            }
    });
    return result;
}

} // namespace

Image blockAverages(const Image& picture, const TexelRect& rect, int factor, const JobControl& job)
{
    Image result(rect.width() / factor, rect.height() / factor, 4);
    const float share = 1.0f / static_cast<float>(factor * factor);
    parallelRows(result.height, job, [&](int first, int last) {
        for (int y = first; y < last; ++y)
            for (int x = 0; x < result.width; ++x) {
                FourChannels sum{};
                for (int j = 0; j < factor; ++j) {
                    const auto* texel =
                        reinterpret_cast<const FourChannels*>(picture.texel(rect.x0 + x * factor, rect.y0 + y * factor + j));
                    for (int i = 0; i < factor; ++i)
                        sum += texel[i];
                }
                *reinterpret_cast<FourChannels*>(result.texel(x, y)) = sum * share;
            }
    });
    return result;
}

std::vector<Image> plainChain(Image picture, const JobControl& job)
{
    std::vector<Image> levels;
    levels.push_back(std::move(picture));
    while (levels.back().width > 1)
        levels.push_back(averaged(levels.back(), levels.back().width / 2, job));
    return levels;
}

std::vector<Image> evaluateLevels(const SphereMapDocument& document, const EvaluateOptions& options, const JobControl& job)
{
    EvaluateOptions one = options;
    if (!one.assets)
        one.assets = std::make_shared<SphereMapAssets>();
    one.region.reset();
    one.level = 0;
    one.levelSize = 0;
    return levelsFrom(evaluate(document, one, job), document, one, job);
}

std::vector<Image> levelsFrom(Image base, const SphereMapDocument& document, const EvaluateOptions& options, const JobControl& job)
{
    if (!hasAuthoredLevels(document))
        return plainChain(std::move(base), job);
    std::vector<Image> levels;
    levels.push_back(std::move(base));
    EvaluateOptions one = options;
    if (!one.assets)
        one.assets = std::make_shared<SphereMapAssets>();
    one.region.reset();
    one.level = 0;
    one.raster = {}; // those at hand are of the largest size
    for (int size = options.size / 2; size >= 1; size /= 2) {
        one.level = std::min(one.level + 1, deepestLevel);
        one.levelSize = size;
        one.size = size * oversamplingOfLevel(size);
        levels.push_back(averaged(evaluate(document, one, job), size, job));
    }
    return levels;
}

std::vector<Image> evaluateLevels(const SphereMapDocument& document, int size, const JobControl& job)
{
    return evaluateLevels(document, {.size = size}, job);
}

} // namespace mirrorball
