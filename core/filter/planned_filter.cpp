#include "planned_filter.h"

#include <algorithm>

namespace mirrorball {

PlannedFilter planFilter(const PrefilterOptions& options, int probeWidth)
{
    PlannedFilter planned{.options = options, .plan = planPrefilter(options, {.width = probeWidth})};
    const PrefilterPlan& plan = planned.plan;
    constexpr std::int64_t bytesATexel = 12; // three floats
    planned.filtering = {plan.predictedSeconds, bytesATexel * options.target.width() * options.target.height()};
    if (plan.filtered && plan.bandLimit > 0) {
        const double again = predictedSeconds(plan.method, options, {.width = probeWidth, .knownBandLimit = plan.bandLimit});
        const double coefficients = 0.5 * (plan.bandLimit + 1.0) * (plan.bandLimit + 2.0);
        planned.spectrum = {std::max(0.0, plan.predictedSeconds - again), static_cast<std::int64_t>(48.0 * coefficients)};
        planned.filtering.seconds = again;
    }
    return planned;
}

} // namespace mirrorball
