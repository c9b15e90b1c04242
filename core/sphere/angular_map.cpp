#include "angular_map.h"

#include <array>

namespace mirrorball::angular_map {

namespace {

/// Nodes and weights of Gauss-Legendre quadrature on [-1, 1], 12 points (positive half). Source: DLMF table 3.5.4 continued.
constexpr std::array<std::array<double, 2>, 6> gauss12{{{0.1252334085114689, 0.2491470458134028},
                                                        {0.3678314989981802, 0.2334925365383548},
                                                        {0.5873179542866175, 0.2031674267230659},
                                                        {0.7699026741943047, 0.1600783285433462},
                                                        {0.9041172563704749, 0.1069393259953184},
                                                        {0.9815606342467193, 0.0471753363865118}}};

/// (1 - cos(pi rho)) / rho^2 = 2 (sin(pi rho / 2) / rho)^2 is an entire function of rho^2, so twelve points are exact to rounding over
/// an edge of any length in [0, 1]; the test of the sum for N = 1 is the hardest case.
double edge(double h, double t0, double t1)
{
    const double middle = 0.5 * (t0 + t1), half = 0.5 * (t1 - t0);
    const auto integrand = [h](double t) {
        const double rho2 = h * h + t * t;
        const double s = std::sin(0.5 * pi * std::sqrt(rho2));
        return 2.0 * s * s / rho2;
    };
    double sum = 0.0;
    for (const auto& [node, weight] : gauss12)
        sum += weight * (integrand(middle - half * node) + integrand(middle + half * node));
    return sum * half * h;
}

} // namespace

double solidAngle(int n, const glm::dvec2& min, const glm::dvec2& max)
{
    const disc::Disc d = disc::inscribed(n);
    return disc::solidAngle(d.fromImage({min.x, max.y}), d.fromImage({max.x, min.y}), 2.0, edge);
}

Texel acrossSeam(int n, int x, int y)
{
    const disc::Disc d = disc::inscribed(n);
    if (d.holdsCenter(x, y))
        return {x, y};
    return d.innerTexel(coordinate(n, direction(n, {x + 0.5, y + 0.5})));
}

} // namespace mirrorball::angular_map
