#include "octahedral.h"

#include "solid_angle.h"

#include <algorithm>
#include <array>

namespace mirrorball::octahedral {

namespace {

struct Polygon {
    std::array<glm::dvec2, 6> corners{};
    int count = 0;
    void add(const glm::dvec2& corner) { corners[static_cast<size_t>(count++)] = corner; }
};

/// The part of a convex polygon on the side a + b <= 1 (sign 1) or a + b >= 1 (sign -1) of the fold line.
Polygon clipped(const Polygon& polygon, double sign)
{
    Polygon result;
    for (int i = 0; i < polygon.count; ++i) {
        const glm::dvec2 p = polygon.corners[static_cast<size_t>(i)], q = polygon.corners[static_cast<size_t>((i + 1) % polygon.count)];
        const double dp = sign * (1.0 - p.x - p.y), dq = sign * (1.0 - q.x - q.y);
        if (dp >= 0.0)
            result.add(p);
        if ((dp > 0.0 && dq < 0.0) || (dp < 0.0 && dq > 0.0))
            result.add(p + (q - p) * (dp / (dp - dq)));
    }
    return result;
}

/// A convex polygon in the face x, y, z >= 0, given by (a, b) = (x, z), as a fan of plane triangles.
double faceSolidAngle(const Polygon& polygon)
{
    const auto point = [&](int i) {
        const glm::dvec2 c = polygon.corners[static_cast<size_t>(i)];
        return glm::dvec3(c.x, 1.0 - c.x - c.y, c.y);
    };
    double sum = 0.0;
    for (int i = 2; i < polygon.count; ++i)
        sum += std::abs(triangleSolidAngle(point(0), point(i - 1), point(i)));
    return sum;
}

/// A rectangle with 0 <= a0 < a1 <= 1 and likewise b. The fold line a + b = 1 cuts it into a part of the upper face and one of the lower,
/// which is the mirror image (a, b) -> (1 - b, 1 - a) of a part of the upper.
double quadrantSolidAngle(double a0, double a1, double b0, double b1)
{
    if (a0 >= a1 || b0 >= b1)
        return 0.0;
    const auto unfolded = [](Polygon polygon) {
        for (auto& c : polygon.corners)
            c = {1.0 - c.y, 1.0 - c.x};
        return polygon;
    };
    const Polygon rectangle{{{{a0, b0}, {a1, b0}, {a1, b1}, {a0, b1}}}, 4};
    if (a1 + b1 <= 1.0)
        return faceSolidAngle(rectangle);
    if (a0 + b0 >= 1.0)
        return faceSolidAngle(unfolded(rectangle));
    return faceSolidAngle(clipped(rectangle, 1.0)) + faceSolidAngle(unfolded(clipped(rectangle, -1.0)));
}

} // namespace

/// Cut along the fold lines a = 0 and b = 0 first: for odd N they run through texels.
double solidAngle(int n, const glm::dvec2& min, const glm::dvec2& max)
{
    const glm::dvec2 p = min * (2.0 / n) - 1.0, q = max * (2.0 / n) - 1.0;
    const auto band = [&](double b0, double b1) {
        return quadrantSolidAngle(std::max(p.x, 0.0), q.x, b0, b1) + quadrantSolidAngle(std::max(-q.x, 0.0), -p.x, b0, b1);
    };
    return band(std::max(p.y, 0.0), q.y) + band(std::max(-q.y, 0.0), -p.y);
}

Texel acrossSeam(int n, int x, int y)
{
    if (x < 0 || x >= n) {
        x = x < 0 ? -1 - x : 2 * n - 1 - x;
        y = n - 1 - y;
    }
    if (y < 0 || y >= n) {
        y = y < 0 ? -1 - y : 2 * n - 1 - y;
        x = n - 1 - x;
    }
    return {x, y};
}

} // namespace mirrorball::octahedral
