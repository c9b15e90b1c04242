#pragma once

#include "report.h"

#include "core/base/job.h"
#include "core/filter/filter_source.h"

namespace mirrorball {

/// The parameterizations against each other at about `texels` texels of image each: what a mirror lookup and a lookup of a filtered map
/// lose, and how unevenly the texels are spread (solid angle against angle as 000 figure 4).
///
/// Errors are rel_rms of bilinear lookups: of the probe resampled, at the probe's own texels; of the filtered map, against the reference
/// sum at `referenceDirections` even directions. The filtered map is made by the spectral method at 1e-6.
/// @throws Cancelled
ParameterizationStudy studyParameterizations(const FilterSource& probe, const Lobe& lobe, int texels, int referenceDirections,
                                             const JobControl& job = {});

/// Of that kind, the size whose image has the number of texels nearest to `texels`.
MapLayout layoutOfTexels(Parameterization kind, int texels);

} // namespace mirrorball
