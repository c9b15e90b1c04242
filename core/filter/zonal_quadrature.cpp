#include "zonal_quadrature.h"

#include "core/base/multiversion.h"
#include "core/shading/reflection_kernel.h"
#include "core/sphere/direction.h"

#include <algorithm>
#include <cmath>

namespace mirrorball {

namespace {

/// sum w P_l, and P_(l+1) in place of P_l.
MIRRORBALL_CLONES double legendreStep(int l, size_t count, const double* x, const double* w, double* previous, double* p)
{
    const double a = (2.0 * l + 1.0) / (l + 1.0), b = l / (l + 1.0);
    constexpr size_t lanes = 8; // sums that do not wait for one another
    double sums[lanes]{};
    for (size_t i = 0; i + lanes <= count; i += lanes)
        for (size_t j = 0; j < lanes; ++j) {
            const double now = p[i + j];
            sums[j] += w[i + j] * now;
            p[i + j] = a * x[i + j] * now - b * previous[i + j];
            previous[i + j] = now;
        }
    return ((sums[0] + sums[4]) + (sums[1] + sums[5])) + ((sums[2] + sums[6]) + (sums[3] + sums[7]));
}

} // namespace

std::vector<double> zonalCoefficients(std::span<const double> ends, int degree, int last,
                                      const std::function<double(double angle, double cosine)>& k)
{
    const GaussLegendre& rule = gaussLegendre16(); // exact to 1e-15 over panels of so many radians of the fastest harmonic
    constexpr double radians = 14.0;
    std::vector<double> x, w;
    for (size_t piece = 0; piece + 1 < ends.size(); ++piece) {
        const double from = ends[piece], length = ends[piece + 1] - from;
        const int panels = std::max(4, static_cast<int>(std::ceil(length * (degree + last) / radians)));
        for (int panel = 0; panel < panels; ++panel)
            for (size_t i = 0; i < rule.nodes.size(); ++i) {
                const double angle = from + length / panels * (panel + 0.5 * (1.0 + rule.nodes[i])), cosine = std::cos(angle);
                x.push_back(cosine);
                w.push_back(2.0 * pi * length / panels * 0.5 * rule.weights[i] * std::sin(angle) * k(angle, cosine));
            }
    }
    std::vector<double> previous(x.size(), 0.0), p(x.size(), 1.0), coefficients(static_cast<size_t>(last) + 1);
    for (int l = 0; l <= last; ++l)
        coefficients[static_cast<size_t>(l)] = legendreStep(l, x.size(), x.data(), w.data(), previous.data(), p.data());
    return coefficients;
}

} // namespace mirrorball
