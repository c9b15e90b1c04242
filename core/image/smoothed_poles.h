#pragma once

#include "environment_map.h"

namespace mirrorball {

/// A latlong whose rows are averaged along the longitude over the length of a texel at the equator: towards the poles texels become slivers
/// finer than what samples of that spacing can see. Other maps are returned as they are. Exact for the energy of every row.
EnvironmentMap smoothedPoles(EnvironmentMap map);

} // namespace mirrorball
