#pragma once

#include "spectrum.h"

#include <span>
#include <vector>

namespace mirrorball {

/// Rings on which a filtered spectrum is wanted, each of `length` samples that start at an azimuth of its own: a ring may be a single
/// place.
struct RingSet {
    std::vector<double> colatitude{}; ///< from +Y
    std::vector<double> azimuth{};    ///< of the first sample, along the rows of a latlong map
    int length = 1;
};

/// The harmonics lambda_lm(cos gamma) = sqrt((2l+1)/(4 pi) (l-m)!/(l+m)!) P_lm, without the sign of Condon and Shortley, of one order m for
/// l = m .. L at many angles.
class OrderHarmonics {
public:
    OrderHarmonics(int m, int bandLimit);
    /// @param lambda  L + 1 values, those below m are 0
    void at(double gamma, std::span<double> lambda) const;
    /// Adds sum_j scale_j lambda_lm(cos gamma_j) to the L + 1 values of `sums`.
    void addSums(std::span<const double> gamma, std::span<const double> scale, std::span<double> sums) const;

private:
    int m_order;
    double m_diagonal;                ///< lambda_mm over sin^m
    std::vector<double> m_a{}, m_b{}; ///< lambda_l = a_l (x lambda_(l-1) - b_l lambda_(l-2))
};

/// Light gathered about every direction r by azimuth, m >= 0:
///   A_m(r) = integral kappa_m(gamma) e^(i m phi) L(d) d omega,
/// gamma the angle from r to d, phi the azimuth of d about r, 0 towards +Y along the meridian and growing along the rows of a latlong map
/// (reflection_frame.h: north to east). A_m is a field of spin m: seen from a frame turned by delta it gains e^(-i m delta), which is how
/// it crosses the poles and the edges of faces. With kappa_m(gamma) = sum_l k_l sqrt((2l+1)/(4 pi)) lambda_lm it is one inverse transform,
///   A_m = sum_l k_l sum_M a_lM {}_m Y_lM(r) up to sign.
/// Source: Challinor et al., "All-sky convolution for polarimetry experiments", Phys. Rev. D 62, 123002 (2000)
struct OrderMap {
    std::vector<double> real{}, imaginary{}; ///< rings x length; imaginary is empty for m = 0
};
/// @param channel  0 to 2; 3: the constant 1 (Spectrum::unit), whose map does not depend on the azimuth where the band limit lies below the
///                 length of the probe's rows: then each ring has one value
OrderMap synthesizeOrder(const Spectrum& spectrum, int channel, int m, std::span<const double> k, const RingSet& rings,
                         const JobControl& job = {});

} // namespace mirrorball
