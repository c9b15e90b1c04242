#include "conductor.h"

#include <algorithm>
#include <array>

namespace mirrorball {

// n and k read at conductorWavelengths by linear interpolation between neighboring rows of the tables of the refractiveindex.info
// database (M. Polyanskiy, CC0): P. B. Johnson and R. W. Christy, Phys. Rev. B 6, 4370 (1972) for the noble metals and Phys. Rev. B 9,
// 5056 (1974) for chromium and iron; A. D. Rakic, Appl. Opt. 34, 4755 (1995) for aluminium.
static constexpr std::array metals{
    Conductor{"silver", {{0.05833, 0.05988, 0.04639}, {4.10286, 3.58925, 2.79247}}, "Johnson and Christy 1972"},
    Conductor{"gold", {{0.22337, 0.42833, 1.33527}, {3.20364, 2.45987, 1.87246}}, "Johnson and Christy 1972"},
    Conductor{"copper", {{0.36686, 1.01618, 1.24639}, {3.12126, 2.57852, 2.45196}}, "Johnson and Christy 1972"},
    Conductor{"aluminium", {{1.31954, 1.01095, 0.68251}, {7.30676, 6.61574, 5.62303}}, "Rakic 1995"},
    Conductor{"chromium", {{3.17857, 3.18000, 2.44700}, {3.30000, 3.33000, 3.20500}}, "Johnson and Christy 1974"},
    Conductor{"iron", {{2.89029, 2.95000, 2.64200}, {3.03971, 2.93000, 2.80250}}, "Johnson and Christy 1974"},
};

std::span<const Conductor> conductors() { return metals; }

std::optional<ConductorIndex> conductorFromName(std::string_view name)
{
    const auto found = std::find_if(metals.begin(), metals.end(), [&](const Conductor& metal) { return metal.name == name; });
    if (found == metals.end())
        return std::nullopt;
    return found->index;
}

} // namespace mirrorball
