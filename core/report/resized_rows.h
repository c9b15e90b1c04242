#pragma once

#include "core/base/job.h"
#include "core/image/environment_map.h"

#include <vector>

namespace mirrorball {

/// Some rows of a latlong probe at another width, as a file of that size would hold them: bilinear lookups at the texels' centers, equal to
/// EnvironmentMap::radiance() up to rounding, at a few operations a texel, because both maps' texels lie on the same meridians and
/// parallels.
/// @param probe  a latlong map
/// @param width  columns of the other map, even; it has half as many rows
/// @return rows * width RGB texels
/// @throws InvalidArgument for another parameterization; Cancelled
std::vector<float> resizedRows(const EnvironmentMap& probe, int width, int firstRow, int rows, const JobControl& job = {});

} // namespace mirrorball
