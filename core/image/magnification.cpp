#include "remap.h"

#include "texel_outline.h"

#include <algorithm>
#include <cmath>

namespace mirrorball {

namespace {

constexpr int magnifiedSteps = 32;

} // namespace

double texelAngle(const MapLayout& layout, const glm::dvec3& d)
{
    if (const double longest = mapping(layout.kind).longestSide; longest > 0.0)
        return longest / layout.size;
    const double omega = density(layout, coordinate(layout, d));
    return omega > 0.0 ? std::sqrt(omega) : 4.0 / layout.size; // outside a disc
}

Magnification magnification(const MapLayout& source, const ReprojectOptions& options)
{
    const MapLayout& target = options.target;
    const TexelOutlines outlines(target, options.yaw, options.turn, MapCharts(source));
    Magnification result{.smallest = 1e9, .largest = 0.0};
    const int step = std::max(1, target.size / magnifiedSteps);
    for (int y = 0; y < target.height(); y += step)
        for (int x = 0; x < target.width(); x += step) {
            const glm::dvec2 p{x + 0.5, y + 0.5};
            const auto along = [&](const glm::dvec2& half) {
                return glm::distance(outlines.directionIn(x, y, p + half), outlines.directionIn(x, y, p)) +
                       glm::distance(outlines.directionIn(x, y, p), outlines.directionIn(x, y, p - half));
            };
            const double ratio = std::max(along({0.5, 0.0}), along({0.0, 0.5})) / texelAngle(source, outlines.directionIn(x, y, p));
            result.smallest = std::min(result.smallest, ratio);
            result.largest = std::max(result.largest, ratio);
        }
    return result;
}

} // namespace mirrorball
