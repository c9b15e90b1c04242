#pragma once

#include "lobe.h"

#include "core/base/job.h"
#include "core/image/environment_map.h"

#include <span>
#include <vector>

namespace mirrorball {

/// The reference sum over the texels under the lobe only: those nearer to r than the angle at which k has fallen to `level` of its
/// peak. The right choice for very narrow lobes, whose spectrum is long but whose support is a few texels; and, as rowSums(), for the
/// widest, whose spectrum is long for their kink. Of ggx with its long tail the direct method sums less: near_far.h.
struct DirectOptions {
    double level = 1e-12; ///< (0, 1): the texels left out weigh less than this times the peak each
};

/// @param directions unit vectors; the result is as referenceSum()'s
/// @throws InvalidArgument when the map is not latlong or the lobe is a mirror; Cancelled
std::vector<glm::dvec3> directSum(const EnvironmentMap& latlong, const Lobe& lobe, std::span<const glm::dvec3> directions,
                                  const DirectOptions& options = {}, const JobControl& job = {});

/// Share of the lobe's integral that lies beyond the support of `level`: bounds the error relative to the brightest texel.
double directTruncation(const Lobe& lobe, const DirectOptions& options);

/// Texels of a latlong map of this width under the lobe, on average over the sphere.
double directTaps(const Lobe& lobe, int latlongWidth, const DirectOptions& options);

} // namespace mirrorball
