#pragma once

#include "lobe.h"

#include <vector>

namespace mirrorball {

/// A phong lobe of a small, broken exponent as the sum of a near part about its horizon and a far one of a short spectrum: x^n with x = r.d
/// rises from the horizon so steeply that its own spectrum falls only like l^-(n + 3/2), for n below 1/2 hardly faster than that of a step.
///
///   k = k (1 - W(x/w)) + k W(x/w),   W(s) = I_s(5, 5) on [0, 1], 0 before, 1 beyond
///
/// I is the regularized incomplete beta function, here a polynomial of degree 9 whose first four derivatives vanish at either end. So the
/// near part ends at x = w, both are positive, and the far part has n + 5 derivatives at the horizon: from about l = 14/w on its spectrum
/// falls like l^-(n + 6).
class HorizonSplit {
public:
    /// @param lobe  phong, exponent in [0, largestExponent]
    /// @param width  w, (0, 1]
    HorizonSplit(const Lobe& lobe, double width);
    static constexpr double largestExponent = 4.0; ///< beyond it the lobe's own spectrum is short enough

    const Lobe& lobe() const { return m_lobe; }
    double width() const { return m_width; }
    /// 1 - W, of s = x/w.
    static double nearShare(double s);
    /// The same as a polynomial in c = 2 s - 1: 1/2 - c (a_0 + a_1 c^2 + ... + a_4 c^8).
    static constexpr double nearSeries[5] = {315.0 / 256.0, -420.0 / 256.0, 378.0 / 256.0, -180.0 / 256.0, 35.0 / 256.0};

    /// The far part's Legendre coefficients, 0 .. last.
    std::vector<double> farCoefficients(int last) const;

private:
    Lobe m_lobe;
    double m_width;
};

} // namespace mirrorball
