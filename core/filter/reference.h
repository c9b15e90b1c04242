#pragma once

#include "lobe.h"

#include "core/base/job.h"
#include "core/image/environment_map.h"

#include <span>
#include <vector>

namespace mirrorball {

/// The reference sum (docs/conventions.md): every texel of a latlong map against every direction, in double precision.
///
///   E(r) = sum_j L_j w_j k(r.d_j) / sum_j w_j k(r.d_j)
///
/// with texel centers d_j and exact texel solid angles w_j. Powers are taken in log space relative to the nearest texel's, so that
/// no exponent makes the sums over- or underflow; sums run row by row. It is what every method is measured against, and slow:
/// about texels x directions x 5 ns.
/// @param directions unit vectors
/// @throws InvalidArgument when the map is not latlong; Cancelled
std::vector<glm::dvec3> referenceSum(const EnvironmentMap& latlong, const Lobe& lobe, std::span<const glm::dvec3> directions,
                                     const JobControl& job = {});

/// Unit directions of every texel of a layout, row by row, looked up before a turn by `yaw` (direction.h): entry y * width + x.
std::vector<glm::dvec3> lookupDirections(const MapLayout& layout, double yaw);

} // namespace mirrorball
