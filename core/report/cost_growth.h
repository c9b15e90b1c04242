#pragma once

#include "pace.h"
#include "report.h"

#include "core/base/job.h"
#include "core/filter/filter_source.h"

#include <memory>
#include <vector>

namespace mirrorball {

struct CostGrowthOptions {
    std::vector<Method> methods{allMethods.begin(), allMethods.end()}; ///< the reference is passed over
    Lobe lobe{};
    MapLayout target{.kind = Parameterization::Cube, .size = 64};
    double tolerance = 1e-3;
    int largestWidth = 2048; ///< columns of the largest probe: a power of two, 256 to 16384
    int repeats = 3;
    std::shared_ptr<ParaboloidDevice> device{}; ///< of the paraboloid method, for the probes of other widths
    double longest = 3.0;                       ///< seconds; a method that took longer is not tried further up
};

/// How time and memory of each method grow, with its usual knobs: with the probe's width from 256 by doublings, and with the exponent of
/// a phong lobe from 1 to 1e6 by tens. Probes of other widths are the given one resampled. Beyond streamedFrom texels the probe is never
/// held: its rows are made on the fly and go through a SpectrumBuilder; making them is not counted in the time.
/// When the job is stopped, the points measured so far come back.
std::vector<GrowthPoint> measureGrowth(const FilterSource& probe, const CostGrowthOptions& options, const JobControl& job = {});

/// What measureGrowth() is expected to take.
double expectedGrowthSeconds(const ProbeTraits& probe, const CostGrowthOptions& options, const Pace& pace);

} // namespace mirrorball
