#pragma once

#include "band_limit.h"
#include "filter_source.h"
#include "prediction.h"

#include "core/base/job.h"
#include "core/image/environment_map.h"

#include <functional>
#include <limits>
#include <span>

namespace mirrorball {

/// What `direct` does where that is cheaper than a sum over all texels that a lobe sees: the lobe is split into a near part of few texels,
/// which are summed, and a far one of a short spectrum, which is filtered as spectral does it, from the probe's spectrum, which other lobes
/// share.
///
///   E(r) = (sum_near w L n + sum_lm f_l a_lm Y_lm) / (the same of a constant 1)
///
/// ggx: near its axis (KernelSplit, NearSum). phong of a small, broken exponent: just above its horizon (HorizonSplit, HorizonSum).
/// L is the calm part of the probe; the excess of its brightest texels goes through the whole lobe (BrightLobe).
///
/// Where a lobe is split, if it is.
enum class SplitAt { Nowhere, Axis, Horizon };

/// How the work is shared out.
struct NearFarPlan {
    SplitAt at = SplitAt::Nowhere;
    int bandLimit = 0;                                        ///< of the far part
    double leftOut = 0.0;                                     ///< at the axis: see KernelSplit
    double sharpness = 0.0;                                   ///< at the horizon: the HorizonSplit's width is this over the band limit
    double seconds = std::numeric_limits<double>::infinity(); ///< of one thread; infinite where the lobe or the tolerance does not allow it

    bool possible() const { return bandLimit > 0; }
};

/// The band limit whose near and far part together are cheapest, in closed form: no coefficient is computed.
/// @param least  band limits below this are out of the question, and so is a sharpness
NearFarPlan planNearFar(const PrefilterOptions& options, const ProbeTraits& probe, int least = 0, double leastSharpness = 0.0);

/// Ready to filter.
struct SettledNearFar {
    SettledSpectral far{}; ///< the far kernel, scaled to integral 1, and what is predicted of the whole map
    double farShare = 0.0; ///< its integral
    std::function<void(std::span<const SpherePoint> places, double yaw, glm::dvec4* sums)> near{}; ///< of R, G, B and 1
};

/// Looks at the probe and settles it.
/// @param strictness  1, or a smaller factor of the error that is allowed, for when a map turned out darker than was foreseen
SettledNearFar settleNearFar(FilterSource& source, const PrefilterOptions& options, const JobControl& job = {}, double strictness = 1.0);

/// @throws Cancelled
EnvironmentMap filterNearFar(FilterSource& source, const SettledNearFar& settled, const PrefilterOptions& options,
                             const JobControl& job = {});

} // namespace mirrorball
