#include "live_sphere_map.h"

#include <algorithm>

namespace mirrorball::studio {

SphereMapChain liveSphereMap(const LiveScene& live, int size)
{
    const auto made = live.made();
    if (!made || made->plan.sphereMaps.empty() || !made->plan.sphereMaps.front().document || made->maps.sphereMaps.empty())
        return nullptr;
    const int width = made->maps.sphereMaps.front()->levels.front().width, drawn = made->plan.sphereMaps.front().drawnSize;
    const bool isOfSize = made->plan.sphereMaps.front().size == size && (width == size || width == drawn);
    return isOfSize ? made->maps.sphereMaps.front() : nullptr;
}

Image levelOf(const SphereMapTexels& chain, int size, int level)
{
    const Image& finest = chain.levels.front();
    const int wanted = std::max(1, size >> level);
    if (wanted <= finest.width) {
        const auto isSmallEnough = [wanted](const Image& image) { return image.width <= wanted; };
        const auto found = std::find_if(chain.levels.begin(), chain.levels.end(), isSmallEnough);
        return found == chain.levels.end() ? chain.levels.back() : *found;
    }
    const int times = wanted / finest.width;
    Image large(wanted, wanted, 4);
    for (int y = 0; y < wanted; ++y) {
        const float* from = finest.row(y / times);
        float* to = large.row(y);
        for (int x = 0; x < wanted; ++x, to += 4)
            std::copy_n(from + 4 * (x / times), 4, to);
    }
    return large;
}

} // namespace mirrorball::studio
