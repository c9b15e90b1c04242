#pragma once

#include "direction.h"
#include "parameterization.h"

#include <algorithm>
#include <cmath>

/// Latitude and longitude on a 2N x N image: lon = pi - 2 pi u, lat = pi/2 - pi v. The center of the image is +Z, its left quarter
/// +X, its top edge +Y. Longitude is periodic, and a row above the pole is the row below it half a turn on: the formulas
/// continue past the edges by themselves.
namespace mirrorball::latlong {

inline glm::dvec3 direction(int n, const glm::dvec2& p)
{
    const double texel = pi / n;
    return directionFromLonLat(pi - texel * p.x, 0.5 * pi - texel * p.y);
}

/// Works for d of any length. Both angles come from atan2, so nothing cancels at the poles.
inline glm::dvec2 coordinate(int n, const glm::dvec3& d)
{
    const double texels = n / pi;
    const double lon = std::atan2(d.x, d.z);
    const double lat = std::atan2(d.y, std::sqrt(d.x * d.x + d.z * d.z));
    return {std::clamp((pi - lon) * texels, 0.0, 2.0 * n), std::clamp((0.5 * pi - lat) * texels, 0.0, 1.0 * n)}; // rounding stays inside
}

/// d omega / dA = (pi/N)^2 cos lat, in steradians per texel.
inline double density(int n, const glm::dvec2& p)
{
    const double texel = pi / n;
    return texel * texel * std::abs(std::sin(texel * p.y));
}

/// Integral of cos lat: the width in longitude times the difference of sin lat, written as a product so that it keeps its precision
/// in the smallest texels at the poles.
inline double solidAngle(int n, const glm::dvec2& min, const glm::dvec2& max)
{
    const double texel = pi / n;
    const double middle = 0.5 * (min.y + max.y);
    return texel * (max.x - min.x) * 2.0 * std::sin(texel * std::min(middle, n - middle)) * std::sin(0.5 * texel * (max.y - min.y));
}

Texel acrossSeam(int n, int x, int y);

inline constexpr Mapping mapping{
    .kind = Parameterization::Latlong,
    .name = "latlong",
    .axes = "the center is +Z, the left quarter +X, the top +Y; d = (sin(lon) cos(lat), sin(lat), cos(lon) cos(lat)), lon = pi - 2 pi "
            "u, lat = pi/2 - pi v; texel centers at (i + 1/2)/N",
    .seen = "a picture from inside: +Z in the middle, +X left of it",
    .charts = Charts::Whole,
    .columns = 2,
    .rows = 1,
    .chartColumns = 2,
    .hasBorder = false,
    .rowsAreAlike = true,
    .oddSizesFold = false,
    .quarterTurns = 2,
    .leastQuarter = 2,
    .longestSide = pi,
    .latlongRows = 1,
    .sheetColumns = 2,
    .sheetRows = 1,
    .sheetCells = {},
    .direction = [](const MapLayout& layout, const glm::dvec2& p) { return direction(layout.size, p); },
    .coordinate = [](const MapLayout& layout, const glm::dvec3& d) { return coordinate(layout.size, d); },
    .density = [](const MapLayout& layout, const glm::dvec2& p) { return density(layout.size, p); },
    .solidAngle = [](const MapLayout& layout, const glm::dvec2& min, const glm::dvec2& max) { return solidAngle(layout.size, min, max); },
    .acrossSeam = [](const MapLayout& layout, Texel, int x, int y) { return acrossSeam(layout.size, x, y); },
};

} // namespace mirrorball::latlong
