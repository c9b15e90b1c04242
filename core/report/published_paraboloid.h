#pragma once

#include "map_drawer.h"
#include "pace.h"
#include "report.h"

#include "core/base/job.h"
#include "core/filter/filter_source.h"

#include <memory>
#include <vector>

/// The paraboloid method as 000 section 3.2.5 shows it: its table of kernel sizes with frames a second, and figure 12.
namespace mirrorball {

struct KernelTableOptions {
    double tolerance = 1e-3;             ///< of the frames by `auto`
    int repeats = 5;                     ///< timed frames of a cell; the median is taken
    double longest = 3.0;                ///< seconds; a cell's frames are repeated no longer than this
    std::shared_ptr<MapDrawer> drawer{}; ///< null: nothing is drawn, a frame is the filter alone
};

/// Exponents 10 to 500 in a half of 512 texels with a border of 64, clamped at 0.1, kernels of at most 7 texels. Each frame filters the
/// probe anew into a paraboloid map, as the paper does though the exponent stays, and draws a sphere that mirrors it.
/// @param probe  with the device of the paraboloid method, if there is one
/// @throws InvalidArgument for a streamed probe; Cancelled
KernelTable measureKernelTable(const FilterSource& probe, const KernelTableOptions& options, const JobControl& job = {});

/// What measureKernelTable() is expected to take.
double expectedKernelTableSeconds(const ProbeTraits& probe, const KernelTableOptions& options, const Pace& pace);

/// Figure 12: radii 0.1 to 0.5.
std::vector<DistortionCurve> distortionCurves();

/// Distances of a curve.
inline constexpr int distortionSteps = 51;

} // namespace mirrorball
