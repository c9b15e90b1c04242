#pragma once

#include "widgets/workspace/live_scene.h"

#include "core/image/image.h"
#include "core/scene/scene_maps.h"

namespace mirrorball::studio {

/// The scene's own map as it was last made for the model, for a map of so many texels; null where there is none. While something is
/// dragged it may have fewer: half as many, or a quarter.
SphereMapChain liveSphereMap(const LiveScene& live, int size);

/// How many of the finest levels of a map of `size` texels its chain lacks.
int levelsLeftOut(const SphereMapTexels& chain, int size);

/// The level of a map of `size` texels out of its chain, or out of one that lacks its finest levels: then the finest that is no larger.
const Image& levelOf(const SphereMapTexels& chain, int size, int level);

} // namespace mirrorball::studio
