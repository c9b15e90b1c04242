#pragma once

#include "direction.h"
#include "disc.h"
#include "parameterization.h"

#include <cmath>

/// Angular map, the light probe of Debevec: the distance from the center of the disc is the angle from +Z over pi, rho = theta / pi; the
/// rim is -Z. The probe is a picture taken from inside, not a reflection: what is right of +Z in a latlong, -X, is right of it here.
/// (Debevec's page has forward at -Z and +X on the right, which is this with the world turned half a turn about +Y; the sphere map,
/// a reflection, has +X on the right.)
/// Source: P. Debevec, Light Probe Image Gallery: "rotating (0,0,-1) by phi = pi sqrt(u^2+v^2) around y and then by
/// theta = atan2(v, u) around -z".
namespace mirrorball::angular_map {

/// Past the rim theta exceeds pi: the sine turns negative and the direction comes back up the far side.
inline glm::dvec3 directionFromDisc(const glm::dvec2& q)
{
    const double rho = std::sqrt(glm::dot(q, q));
    const double theta = pi * rho;
    const double scale = rho > 0.0 ? std::sin(theta) / rho : pi;
    return {-scale * q.x, scale * q.y, std::cos(theta)};
}

/// Works for d of any length. -Z itself is put at the rim's right end.
inline glm::dvec2 discFromDirection(const glm::dvec3& d)
{
    const double sine = std::sqrt(d.x * d.x + d.y * d.y);
    const double rho = std::atan2(sine, d.z) / pi;
    if (sine > 0.0)
        return {-d.x * (rho / sine), d.y * (rho / sine)};
    return {rho, 0.0};
}

inline glm::dvec3 direction(int n, const glm::dvec2& p) { return directionFromDisc(disc::inscribed(n).fromImage(p)); }

inline glm::dvec2 coordinate(int n, const glm::dvec3& d) { return disc::inscribed(n).toImage(discFromDirection(d)); }

/// d omega / dA = pi sin(theta) / rho in the unit disc; 0 outside.
inline double density(int n, const glm::dvec2& p)
{
    const glm::dvec2 q = disc::inscribed(n).fromImage(p);
    const double rho2 = glm::dot(q, q), texel = 4.0 / (static_cast<double>(n) * n);
    if (rho2 > 1.0)
        return 0.0;
    const double rho = std::sqrt(rho2);
    return texel * pi * (rho > 0.0 ? std::sin(pi * rho) / rho : pi);
}

double solidAngle(int n, const glm::dvec2& min, const glm::dvec2& max);
Texel acrossSeam(int n, int x, int y);

inline constexpr Mapping mapping{
    .kind = Parameterization::Angular,
    .name = "angular",
    .axes = "the distance from the center is the angle from +Z over pi, in radii of the disc; left is +X, top +Y",
    .seen = "a picture from inside: +Z in the middle, +X left of it",
    .charts = Charts::Disc,
    .columns = 1,
    .rows = 1,
    .chartColumns = 1,
    .hasBorder = false,
    .rowsAreAlike = false,
    .oddSizesFold = false,
    .quarterTurns = 4,
    .leastQuarter = 4,
    .longestSide = 2.0 * pi,
    .latlongRows = 1,
    .sheetColumns = 1,
    .sheetRows = 1,
    .sheetCells = {},
    .direction = [](const MapLayout& layout, const glm::dvec2& p) { return direction(layout.size, p); },
    .coordinate = [](const MapLayout& layout, const glm::dvec3& d) { return coordinate(layout.size, d); },
    .density = [](const MapLayout& layout, const glm::dvec2& p) { return density(layout.size, p); },
    .solidAngle = [](const MapLayout& layout, const glm::dvec2& min, const glm::dvec2& max) { return solidAngle(layout.size, min, max); },
    .acrossSeam = [](const MapLayout& layout, Texel, int x, int y) { return acrossSeam(layout.size, x, y); },
};

} // namespace mirrorball::angular_map
