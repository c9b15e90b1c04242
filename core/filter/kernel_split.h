#pragma once

#include "lobe.h"

#include <vector>

namespace mirrorball {

/// A ggx lobe as the sum of a near kernel of a short reach and a far one of a short spectrum: neither the few texels under its peak nor the
/// many under its tail, which falls like t^-4, are a reason to sum over all of them, or to follow its spectrum to thousands of degrees.
///
///   k = k G + k (1 - G),   G(x) = a T_n(y) + b T_(n-m)(y),   y = (2x + 1 - c)/(1 + c),   x = cos t,  c = cos(reach)
///
/// Chebyshev's polynomials lie within 1 beyond the reach and grow like cosh(n t) within it, so that G falls from 1 to leftOut() at the
/// reach and stays below it in size beyond: there the near part is left out. Without the horizon k = C x/(z - x)^2 with a double pole z =
/// (1 + alpha^2)/(1 - alpha^2); a and b make 1 - G = 0 there twice, so that k (1 - G) is a polynomial of degree n - 1, whose spectrum ends.
/// The light below the horizon is taken off the far part; its spectrum does not end, but is small, of the size of alpha^2.
///
/// So what is wrong with a sum is, but for that kink, within leftOut() of what the lobe itself gives each texel, whatever the probe holds.
/// Source: the idea of P. P. Ewald, "Die Berechnung optischer und elektrostatischer Gitterpotentiale", Annalen der Physik 369(3), 1921,
/// with the pair of parts that a kernel with a pole and a band limit ask for.
class KernelSplit {
public:
    /// The shortest reach that a band limit allows.
    /// @param lobe  ggx, alpha in (0, 1)
    /// @param leftOut  (0, 0.1]
    KernelSplit(const Lobe& lobe, int bandLimit, double leftOut);

    /// Whether there is anything near: a lobe so wide that its own spectrum is short has nothing.
    bool hasReach() const { return m_reach > 0.0; }
    /// u = 1 - cos t where the near kernel ends.
    double reach() const { return m_reach; }
    double reachAngle() const;
    int bandLimit() const { return m_degree - 1; }
    double leftOut() const { return m_leftOut; }
    const Lobe& lobe() const { return m_lobe; }

    /// G, of u = 1 - cos t in [0, 2].
    double share(double u) const;
    /// The far kernel's Legendre coefficients, 0 .. last. Those beyond the band limit are the horizon's kink.
    std::vector<double> farCoefficients(int last) const;
    static constexpr size_t mostPolynomialTerms = 16, fewPolynomialTerms = 10;
    static constexpr double polynomialShare = 0.02; ///< of leftOut(), which the polynomial may be off by
    /// G over [0, reach] as a polynomial in 1 - 2 u/reach, lowest power first: of 10 terms where that is within its share of leftOut(),
    /// else of 16, to about 1e-8.
    std::vector<double> sharePolynomial() const;

private:
    double unclipped(double u) const; ///< k without the horizon

    Lobe m_lobe;
    double m_integral;
    int m_degree, m_lowerDegree; ///< n and n - m
    double m_leftOut, m_reach = 0.0;
    double m_rise = 0.0; ///< acosh y at the pole
    double m_a = 0.0, m_b = 0.0;
};

/// What sums of near and far over the lobe's angles differ from it by at most, relative to it: leftOut() beyond the reach and nothing
/// within, but for the kink. Looked at where it would show if the coefficients were not the lobe's.
double largestMiss(const KernelSplit& split, const std::vector<double>& farCoefficients);

} // namespace mirrorball
