#include "dual_paraboloid.h"

namespace mirrorball::dual_paraboloid {

namespace {

/// Integral of 2h / (1 + h^2 + t^2): with c^2 = 1 + h^2, (2h/c) (atan(t1/c) - atan(t0/c)), the difference taken by one atan2.
double edge(double h, double t0, double t1)
{
    const double c2 = 1.0 + h * h, c = std::sqrt(c2);
    return 2.0 * h / c * std::atan2((t1 - t0) * c, c2 + t0 * t1);
}

} // namespace

double solidAngle(int n, int border, const glm::dvec2& min, const glm::dvec2& max)
{
    const disc::Disc d = half(n, border, 0.5 * (min.x + max.x) >= n);
    return disc::solidAngle(d.fromImage({min.x, max.y}), d.fromImage({max.x, min.y}), 1.0, edge);
}

Texel acrossSeam(int n, int border, Texel chart, int x, int y)
{
    const bool back = chart.x >= n;
    const disc::Disc here = half(n, border, back);
    if (here.holdsCenter(x, y))
        return {x, y};
    // The same point of the sphere seen from the other half: inversion in the unit circle.
    const glm::dvec2 q = here.fromImage({x + 0.5, y + 0.5});
    const disc::Disc there = half(n, border, !back);
    return there.innerTexel(there.toImage(q / glm::dot(q, q)));
}

} // namespace mirrorball::dual_paraboloid
