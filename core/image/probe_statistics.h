#pragma once

#include "environment_map.h"

#include <glm/glm.hpp>

namespace mirrorball {

/// Figures that tell what a probe holds. Luminance is Rec.709's; means are weighted by solid angle; texels outside a disc do not count.
struct ProbeStatistics {
    double minLuminance = 0.0;
    double maxLuminance = 0.0;
    glm::dvec3 meanRadiance{0.0};
    double meanLuminance = 0.0;
    glm::dvec3 brightestDirection{0.0, 1.0, 0.0};
    /// Share of the energy (luminance times solid angle) that the brightest 0.01 % of the texels hold, at least one; 0 for a black probe.
    double sunShare = 0.0;
    double largestValue = 0.0;       ///< of any channel
    std::int64_t beyondHalf = 0;     ///< channel values above 65504, which a half float cannot hold
};

ProbeStatistics statistics(const EnvironmentMap& map);

} // namespace mirrorball
