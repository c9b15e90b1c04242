#pragma once

#include "pace.h"
#include "report.h"

#include "core/base/job.h"

#include <string>
#include <vector>

/// Error against run time of every method on one probe with one lobe.
namespace mirrorball {

struct ErrorTimeOptions {
    MapLayout target{.kind = Parameterization::Cube, .size = 64};
    std::vector<Method> methods{allMethods.begin(), allMethods.end()};
    Sweep sweep = Sweep::Usual;
    double tolerance = 1e-3; ///< rel_rms of the verdicts and of the settings that are shown
    int repeats = 5;         ///< timed runs of each setting
    double longest = 3.0;    ///< seconds; a setting predicted to take longer is left out, a dear one is repeated no longer than this
    int directions = 512;    ///< at which the reference is summed
};

/// Measures every setting of every method against the reference. Each run starts from a source that holds nothing but the probe; memory
/// is watched in the first run, which also warms up, and times are of the later ones (or of the first where it took long).
///
/// When the job is stopped, what is not yet measured is left out and the rest stays; a stop before the reference is known throws.
/// @param probe  holds its texels, and the device of the paraboloid method if there is one
/// @param name   of the probe as given, for the commands
/// @throws Cancelled
ReportCase measureCase(const FilterSource& probe, const std::string& name, const Lobe& lobe, const ErrorTimeOptions& options,
                       const JobControl& job = {});

/// What measureCase() is expected to take, in predicted seconds (pace.h). @param probe  as a plan knows it before it is opened
double expectedCaseSeconds(const ProbeTraits& probe, const Lobe& lobe, const ErrorTimeOptions& options, const Pace& pace);

/// Left out for its time: the reason, in words.
std::string tooLong(double seconds, double longest);

} // namespace mirrorball
