#include "kernel_split.h"

#include "zonal_quadrature.h"

#include "core/sphere/direction.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace mirrorball {

namespace {

/// The two terms of G when acosh y at the pole is `rise`.
struct Terms {
    int lowerDegree;
    double a, b;    ///< of T_n(y)/T_n(y_z) and of T_(n-m)(y)/T_(n-m)(y_z)
    double leftOut; ///< |G| where |y| <= 1

    Terms(int degree, double rise)
    {
        // m = 1/rise makes leftOut smallest: it is e^(m rise)/m times what does not depend on m.
        const int m = std::clamp(static_cast<int>(std::lround(1.0 / rise)), 1, std::max(1, degree / 2));
        lowerDegree = degree - m;
        // G = 1 and G' = 0 at the pole, with (ln T_n)' = n tanh(n rise)/sinh(rise).
        const double slope = degree * std::tanh(degree * rise), lowerSlope = lowerDegree * std::tanh(lowerDegree * rise);
        a = -lowerSlope / (slope - lowerSlope);
        b = 1.0 - a;
        leftOut = std::abs(a) / std::cosh(degree * rise) + std::abs(b) / std::cosh(lowerDegree * rise);
    }
};

double riseFor(int degree, double leftOut)
{
    double low = 1.0 / degree, high = 80.0 / degree; // cosh stays a double
    for (int i = 0; i < 40; ++i) {
        const double middle = 0.5 * (low + high);
        (Terms(degree, middle).leftOut > leftOut ? low : high) = middle;
    }
    return high;
}

double oneMinusCosine(double angle) { return 2.0 * std::pow(std::sin(0.5 * angle), 2); }

} // namespace

KernelSplit::KernelSplit(const Lobe& lobe, int bandLimit, double leftOut)
    : m_lobe(lobe), m_integral(LobeShape(lobe).integral()), m_degree(bandLimit + 1), m_rise(riseFor(m_degree, leftOut))
{
    const Terms terms(m_degree, m_rise);
    m_lowerDegree = terms.lowerDegree;
    m_a = terms.a;
    m_b = terms.b;
    m_leftOut = terms.leftOut;
    // cosh(rise) - 1 = y - 1 at the pole = 2 (reach + beyond)/(2 - reach), beyond = z - 1
    const double rise = 2.0 * std::pow(std::sinh(0.5 * m_rise), 2), alpha2 = lobe.alpha * lobe.alpha,
                 beyond = 2.0 * alpha2 / (1.0 - alpha2);
    m_reach = std::max(0.0, 2.0 * (rise - beyond) / (2.0 + rise));
}

double KernelSplit::reachAngle() const { return 2.0 * std::asin(std::sqrt(0.5 * m_reach)); }

double KernelSplit::share(double u) const
{
    const double half = (m_reach - u) / (2.0 - m_reach); // (y - 1)/2
    const double angle = half >= 0.0 ? 2.0 * std::asinh(std::sqrt(half)) : 2.0 * std::asin(std::sqrt(std::min(1.0, -half)));
    const auto chebyshev = [&](int n) { return (half >= 0.0 ? std::cosh(n * angle) : std::cos(n * angle)) / std::cosh(n * m_rise); };
    return m_a * chebyshev(m_degree) + m_b * chebyshev(m_lowerDegree);
}

double KernelSplit::unclipped(double u) const
{
    const double a2 = m_lobe.alpha * m_lobe.alpha, ratio = a2 / (a2 + 0.5 * (1.0 - a2) * u);
    return (1.0 - u) * ratio * ratio / m_integral;
}

std::vector<double> KernelSplit::farCoefficients(int last) const
{
    return zonalCoefficients(std::array{0.0, pi / 2, pi}, bandLimit(), last, [this](double angle, double x) {
        const double u = oneMinusCosine(angle), k = unclipped(u);
        return (x > 0.0 ? k : 0.0) - k * share(u);
    });
}

std::vector<double> KernelSplit::sharePolynomial() const
{
    // Interpolated at Chebyshev's nodes, then written in powers: G is at most about 1 on the whole circle |x| = 1, and so are those.
    constexpr size_t n = mostPolynomialTerms;
    std::array<double, n> series{};
    for (size_t node = 0; node < n; ++node) {
        const double angle = pi * (static_cast<double>(node) + 0.5) / n, value = share(0.5 * m_reach * (1.0 - std::cos(angle)));
        for (size_t j = 0; j < n; ++j)
            series[j] += (j == 0 ? 1.0 : 2.0) / n * value * std::cos(static_cast<double>(j) * angle);
    }
    // A short series where what it leaves out is far below what the split itself leaves out.
    double rest = 0.0;
    for (size_t j = fewPolynomialTerms; j < n; ++j)
        rest += std::abs(series[j]);
    const size_t terms = rest <= polynomialShare * m_leftOut ? fewPolynomialTerms : n;
    std::vector<double> powers(terms, 0.0), before(terms, 0.0), now(terms, 0.0);
    now[0] = 1.0; // T_0, and T_(-1) = T_1 = x
    before[1] = 1.0;
    for (size_t j = 0; j < terms; ++j) {
        for (size_t i = 0; i < terms; ++i)
            powers[i] += series[j] * now[i];
        std::vector<double> next(terms, 0.0);
        for (size_t i = 0; i < terms; ++i)
            next[i] = (i > 0 ? 2.0 * now[i - 1] : 0.0) - before[i];
        before = std::exchange(now, next);
    }
    return powers;
}

double largestMiss(const KernelSplit& split, const std::vector<double>& farCoefficients)
{
    // As far from the axis as the kernel is so large that the kink does not count.
    constexpr int places = 48;
    constexpr double farthest = 0.2;
    const LobeShape shape(split.lobe());
    const double reach = split.reachAngle();
    double largest = 0.0;
    for (int i = 0; i < places; ++i) {
        const double angle = std::min(farthest, 3.0 * reach) * (i + 0.5) / places, u = oneMinusCosine(angle), x = std::cos(angle);
        double far = 0.0, previous = 0.0, p = 1.0;
        for (int l = 0; l <= std::min(split.bandLimit(), static_cast<int>(farCoefficients.size()) - 1); ++l) {
            far += (2.0 * l + 1.0) / (4.0 * pi) * farCoefficients[static_cast<size_t>(l)] * p;
            previous = std::exchange(p, ((2.0 * l + 1.0) * x * p - l * previous) / (l + 1.0));
        }
        const double k = shape.relative(x) / shape.integral();
        largest = std::max(largest, std::abs(far + (u < split.reach() ? k * split.share(u) : 0.0) - k) / k);
    }
    return largest;
}

} // namespace mirrorball
