#pragma once

#include "bright_texels.h"
#include "lobe.h"
#include "ring_grid.h"
#include "spectrum.h"

namespace mirrorball {

/// The spectral method: a radial convolution is a product per degree, e_lm = k_l a_lm. Funk-Hecke theorem; 000 section 3.2.2 gives
/// the lobes.
///
/// How far a lobe's spectrum must be followed.
struct BandLimitPlan {
    int bandLimit = 0;
    std::vector<double> k{};     ///< the lobe's Legendre coefficients, 0 .. bandLimit
    std::vector<double> share{}; ///< each degree's share of the filtered map's power, at most; 0 .. bandLimit
    double predictedError = 0.0; ///< rel_rms that the truncation costs at most
};

/// The largest band limit that is ever used, and the most rings: such a grid takes about 0.5 GB.
inline constexpr int largestBandLimit = 2048;
inline constexpr int largestRings = 4096;

/// The band limit a lobe needs whatever the probe holds. With a_00 the mean, a non-negative probe has at most the power
/// (2l+1) a_00^2 in degree l (that of a single bright texel), so that
///   rel_rms^2 <= sum_(l > B) (2l+1) k_l^2
/// Lobes whose spectrum decays fast are followed further than that asks for, because beside a sun the dark shows an error that the
/// root mean square hides.
/// @param k  legendreCoefficients(), at least twice as long as the band limit that comes out; what lies beyond them is estimated from
///           their last octave, and a band limit over half their length means that a longer list may ask for more
BandLimitPlan planBandLimit(const std::vector<double>& k, double tolerance);

/// The same for a probe whose spectrum is known up to some degree: uses its power there, and the strongest power of its last
/// degrees beyond. Lobes with a kink at the horizon (diffuse, rough ggx) decay slowly and gain most.
/// @param least  the band limit is never below this
BandLimitPlan planBandLimit(const std::vector<double>& k, double tolerance, const Spectrum& spectrum, int least = 0);
/// @param power  per degree about the mean, as Spectrum::powerAboutMean()
BandLimitPlan planBandLimit(const std::vector<double>& k, double tolerance, const std::vector<double>& power, int least = 0);

/// rel_rms of the filtered map to be expected: truncation, reading off a target that is not on rings, and rounding to float.
/// @param power  per degree about the mean, as far as it is known; empty: the worst a non-negative probe can have
double spectralError(const BandLimitPlan& plan, const MapLayout& target, double tolerance, const std::vector<double>& power = {});

/// The filtered map. The rows of a latlong target are rings, on which it is synthesized in place; other targets are read off a
/// RingGrid at `points`, the target's spherePoints() (unused for latlong).
/// @param k  the lobe's coefficients, 0 .. band limit, at most the spectrum's
/// @param rings  of the ring grid (unused for latlong)
/// @param bright  what was taken out of the probe before its spectrum was made; empty for a whole probe
/// @param longer  k followed further, for the norm; empty: k
/// @throws Cancelled
EnvironmentMap filterSpectral(const Spectrum& spectrum, const std::vector<double>& k, int rings, const BrightLobe& bright,
                              const MapLayout& target, std::span<const SpherePoint> points, double yaw, const JobControl& job = {},
                              const std::vector<double>& longer = {});

} // namespace mirrorball
