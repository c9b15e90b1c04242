#pragma once

#include "core/spheremap/math/level.h"

#include "core/image/image.h"

#include <memory>
#include <vector>

namespace mirrorball {

/// A sphere map and its coarser levels, as a picture reads it.
struct SphereMapTexels {
    std::vector<Image> levels{}; ///< RGBA, linear, colors multiplied by opacity; largest first, each half of the one before
    SphereMapIndex index = SphereMapIndex::Normal;
    bool hasAuthoredLevels = false; ///< coarser levels are more than averages: their level is chosen along the disc's radius
};
using SphereMapChain = std::shared_ptr<const SphereMapTexels>;

} // namespace mirrorball
