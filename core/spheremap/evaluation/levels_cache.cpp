#include "levels_cache.h"

#include <algorithm>

namespace mirrorball {

LevelsCache::LevelsCache(const EvaluateOptions& options)
{
    EvaluateOptions one = options;
    if (!one.assets)
        one.assets = std::make_shared<SphereMapAssets>();
    one.level = 0;
    for (int size = options.size / 2; size >= 1; size /= 2) {
        one.level = std::min(one.level + 1, deepestLevel);
        one.levelSize = size;
        one.size = size * oversamplingOfLevel(size);
        m_levels.emplace_back(one);
    }
}

std::vector<LevelPatch> LevelsCache::update(const SphereMapDocument& document, const JobControl& job)
{
    std::vector<LevelPatch> patches;
    int level = 0;
    for (SphereMapCache& cache : m_levels) {
        ++level;
        const TexelRect touched = cache.update(document, job);
        if (touched.empty())
            continue;
        const int factor = oversamplingOfLevel(cache.levelSize());
        const TexelRect rect{touched.x0 / factor, touched.y0 / factor, (touched.x1 + factor - 1) / factor,
                             (touched.y1 + factor - 1) / factor};
        patches.push_back(
            {level, rect,
             blockAverages(cache.image(), {rect.x0 * factor, rect.y0 * factor, rect.x1 * factor, rect.y1 * factor}, factor, job)});
    }
    return patches;
}

} // namespace mirrorball
