#pragma once

#include "filter_source.h"
#include "lobe.h"
#include "prediction.h"
#include "promise.h"
#include "spectral.h"

#include "core/base/job.h"

#include <vector>

namespace mirrorball {

/// How the spectral method is going to filter a probe: which bright texels go through the lobe one by one, how far the spectrum of the
/// rest is followed, how finely it is read - so that the error keeps what the tolerance promises - and what that error is.
struct SettledSpectral {
    std::vector<double> k{};            ///< the lobe's Legendre coefficients, 0 .. band limit
    std::vector<double> longer{};       ///< the same, followed further: for the norm
    int rings = 0;                      ///< of the ring grid; 0: the target lies on rings
    size_t split = 0;                   ///< index into brightSplits
    const Spectrum* spectrum = nullptr; ///< the source's, of what the split leaves
    glm::dvec3 error{0.0};              ///< root mean square of truncation and interpolation, radiance of each channel
    double normError = 0.0;             ///< relative error of what the values are divided by: N
    double relative = 0.0;              ///< what each value is off by beside that, relative to it
    glm::dvec3 calmMean{0.0}; ///< of what the split leaves; it has the same N, so that only what differs from it is divided wrongly
    PredictedErrors predicted{};
    double seconds = 0.0; ///< of one thread, from here on
    bool keeps = false;   ///< the tolerance

    int bandLimit() const { return static_cast<int>(k.size()) - 1; }
};

/// Settles it, step by step: each look at the probe's own power tells whether a longer spectrum or a deeper split is worth its time.
/// @param strictness  1, or a smaller factor of the error that is allowed, for when a map turned out darker than was foreseen
/// @throws WorkError when a streamed probe was read with less than a first look needs; Cancelled
SettledSpectral settleSpectral(FilterSource& source, const PrefilterOptions& options, const JobControl& job = {}, double strictness = 1.0);

/// rel_rms, or any relative error, of a map stored as floats and read off a grid of floats.
inline constexpr double spectralRounding = 2.5e-7;

/// Errors of a map that holds such values, with the rounding.
PredictedErrors spectralErrors(const ValueDistribution& values, const SettledSpectral& settled);

/// The mean radiance that a spectrum has.
glm::dvec3 meanOf(const Spectrum& spectrum);

/// A filtered spectrum at some hundred even directions.
struct CoarseLook {
    static constexpr int ringCount = 16, samples = 32, count = ringCount * samples;
    std::vector<SpherePoint> places{};
    std::vector<glm::dvec3> directions{}; ///< of the places
    FilteredRings rings{};                ///< at the places
};
/// @param k  as far as it is to be followed, no further than the spectrum. @param longer  of the same lobe, for the norm
CoarseLook lookCoarsely(const Spectrum& spectrum, const std::vector<double>& k, const std::vector<double>& longer, const JobControl& job);

/// Legendre coefficients looked at first: they settle every band limit up to half their number.
inline constexpr int firstCoefficients = 768;

/// Power of a degree l > 0 that a usual photograph has about its mean, the mean being 1: suns make it flat, skies and rooms do not.
double usualPower(int l);

/// Seconds of one thread: the forward transform of a probe, and the way from a spectrum to a map.
double forwardSeconds(int probeWidth, int bandLimit);
double inverseSeconds(int bandLimit, int rings, const MapLayout& target);
/// Of bright texels seen through a lobe by every texel of the target.
double brightSeconds(const Lobe& lobe, size_t brightTexels, const MapLayout& target);

} // namespace mirrorball
