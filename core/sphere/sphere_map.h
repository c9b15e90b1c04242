#pragma once

#include "direction.h"
#include "disc.h"
#include "parameterization.h"

#include <cmath>

/// GL_SPHERE_MAP (OpenGL 2.1 section 2.11.4): (s, t) = r.xy / (2 sqrt(rx^2 + ry^2 + (rz+1)^2)) + 1/2, s to the right and t up. It is what
/// an orthographic camera on +Z sees in a mirror ball: q is the ball's normal there, r the mirror direction of +Z. The center is +Z,
/// image right is +X, the top +Y, and the whole rim is the one direction -Z.
///
/// For unit r the radius is rho = |r.xy| / sqrt(2 (1 + rz)) = sin(theta/2), so 1 - cos theta = 2 rho^2 and d omega = 4 dA: equal area.
namespace mirrorball::sphere_map {

inline glm::dvec3 directionFromDisc(glm::dvec2 q)
{
    double rho2 = glm::dot(q, q);
    if (rho2 > 1.0) { // through the rim and back up the far side: rho and 2 - rho are as far from -Z, on opposite sides of it
        const double rho = std::sqrt(rho2);
        double folded = std::remainder(rho, 4.0);
        if (std::abs(folded) > 1.0)
            folded -= std::copysign(2.0, folded);
        q *= folded / rho;
        rho2 = std::min(folded * folded, 1.0);
    }
    const double c = std::sqrt(1.0 - rho2);
    return {2.0 * c * q.x, 2.0 * c * q.y, 1.0 - 2.0 * rho2};
}

/// In the back half 1 + rz is written (rx^2 + ry^2) / (1 - rz), which does not cancel. -Z itself is put at the rim's right end.
inline glm::dvec2 discFromDirection(const glm::dvec3& r)
{
    const glm::dvec2 xy{r.x, r.y};
    if (r.z >= 0.0)
        return xy / std::sqrt(2.0 * (1.0 + r.z));
    const double sine = std::sqrt(r.x * r.x + r.y * r.y);
    return sine > 0.0 ? xy * (std::sqrt(0.5 * (1.0 - r.z)) / sine) : glm::dvec2(1.0, 0.0);
}

inline glm::dvec3 direction(int n, const glm::dvec2& p) { return directionFromDisc(disc::inscribed(n).fromImage(p)); }

inline glm::dvec2 coordinate(int n, const glm::dvec3& r) { return disc::inscribed(n).toImage(discFromDirection(r)); }

/// d omega / dA = 4 in the unit disc, 16 / N^2 a texel; 0 outside.
inline double density(int n, const glm::dvec2& p)
{
    const glm::dvec2 q = disc::inscribed(n).fromImage(p);
    return glm::dot(q, q) <= 1.0 ? 16.0 / (static_cast<double>(n) * n) : 0.0;
}

double solidAngle(int n, const glm::dvec2& min, const glm::dvec2& max);
Texel acrossSeam(int n, int x, int y);

inline constexpr Mapping mapping{
    .kind = Parameterization::Sphere,
    .name = "sphere",
    .axes = "GL_SPHERE_MAP: (s, t) = r.xy / (2 sqrt(rx^2 + ry^2 + (rz + 1)^2)) + 1/2; the center is +Z, right +X, top +Y",
    .seen = "a ball seen from +Z: +X right",
    .charts = Charts::Disc,
    .columns = 1,
    .rows = 1,
    .chartColumns = 1,
    .hasBorder = false,
    .rowsAreAlike = false,
    .oddSizesFold = false,
    .quarterTurns = 4,
    .leastQuarter = 4,
    .longestSide = 0.0,
    .latlongRows = 2,
    .sheetColumns = 1,
    .sheetRows = 1,
    .sheetCells = {},
    .direction = [](const MapLayout& layout, const glm::dvec2& p) { return direction(layout.size, p); },
    .coordinate = [](const MapLayout& layout, const glm::dvec3& d) { return coordinate(layout.size, d); },
    .density = [](const MapLayout& layout, const glm::dvec2& p) { return density(layout.size, p); },
    .solidAngle = [](const MapLayout& layout, const glm::dvec2& min, const glm::dvec2& max) { return solidAngle(layout.size, min, max); },
    .acrossSeam = [](const MapLayout& layout, Texel, int x, int y) { return acrossSeam(layout.size, x, y); },
};

} // namespace mirrorball::sphere_map
