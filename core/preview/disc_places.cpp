#include "disc_places.h"

#include <cmath>

namespace mirrorball::preview {

namespace {
/// Neighboring pixels whose places are farther apart than this lie on either side of an outline.
constexpr double outline = 0.3;
} // namespace

std::optional<glm::dvec2> DiscPlaces::at(double x, double y) const
{
    const auto read = [this](int column, int row) -> std::optional<glm::dvec2> {
        if (column < 0 || row < 0 || column >= places.width || row >= places.height)
            return std::nullopt;
        const float* place = places.texel(column, row);
        return place[0] == noPlace ? std::nullopt : std::optional(glm::dvec2(place[0], place[1]));
    };
    if (!(std::abs(x) < 1e6 && std::abs(y) < 1e6))
        return std::nullopt;
    const std::optional<glm::dvec2> nearest = read(static_cast<int>(std::floor(x)), static_cast<int>(std::floor(y)));
    if (!nearest)
        return std::nullopt;
    const double left = std::floor(x - 0.5), top = std::floor(y - 0.5);
    const double across = x - 0.5 - left, down = y - 0.5 - top;
    glm::dvec2 sum(0.0);
    double weights = 0.0;
    for (int corner = 0; corner < 4; ++corner) {
        const int dx = corner & 1, dy = corner >> 1;
        const auto place = read(static_cast<int>(left) + dx, static_cast<int>(top) + dy);
        if (!place || glm::distance(*place, *nearest) > outline)
            continue;
        const double weight = (dx ? across : 1.0 - across) * (dy ? down : 1.0 - down);
        sum += weight * *place;
        weights += weight;
    }
    return sum / weights; // the nearest has at least a quarter
}

} // namespace mirrorball::preview
