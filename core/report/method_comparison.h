#pragma once

#include "pace.h"
#include "report.h"

#include "core/base/job.h"

#include <memory>

namespace mirrorball {

/// 000 figure 13: a paraboloid map of 128 texels a half with a border of 16, unfiltered, and filtered by phong 100 in three ways: by the
/// classic sum over all texels, hierarchically, and by the two kernels of section 3.2.5 as hardware of the time ran them (clamped at 0.1,
/// at most 7 texels). Errors and times stand beside the pictures.
/// @param probe   any map; it becomes the figure's original first
/// @param device  for the last; null: the CPU
/// @throws Cancelled
MethodComparison compareMethods(const EnvironmentMap& probe, std::shared_ptr<ParaboloidDevice> device, const JobControl& job = {});

/// What that is expected to take.
double expectedComparisonSeconds(const Pace& pace);

} // namespace mirrorball
