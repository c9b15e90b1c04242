#pragma once

#include "filter_source.h"
#include "lobe.h"
#include "spectral.h"

#include "../job.h"

namespace mirrorball {

/// The spectrum a lobe needs of a probe, and how far. A slowly decaying lobe is followed step by step: each look at the probe's own power
/// tells whether a longer spectrum is worth its time.
struct SettledBandLimit {
    BandLimitPlan plan{};
    const Spectrum* spectrum = nullptr; ///< the source's
    bool split = false;                 ///< it leaves the source's bright texels out
};

/// @throws WorkError when a streamed probe was read with less than that; Cancelled
SettledBandLimit settleBandLimit(FilterSource& source, const Lobe& lobe, double tolerance, const JobControl& job = {});

/// Legendre coefficients looked at first: they settle every band limit up to half their number.
inline constexpr int firstCoefficients = 768;

} // namespace mirrorball
