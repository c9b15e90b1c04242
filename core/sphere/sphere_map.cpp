#include "sphere_map.h"

namespace mirrorball::sphere_map {

double solidAngle(int n, const glm::dvec2& min, const glm::dvec2& max)
{
    const disc::Disc d = disc::inscribed(n);
    const glm::dvec2 a = d.fromImage({min.x, max.y}), b = d.fromImage({max.x, min.y});
    const glm::dvec2 far = glm::max(glm::abs(a), glm::abs(b));
    if (glm::dot(far, far) <= 1.0)
        return 4.0 * (b.x - a.x) * (b.y - a.y);
    return disc::solidAngle(a, b, 2.0, [](double h, double t0, double t1) { return 2.0 * h * (t1 - t0); });
}

Texel acrossSeam(int n, int x, int y)
{
    const disc::Disc d = disc::inscribed(n);
    if (d.holdsCenter(x, y))
        return {x, y};
    return d.innerTexel(coordinate(n, direction(n, {x + 0.5, y + 0.5})));
}

} // namespace mirrorball::sphere_map
