#include "symmetry.h"

#include "core/sphere/direction.h"

#include <algorithm>
#include <cmath>

namespace mirrorball {

std::vector<glm::dmat2> symmetryMaps(const Symmetry& symmetry)
{
    const int turns = std::max(symmetry.radial, 1);
    std::vector<glm::dmat2> maps;
    maps.reserve(static_cast<size_t>(turns) * (symmetry.mirror ? 2 : 1));
    for (int k = 0; k < turns; ++k) {
        const double angle = 2.0 * pi * k / turns;
        const double c = std::cos(angle), s = std::sin(angle);
        maps.push_back({c, s, -s, c});
    }
    if (symmetry.mirror) {
        const double twice = 2.0 * symmetry.axisDeg * pi / 180.0;
        const double c = std::cos(twice), s = std::sin(twice);
        const glm::dmat2 reflection{c, s, s, -c};
        for (int k = 0; k < turns; ++k)
            maps.push_back(maps[static_cast<size_t>(k)] * reflection);
    }
    return maps;
}

} // namespace mirrorball
