#pragma once

#include <functional>
#include <span>
#include <vector>

namespace mirrorball {

/// Legendre coefficients of a kernel about an axis, 0 .. last, by Gauss-Legendre quadrature over the angle from it:
///   k_l = 2 pi * integral of k(t) P_l(cos t) sin t dt
/// @param ends  ascending angles in [0, pi]; between each two k is smooth, below the first and beyond the last it is 0
/// @param degree  of the fastest harmonic that k itself has
/// @param k  of the angle and its cosine
std::vector<double> zonalCoefficients(std::span<const double> ends, int degree, int last,
                                      const std::function<double(double angle, double cosine)>& k);

} // namespace mirrorball
