#pragma once

#include "filter_source.h"
#include "lobe.h"
#include "spectral.h"

#include "core/base/job.h"

#include <vector>

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

/// Power of a degree l > 0 that a usual photograph has about its mean, the mean being 1: suns make it flat, skies and rooms do not.
double usualPower(int l);

/// Whether a plan made from the lobe alone is taken as it is: it is short, and a look at the probe would hardly make it shorter. A lobe
/// with a kink at the horizon is planned several times too long for a usual probe.
/// @param k  the lobe's coefficients, firstCoefficients of them
bool isSettled(const BandLimitPlan& fromLobe, const std::vector<double>& k, double tolerance);

} // namespace mirrorball
