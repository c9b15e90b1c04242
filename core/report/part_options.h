#pragma once

#include "cost_growth.h"
#include "error_time.h"
#include "make_report.h"
#include "method_comparison.h"
#include "parameterization_study.h"
#include "published_paraboloid.h"
#include "stability.h"

/// What each part of a report is asked for: the same for who measures it and for who foretells what that takes.
namespace mirrorball {

inline ErrorTimeOptions errorTimeOptions(const ReportOptions& options)
{
    return {.target = options.target,
            .methods = options.methods,
            .sweep = options.sweep,
            .tolerance = options.tolerance,
            .repeats = options.repeats,
            .longest = options.longest,
            .directions = options.directions};
}

inline ParameterizationStudyOptions studyOptions(const ReportOptions& options)
{
    return {.lobe = options.lobes.front(),
            .texels = options.target.width() * options.target.height(),
            .referenceDirections = options.directions,
            .mirrorLookups = options.sweep == Sweep::Few ? 1 << 16 : 1 << 19,
            .repeats = options.repeats,
            .drawer = options.drawer};
}

inline CostGrowthOptions growthOptions(const ReportOptions& options)
{
    return {.methods = options.methods,
            .lobe = options.lobes.front(),
            .target = options.target,
            .tolerance = options.tolerance,
            .largestWidth = options.growthTo,
            .repeats = std::min(options.repeats, 3),
            .device = options.device,
            .longest = options.longest};
}

inline KernelTableOptions kernelTableOptions(const ReportOptions& options)
{
    return {.tolerance = options.tolerance, .repeats = options.repeats, .longest = options.longest, .drawer = options.drawer};
}

inline MethodComparisonOptions comparisonOptions(const ReportOptions& options) { return {.device = options.device}; }

inline StabilityScale stabilityScale(const ReportOptions& options)
{
    return options.sweep == Sweep::Few ? StabilityScale::Small : StabilityScale::Large;
}

} // namespace mirrorball
