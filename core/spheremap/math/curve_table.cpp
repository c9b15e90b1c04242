#include "curve_table.h"

#include <algorithm>
#include <cmath>

namespace mirrorball {

CurveTable::CurveTable(std::vector<CurvePoint> points)
{
    std::stable_sort(points.begin(), points.end(), [](const CurvePoint& a, const CurvePoint& b) { return a.x < b.x; });
    const size_t n = points.size();
    std::vector<double> slope(n - 1), tangent(n);
    for (size_t k = 0; k + 1 < n; ++k)
        slope[k] = (points[k + 1].y - points[k].y) / std::max(points[k + 1].x - points[k].x, 1e-6);
    tangent[0] = slope[0];
    tangent[n - 1] = slope[n - 2];
    for (size_t k = 1; k + 1 < n; ++k)
        tangent[k] = slope[k - 1] * slope[k] <= 0.0 ? 0.0 : 0.5 * (slope[k - 1] + slope[k]);
    for (size_t k = 0; k + 1 < n; ++k) { // tangents within the circle of radius 3 keep the cubic monotone
        const double a = slope[k] == 0.0 ? 0.0 : tangent[k] / slope[k], b = slope[k] == 0.0 ? 0.0 : tangent[k + 1] / slope[k];
        const double length = std::hypot(a, b);
        if (slope[k] == 0.0) {
            tangent[k] = tangent[k + 1] = 0.0;
        } else if (length > 3.0) {
            tangent[k] *= 3.0 / length;
            tangent[k + 1] *= 3.0 / length;
        }
    }
    size_t k = 0;
    for (int i = 0; i <= intervals; ++i) {
        const double x = static_cast<double>(i) / intervals;
        while (k + 2 < n && x > points[k + 1].x)
            ++k;
        const double way = std::max(points[k + 1].x - points[k].x, 1e-6), t = std::clamp((x - points[k].x) / way, 0.0, 1.0);
        const double t2 = t * t, t3 = t2 * t;
        m_entries[static_cast<size_t>(i)] = static_cast<float>((2 * t3 - 3 * t2 + 1) * points[k].y + (t3 - 2 * t2 + t) * way * tangent[k] +
                                                               (3 * t2 - 2 * t3) * points[k + 1].y + (t3 - t2) * way * tangent[k + 1]);
    }
}

} // namespace mirrorball
