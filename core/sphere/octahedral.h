#pragma once

#include "direction.h"
#include "parameterization.h"

#include <cmath>

/// Octahedral map: the sphere projected to |x| + |y| + |z| = 1, its lower half unfolded outwards. Seen from above as on the cube's +Y face:
/// +Y at the center, +X in the middle of the right edge, +Z in the middle of the lower edge, -X left, -Z up, and -Y in all four corners.
/// With a, b in [-1, 1] to the right and down: a = x, b = z of the octahedron point where y >= 0; below,
/// a = (1 - |z|) sign x, b = (1 - |x|) sign z.
/// Source: T. Engelhardt, C. Dachsbacher, Octahedron Environment Maps, VMV 2008; Z. Cigolle et al., JCGT 3(2), 2014.
namespace mirrorball::octahedral {

/// Point on the octahedron. Over an edge of the square the map continues mirrored in that edge's middle: (a, b) -> (2 - a, -b).
inline glm::dvec3 octahedronPoint(double a, double b)
{
    if (std::abs(a) > 1.0) {
        a = std::copysign(2.0, a) - a;
        b = -b;
    }
    if (std::abs(b) > 1.0) {
        b = std::copysign(2.0, b) - b;
        a = -a;
    }
    const double y = 1.0 - std::abs(a) - std::abs(b);
    return y >= 0.0 ? glm::dvec3(a, y, b) : glm::dvec3(std::copysign(1.0 - std::abs(b), a), y, std::copysign(1.0 - std::abs(a), b));
}

inline glm::dvec3 direction(int n, const glm::dvec2& p)
{
    return glm::normalize(octahedronPoint(2.0 * p.x / n - 1.0, 2.0 * p.y / n - 1.0));
}

/// Works for d of any length.
inline glm::dvec2 coordinate(int n, const glm::dvec3& d)
{
    const double sum = std::abs(d.x) + std::abs(d.y) + std::abs(d.z);
    double a = d.x / sum, b = d.z / sum;
    if (d.y < 0.0) {
        const double folded = std::copysign(1.0 - std::abs(b), a);
        b = std::copysign(1.0 - std::abs(a), b);
        a = folded;
    }
    return {0.5 * n * (a + 1.0), 0.5 * n * (b + 1.0)};
}

/// d omega / dA = 1 / |v|^3 with v the point on the octahedron: its plane lies 1/sqrt(3) away and is sqrt(3) as large as the square.
inline double density(int n, const glm::dvec2& p)
{
    const glm::dvec3 v = octahedronPoint(2.0 * p.x / n - 1.0, 2.0 * p.y / n - 1.0);
    const double r2 = glm::dot(v, v);
    return 4.0 / (static_cast<double>(n) * n * r2 * std::sqrt(r2));
}

double solidAngle(int n, const glm::dvec2& min, const glm::dvec2& max);
Texel acrossSeam(int n, int x, int y);

inline constexpr Mapping mapping{
    .kind = Parameterization::Octahedral,
    .name = "octahedral",
    .axes = "+Y at the center, -Y at the corners; right is +X and down +Z",
    .seen = "+Y in the middle, +X right",
    .charts = Charts::Whole,
    .columns = 1,
    .rows = 1,
    .chartColumns = 1,
    .hasBorder = false,
    .rowsAreAlike = false,
    .oddSizesFold = true,
    .quarterTurns = 2,
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

} // namespace mirrorball::octahedral
