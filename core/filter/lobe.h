#pragma once

#include <string>
#include <vector>

/// Lobes: radially symmetric kernels k(cos t) about the lookup direction, zero below its horizon, integral 1 over the sphere.
namespace mirrorball {

enum class LobeKind { Phong, Diffuse, Ggx, Tabulated };

/// One lobe. Build it with the functions below, which check the ranges.
///
///   phong(n)    k = (n+1)/(2 pi) max(c, 0)^n                 looked up by reflection   000 eq. 17, normalized; roughness there is 1/n
///   diffuse     k = max(c, 0)/pi                             looked up by normal       000 eq. 15 over pi
///   ggx(alpha)  k ~ D(t/2) max(c, 0), N = V = R              looked up by reflection   split-sum prefilter; alpha = roughness^2
///   tabulated   linear between samples equally spaced in c over [0, 1], scaled to integral 1     looked up by reflection
/// with c = cos t.
struct Lobe {
    LobeKind kind = LobeKind::Phong;
    double exponent = 50.0;        ///< phong: n >= 0
    double alpha = 0.1;            ///< ggx: [0, 1]; 0 is the mirror
    std::vector<double> samples{}; ///< tabulated: k at c = i/(size - 1), at least 2, non-negative, not all 0

    /// A mirror needs no filtering: ggx with alpha = 0, or any lobe so narrow that doubles cannot tell it from one.
    bool isMirror() const;
    bool operator==(const Lobe&) const = default;
};

/// @throws InvalidArgument unless n is finite and >= 0
Lobe phongLobe(double n);
Lobe diffuseLobe();
/// @throws InvalidArgument unless alpha is in [0, 1]
Lobe ggxLobe(double alpha);
/// @throws InvalidArgument for fewer than 2 samples, a negative or non-finite one, or a sum of 0
Lobe tabulatedLobe(std::vector<double> samples);

/// "phong:50", "diffuse", "ggx:0.09": for plans, statistics and reports.
std::string describe(const Lobe& lobe);

/// A lobe made ready for evaluation: k(c)/k(1) for many c. Powers are taken in log space, so no exponent over- or underflows
/// before its value does. A tabulated lobe whose peak lies elsewhere is relative to its largest sample.
class LobeShape {
public:
    explicit LobeShape(const Lobe& lobe);

    /// ln(k(c)/k(1)); -infinity at and below the horizon and where k is 0 (phong with n = 0 is 0 down to the horizon)
    double logRelative(double c) const;
    /// k(c)/k(1), in [0, 1]
    double relative(double c) const;
    /// Integral of relative() over the sphere, in steradians: k = relative/integral. Closed form but for tabulated lobes (exact sums).
    double integral() const { return m_integral; }
    /// Angle from the axis at which k has fallen to half its peak; pi/2 where it never does above the horizon.
    double halfWidth() const;
    /// Smallest angle beyond which relative() stays at or below `level`; pi/2 where it never does above the horizon.
    double support(double level) const;

private:
    Lobe m_lobe;
    double m_integral = 0.0;
    double m_peak = 1.0;
};

/// A lobe is unresolved by a latlong map of this width when its full width at half maximum is under 1.5 texels of the equator:
/// the reference sum would then read single texels, so the filtered map is the bilinear lookup (docs/conventions.md).
bool isUnresolved(const Lobe& lobe, int latlongWidth);

/// The factors of a radial convolution, e_lm = k_l a_lm, for l = 0 .. bandLimit:
///   k_l = 2 pi integral of k(c) P_l(c) over [0, 1];  k_0 = 1
/// Phong and diffuse in closed form, k_l = k_(l-2) (n-l+2)/(n+l+1) with k_1 = (n+1)/(n+2); ggx by its recurrence (lobe_coefficients.h),
/// tabulated ones by Gauss-Legendre quadrature on panels that follow both the peak and the oscillation of P_l (relative error about 1e-13
/// of k_0).
std::vector<double> legendreCoefficients(const Lobe& lobe, int bandLimit);

} // namespace mirrorball
