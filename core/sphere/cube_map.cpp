#include "cube_map.h"

#include "solid_angle.h"

#include <cstdlib>

namespace mirrorball::cube_map {

double solidAngle(int n, const glm::dvec2& min, const glm::dvec2& max)
{
    const FacePosition at = facePosition(n, 0.5 * (min + max));
    const double scale = 2.0 / n, top = static_cast<double>(at.face) * n;
    const double s0 = min.x * scale - 1.0, s1 = max.x * scale - 1.0;
    const double t0 = (min.y - top) * scale - 1.0, t1 = (max.y - top) * scale - 1.0;
    const glm::dvec3 a{s0, t0, 1.0}, b{s1, t0, 1.0}, c{s1, t1, 1.0}, d{s0, t1, 1.0};
    return triangleSolidAngle(a, b, c) + triangleSolidAngle(a, c, d);
}

Texel acrossSeam(int n, Texel chart, int x, int y)
{
    const int face = std::clamp(chart.y / n, 0, 5);
    // Texel centers in odd integers: on the face |s|, |t| < n, and the face is the plane at n. All steps below are exact.
    int s = 2 * x + 1 - n, t = 2 * (y - face * n) + 1 - n;
    if (std::abs(s) < n && std::abs(t) < n)
        return {x, y};
    // Over an edge the plane bends by a right angle: what overshoots the edge goes off the coordinate that stood at the face's plane.
    int m = n;
    const bool overS = std::abs(s) > n;
    if (overS) {
        m -= std::abs(s) - n;
        s = s > 0 ? n : -n;
    }
    if (std::abs(t) > n) {
        const int overshoot = std::abs(t) - n;
        t = t > 0 ? n : -n;
        if (overS)
            s -= s > 0 ? overshoot : -overshoot;
        else
            m -= overshoot;
    }
    const glm::dvec3 axisM = facePoint(face, 0.0, 0.0), axisS = facePoint(face, 1.0, 0.0) - axisM,
                     axisT = facePoint(face, 0.0, 1.0) - axisM;
    const glm::dvec3 point = static_cast<double>(s) * axisS + static_cast<double>(t) * axisT + static_cast<double>(m) * axisM;
    const FacePosition at = facePosition(point);
    const auto index = [n](double c) { return std::clamp(static_cast<int>(std::floor(0.5 * n * (c + 1.0))), 0, n - 1); };
    return {index(at.s), at.face * n + index(at.t)};
}

} // namespace mirrorball::cube_map
