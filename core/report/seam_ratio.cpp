#include "seam_ratio.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace mirrorball {

namespace {

struct Step {
    int dx, dy;
};
constexpr std::array<Step, 4> steps{{{-1, 0}, {1, 0}, {0, -1}, {0, 1}}};

/// Whether a texel belongs to a chart proper: a disc's texels count when their centers lie inside.
bool isIn(const MapLayout& layout, const SolidAngles& solidAngles, Texel chart, int x, int y)
{
    const int chartWidth = layout.chartWidth();
    const int left = chart.x / chartWidth * chartWidth, top = chart.y / layout.size * layout.size;
    if (x < left || x >= left + chartWidth || y < top || y >= top + layout.size)
        return false;
    return solidAngles.at(x, y) > 0.0 && acrossSeam(layout, chart, x, y) == Texel{x, y};
}

} // namespace

double SeamSteps::ratio() const
{
    if (inside > 0.0)
        return across / inside;
    return across > 0.0 ? HUGE_VAL : 0.0;
}

SeamSteps seamSteps(const EnvironmentMap& map)
{
    const MapLayout& layout = map.layout;
    if (layout.size < 2)
        return {};
    const SolidAngles solidAngles(layout);
    double across = 0.0, inside = 0.0;
    int count = 0;
    const auto slope2 = [&](Texel a, Texel b) { // the latlong's texels over a pole, and a rim's over itself, may be the same place
        const glm::dvec3 da = texelDirection(layout, a.x, a.y), db = texelDirection(layout, b.x, b.y);
        const double angle = std::atan2(glm::length(glm::cross(da, db)), glm::dot(da, db));
        double sum = 0.0;
        for (int c = 0; c < 3; ++c) {
            const double step = static_cast<double>(map.image.texel(a.x, a.y)[c]) - map.image.texel(b.x, b.y)[c];
            sum += step * step;
        }
        return angle > 1e-9 ? sum / (angle * angle) : -1.0;
    };
    for (int y = 0; y < map.image.height; ++y)
        for (int x = 0; x < map.image.width; ++x) {
            const Texel own{x, y};
            if (!isIn(layout, solidAngles, own, x, y))
                continue;
            for (const Step& step : steps) {
                if (isIn(layout, solidAngles, own, x + step.dx, y + step.dy) || !isIn(layout, solidAngles, own, x - step.dx, y - step.dy))
                    continue;
                const Texel over = acrossSeam(layout, own, x + step.dx, y + step.dy);
                const double a = slope2(own, over), b = slope2(own, {x - step.dx, y - step.dy});
                if (a < 0.0 || b < 0.0)
                    continue;
                across += a;
                inside += b;
                ++count;
            }
        }
    if (count == 0)
        return {};
    return {.across = std::sqrt(across / (3.0 * count)), .inside = std::sqrt(inside / (3.0 * count))};
}

} // namespace mirrorball
