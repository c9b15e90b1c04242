#pragma once

#include "paraboloid.h"

namespace mirrorball {

/// paraboloidSum() of halves of the exact kernel: the sum over the texels of both halves under the lobe, whose outline is a circle in each.
///   E(r) = sum_j k(r.d_j) L_j w_j / sum_j k(r.d_j) w_j
/// The lobe is read from a table over the chord, right to 1e-6 of its peak.
std::vector<glm::dvec3> exactParaboloidSum(const ParaboloidHalves& halves, std::span<const glm::dvec3> directions, const JobControl& job);

} // namespace mirrorball
