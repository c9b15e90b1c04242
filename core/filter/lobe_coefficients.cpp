#include "lobe_coefficients.h"

#include <cmath>

// With z = (1 + alpha^2)/(1 - alpha^2) the lobe is k ~ c/(z - c)^2 (LobeShape says why). Its moments follow from those of 1/(z - c):
//   I_l = integral of P_l(c)/(z - c),   J_l = integral of P_l(c)/(z - c)^2 = -dI_l/dz,   K_l = integral of c P_l(c)/(z - c)^2 = z J_l - I_l
// The recurrence of the Legendre polynomials, (l+1) P_(l+1) = (2l+1) c P_l - l P_(l-1), and c = z - (z - c) give
//   (l+1) I_(l+1) = (2l+1) (z I_l - m_l) - l I_(l-1),   m_l = integral of P_l
//   (l+1) J_(l+1) = (2l+1) (z J_l - I_l) - l J_(l-1)
// Whatever is wrong grows upwards like P_l(z), about exp(l acosh z), and shrinks downwards in the same way. Where that is little, they are
// run upwards; else they are solved as a tridiagonal system from I_0 to an I_N = 0 that is far enough above (Olver 1967).

namespace mirrorball {

namespace {

/// Integrals of P_l over [0, 1]: 1, then P_(l-1)(0)/(l+1), which is 0 for even l.
std::vector<double> legendreIntegrals(int last)
{
    std::vector<double> m(static_cast<size_t>(last) + 1, 0.0);
    m[0] = 1.0;
    double atZero = 1.0; // P_(l-1)(0)
    for (int l = 1; l <= last; l += 2) {
        m[static_cast<size_t>(l)] = atZero / (l + 1.0);
        atZero *= -l / (l + 1.0);
    }
    return m;
}

/// Above this ratio alpha is so near to 1 that z J_l and I_l cancel; c/(1 - q c)^2 = sum (j+1) q^j c^(j+1), q = 1/z, converges fast then.
constexpr double seriesBelow = 0.1;
constexpr int seriesTerms = 20; // q^20 < 1e-20

std::vector<double> bySeries(double q, int bandLimit)
{
    std::vector<double> sum(static_cast<size_t>(bandLimit) + 1, 0.0);
    double power = 1.0;
    for (int j = 0; j < seriesTerms; ++j, power *= q) {
        const std::vector<double> k = phongCoefficients(j + 1.0, bandLimit);
        const double weight = (j + 1.0) * power / (j + 2.0); // c^n has the integral 1/(n+1)
        for (size_t l = 0; l < sum.size(); ++l)
            sum[l] += weight * k[l];
    }
    return sum;
}

/// K_l upwards. The recurrences are those of differences, since I_l and I_(l-1) are close where z is.
std::vector<double> upwards(double zMinus1, double i0, double j0, int bandLimit)
{
    const double z = 1.0 + zMinus1;
    const std::vector<double> m = legendreIntegrals(bandLimit);
    std::vector<double> result(static_cast<size_t>(bandLimit) + 1);
    double i = i0, j = j0, stepI = zMinus1 * i0 - 1.0, stepJ = zMinus1 * j0 - i0;
    for (int l = 0; l <= bandLimit; ++l) {
        result[static_cast<size_t>(l)] = z * j - i;
        if (l > 0) {
            stepJ = (l * stepJ + (2.0 * l + 1.0) * (zMinus1 * j - i)) / (l + 1.0);
            stepI = (l * stepI + (2.0 * l + 1.0) * (zMinus1 * i - m[static_cast<size_t>(l)])) / (l + 1.0);
        }
        i += stepI;
        j += stepJ;
    }
    return result;
}

/// Solves -l x_(l-1) + (2l+1) z x_l - (l+1) x_(l+1) = (2l+1) right_l for 0 < l < right.size() - 1, x_0 given and the last x 0.
std::vector<double> solved(double z, double x0, const std::vector<double>& right)
{
    const size_t last = right.size() - 1;
    std::vector<double> x(right.size(), 0.0), above(right.size(), 0.0); // x_l = x[l] + above[l] x_(l+1) while eliminating
    x[0] = x0;
    for (size_t l = 1; l < last; ++l) {
        const double d = static_cast<double>(l);
        const double pivot = 1.0 / ((2.0 * d + 1.0) * z - d * above[l - 1]);
        above[l] = (d + 1.0) * pivot;
        x[l] = (d * x[l - 1] + (2.0 * d + 1.0) * right[l]) * pivot;
    }
    for (size_t l = last - 1; l >= 1; --l)
        x[l] += above[l] * x[l + 1];
    return x;
}

} // namespace

std::vector<double> phongCoefficients(double n, int bandLimit)
{
    std::vector<double> k(static_cast<size_t>(bandLimit) + 1);
    k[0] = 1.0;
    if (bandLimit >= 1)
        k[1] = (n + 1.0) / (n + 2.0);
    for (int l = 2; l <= bandLimit; ++l)
        k[static_cast<size_t>(l)] = k[static_cast<size_t>(l) - 2] * (n - l + 2.0) / (n + l + 1.0);
    return k;
}

std::vector<double> ggxCoefficients(double alpha, int bandLimit)
{
    const double a2 = alpha * alpha, q = (1.0 - a2) / (1.0 + a2);
    std::vector<double> k;
    if (q < seriesBelow) {
        k = bySeries(q, bandLimit);
    } else {
        const double zMinus1 = 2.0 * a2 / (1.0 - a2), z = 1.0 + zMinus1;
        const double i0 = std::log1p(1.0 / zMinus1), j0 = 1.0 / (z * zMinus1);
        const double growth = std::log1p(zMinus1 + std::sqrt(zMinus1 * (zMinus1 + 2.0))); // acosh z
        if (bandLimit * growth < 7.0) {
            k = upwards(zMinus1, i0, j0, bandLimit);
        } else {
            const int last = bandLimit + 2 + static_cast<int>(35.0 / growth); // exp(-35) is 6e-16
            const std::vector<double> i = solved(z, i0, legendreIntegrals(last)), j = solved(z, j0, i);
            for (size_t l = 0; l <= static_cast<size_t>(bandLimit); ++l)
                k.push_back(z * j[l] - i[l]);
        }
    }
    const double k0 = k[0];
    for (double& value : k)
        value /= k0;
    return k;
}

} // namespace mirrorball
