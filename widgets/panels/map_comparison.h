#pragma once

#include "core/base/job.h"
#include "core/image/environment_map.h"
#include "core/report/error_metrics.h"

#include <memory>

namespace mirrorball::studio {

/// The layout of a kind in which an image has about as many texels as another map's.
MapLayout equalTexels(Parameterization kind, const MapLayout& other);

/// One map in two layouts, and what they disagree in.
struct MapComparison {
    std::shared_ptr<const EnvironmentMap> a, b; ///< the map itself where it has that layout already
    std::shared_ptr<const EnvironmentMap> difference;
    ErrorMetrics error{}; ///< of b, judged by a
    double range = 1.0;   ///< of colors of the difference
};

/// @throws Cancelled
MapComparison compareLayouts(const std::shared_ptr<const EnvironmentMap>& map, const MapLayout& a, const MapLayout& b,
                             const JobControl& job);

} // namespace mirrorball::studio
