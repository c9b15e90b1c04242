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

const Image& levelOf(const SphereMapTexels& chain, int size, int level)
{
    const auto isSmallEnough = [wanted = std::max(1, size >> level)](const Image& image) { return image.width <= wanted; };
    return *std::find_if(chain.levels.begin(), chain.levels.end() - 1, isSmallEnough);
}

} // namespace mirrorball::studio
