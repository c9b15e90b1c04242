#include "live_sphere_map.h"

#include <algorithm>

namespace mirrorball::studio {

SphereMapChain liveSphereMap(const LiveScene& live, int size)
{
    const auto made = live.made();
    if (!made || made->plan.sphereMaps.empty() || !made->plan.sphereMaps.front().document || made->maps.sphereMaps.empty())
        return nullptr;
    const SphereMapChain& chain = made->maps.sphereMaps.front();
    const int width = chain->levels.front().width, drawn = made->plan.sphereMaps.front().drawnSize;
    return made->plan.sphereMaps.front().size == size && (width == size || width == drawn) ? chain : nullptr;
}

int levelsLeftOut(const SphereMapTexels& chain, int size)
{
    int levels = 0;
    for (; size > chain.levels.front().width; size /= 2)
        ++levels;
    return levels;
}

const Image& levelOf(const SphereMapTexels& chain, int size, int level)
{
    const int last = static_cast<int>(chain.levels.size()) - 1;
    return chain.levels[static_cast<size_t>(std::clamp(level - levelsLeftOut(chain, size), 0, last))];
}

} // namespace mirrorball::studio
