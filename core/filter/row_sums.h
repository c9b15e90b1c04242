#pragma once

#include "lobe.h"

#include "core/base/job.h"
#include "core/image/environment_map.h"

#include <span>
#include <vector>

namespace mirrorball {

/// Whether a lobe is a polynomial of r.d above the horizon, of degree 3 at most: diffuse, ggx of alpha 1, phong of exponent 0, 1, 2, 3.
/// Those have a kink there or a step, and a spectrum without end.
bool isShortPolynomial(const Lobe& lobe);

/// The reference sum for such a lobe, in time that grows with the probe's rows and not with its texels. In a row r.d = B + A cos(lon -
/// lon_r), so that k is a sum of cos(m lon) and sin(m lon), m <= 3, over the texels above the horizon, which follow one another: their sum
/// is the difference of two running sums.
/// @param directions unit vectors; the result is as referenceSum()'s, to a few roundings of a double
/// @throws InvalidArgument when the map is not latlong or the lobe is no such one; Cancelled
std::vector<glm::dvec3> rowSums(const EnvironmentMap& latlong, const Lobe& lobe, std::span<const glm::dvec3> directions,
                                const JobControl& job = {});

/// Seconds of one thread. Calibrated by `build/ci/bin/method_table methods`.
double rowSumsSeconds(int latlongWidth, int directions);

} // namespace mirrorball
