#pragma once

#include "pace.h"
#include "report.h"

#include "core/base/job.h"

#include <memory>

namespace mirrorball {

struct MethodComparisonOptions {
    int size = 128;                             ///< of a half, its border included; even
    int border = 16;                            ///< around each disc
    std::shared_ptr<ParaboloidDevice> device{}; ///< of the two kernels; null: the CPU
};

/// 000 figure 13: a paraboloid map, unfiltered, and filtered by phong 100 in three ways: by the
/// classic sum over all texels, hierarchically, and by the two kernels of section 3.2.5 as hardware of the time ran them (clamped at 0.1,
/// at most 7 texels). Errors and times stand beside the pictures.
/// @param probe   any map; it becomes the figure's original first
/// @throws Cancelled
MethodComparison compareMethods(const EnvironmentMap& probe, const MethodComparisonOptions& options = {}, const JobControl& job = {});

/// What that is expected to take.
double expectedComparisonSeconds(const MethodComparisonOptions& options, const Pace& pace);

} // namespace mirrorball
