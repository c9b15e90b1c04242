#pragma once

#include "band_limit.h"
#include "filter_source.h"
#include "kernel_split.h"
#include "near_sum.h"
#include "prediction.h"

#include "core/base/job.h"
#include "core/image/environment_map.h"

#include <limits>
#include <memory>
#include <optional>

namespace mirrorball {

/// What `direct` does for ggx where that is cheaper than a sum over all texels under its tail: those within the reach of a KernelSplit are
/// summed (NearSum), and the far part is filtered as spectral does it, from the probe's spectrum, which other lobes share.
///
///   E(r) = (sum_(t < reach) w L n + sum_lm f_l a_lm Y_lm) / (the same of a constant 1)
///
/// L is the calm part of the probe; the excess of its brightest texels goes through the whole lobe (BrightLobe).
///
/// How the work is shared out.
struct NearFarPlan {
    int bandLimit = 0;                                        ///< of the far part
    double leftOut = 0.0;                                     ///< see KernelSplit
    double seconds = std::numeric_limits<double>::infinity(); ///< of one thread; infinite where the lobe or the tolerance does not allow it

    bool possible() const { return bandLimit > 0; }
};

/// The band limit whose near and far part together are cheapest, in closed form: no coefficient is computed.
/// @param least  band limits below this are out of the question
NearFarPlan planNearFar(const PrefilterOptions& options, const ProbeTraits& probe, int least = 0);

/// Ready to filter.
struct SettledNearFar {
    SettledSpectral far{}; ///< the far kernel, scaled to integral 1, and what is predicted of the whole map
    double farShare = 0.0; ///< its integral
    std::shared_ptr<const NearSum> near{};
};

/// Looks at the probe and settles it.
/// @param strictness  1, or a smaller factor of the error that is allowed, for when a map turned out darker than was foreseen
SettledNearFar settleNearFar(FilterSource& source, const PrefilterOptions& options, const JobControl& job = {}, double strictness = 1.0);

/// @throws Cancelled
EnvironmentMap filterNearFar(FilterSource& source, const SettledNearFar& settled, const PrefilterOptions& options,
                             const JobControl& job = {});

} // namespace mirrorball
