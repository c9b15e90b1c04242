#pragma once

#include "core/base/job.h"

namespace mirrorball {

/// How long the seconds that prediction.h and stage_cost.h speak of, of one thread of the server they were calibrated on, take here and
/// now: with this processor, so many threads, and whatever else the machine is doing.
struct Pace {
    double slowness = 1.0; ///< seconds of the clock a predicted second
    double seconds(double predicted) const { return slowness * predicted; }
};

/// Times three small filters, some hundredths of a second each. @throws Cancelled
Pace measurePace(const JobControl& job = {});

} // namespace mirrorball
