#pragma once

#include "core/image/environment_map.h"

#include <glm/glm.hpp>

#include <span>

namespace mirrorball {

/// Error of values E against reference values R at the same directions, over all channels, weighted by solid angle (docs/conventions.md).
struct ErrorMetrics {
    double relRms = 0.0; ///< rms(E - R) / rms(R); 0 where both are 0
    double maxAbs = 0.0; ///< max|E - R| / rms(R)
    /// Median of |E - R| / max(R, 1e-6 mean(R)): what most of the map is seen to miss, beside whatever sun.
    double medianRel = 0.0;
    double p99Rel = 0.0; ///< 99th percentile of the same: shows ringing in the dark beside a sun
};

/// @param solidAngles one a direction; empty: all equal
ErrorMetrics errorMetrics(std::span<const glm::dvec3> values, std::span<const glm::dvec3> reference,
                          std::span<const double> solidAngles = {});

/// The same for two maps of one layout; texels outside a disc do not count. @throws InvalidArgument when the layouts differ
ErrorMetrics errorMetrics(const EnvironmentMap& map, const EnvironmentMap& reference);

} // namespace mirrorball
