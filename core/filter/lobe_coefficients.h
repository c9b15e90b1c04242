#pragma once

#include <vector>

/// Legendre coefficients of the lobes that have a closed form or a recurrence: k_l = 2 pi integral of k(c) P_l(c) over [0, 1], for
/// l = 0 .. bandLimit, k_0 = 1, in time proportional to bandLimit. legendreCoefficients() in lobe.h chooses among them.
namespace mirrorball {

/// Of max(c, 0)^n: k_1 = (n+1)/(n+2), k_l = k_(l-2) (n-l+2)/(n+l+1).
std::vector<double> phongCoefficients(double n, int bandLimit);

/// Of ggx, to about 1e-12 of k_0. @param alpha  (0, 1]
std::vector<double> ggxCoefficients(double alpha, int bandLimit);

} // namespace mirrorball
