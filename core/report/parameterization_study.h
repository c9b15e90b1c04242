#pragma once

#include "map_drawer.h"
#include "pace.h"
#include "report.h"

#include "core/base/job.h"
#include "core/filter/filter_source.h"

#include <memory>

namespace mirrorball {

struct ParameterizationStudyOptions {
    Lobe lobe{};
    int texels = 24576;                  ///< of each image, about
    int referenceDirections = 512;       ///< at which the reference is summed
    int mirrorLookups = 1 << 19;         ///< about, at most: texels of the probe at which the mirror is looked up
    int repeats = 5;                     ///< timed rounds of lookups, and pictures; the median is taken
    std::shared_ptr<MapDrawer> drawer{}; ///< null: drawing is not timed
};

/// The parameterizations against each other at about as many texels of image each: what a mirror lookup and a lookup of a filtered map
/// lose, how unevenly the texels are spread (solid angle against angle as 000 figure 4), how far they are stretched, and what a lookup and
/// a picture with one lookup a pixel take.
///
/// Errors are rel_rms of bilinear lookups: of the probe resampled, at the probe's own texels; of the filtered map, against the reference
/// sum at even directions. The filtered map is made by the spectral method as exactly as that can promise, and it is the one that is timed.
/// @throws Cancelled
ParameterizationStudy studyParameterizations(const FilterSource& probe, const ParameterizationStudyOptions& options,
                                             const JobControl& job = {});

/// What studyParameterizations() is expected to take.
double expectedStudySeconds(const ProbeTraits& probe, const ParameterizationStudyOptions& options, const Pace& pace);

/// Of that kind, the size whose image has the number of texels nearest to `texels`.
MapLayout layoutOfTexels(Parameterization kind, int texels);

} // namespace mirrorball
