#pragma once

#include "direction.h"
#include "parameterization.h"

#include <algorithm>
#include <array>
#include <cmath>

/// Cube map: faces +X -X +Y -Y +Z -Z stacked from the top in an image of N x 6N, each with the axes of OpenGL 4.5 table 8.19:
///   face   s     t     (image right, image down)        s = (sc/|ma| + 1)/2, t = (tc/|ma| + 1)/2, row 0 is t = 0
///   +X    -z    -y
///   -X    +z    -y
///   +Y    +x    +z
///   -Y    +x    -z
///   +Z    +x    -y
///   -Z    -x    -y
namespace mirrorball::cube_map {

/// Point on the cube [-1, 1]^3 of a face position; s and t in [-1, 1] on the face, beyond it they continue its plane.
inline glm::dvec3 facePoint(int face, double s, double t)
{
    switch (face) {
    case 0:
        return {1.0, -t, -s};
    case 1:
        return {-1.0, -t, s};
    case 2:
        return {s, 1.0, t};
    case 3:
        return {s, -1.0, -t};
    case 4:
        return {s, -t, 1.0};
    default:
        return {-s, -t, -1.0};
    }
}

struct FacePosition {
    int face = 0;
    double s = 0.0; ///< [-1, 1]
    double t = 0.0; ///< [-1, 1]
};

/// The face that d points at, and where. d of any length; on an edge the first of x, y, z wins.
inline FacePosition facePosition(const glm::dvec3& d)
{
    const glm::dvec3 a = glm::abs(d);
    if (a.x >= a.y && a.x >= a.z)
        return d.x >= 0.0 ? FacePosition{0, -d.z / a.x, -d.y / a.x} : FacePosition{1, d.z / a.x, -d.y / a.x};
    if (a.y >= a.z)
        return d.y >= 0.0 ? FacePosition{2, d.x / a.y, d.z / a.y} : FacePosition{3, d.x / a.y, -d.z / a.y};
    return d.z >= 0.0 ? FacePosition{4, d.x / a.z, -d.y / a.z} : FacePosition{5, -d.x / a.z, -d.y / a.z};
}

inline FacePosition facePosition(int n, const glm::dvec2& p)
{
    const int face = std::clamp(static_cast<int>(p.y / n), 0, 5);
    return {face, 2.0 * p.x / n - 1.0, 2.0 * (p.y - static_cast<double>(face) * n) / n - 1.0};
}

inline glm::dvec3 direction(int n, const glm::dvec2& p)
{
    const FacePosition at = facePosition(n, p);
    return glm::normalize(facePoint(at.face, at.s, at.t));
}

/// The lower edge of a face is the upper edge of the next one in the image; a direction exactly on it stays the last number below.
inline glm::dvec2 coordinate(int n, const glm::dvec3& d)
{
    const FacePosition at = facePosition(d);
    const double top = static_cast<double>(at.face) * n;
    return {0.5 * n * (at.s + 1.0), std::min(top + 0.5 * n * (at.t + 1.0), (top + n) * (1.0 - 0x1p-53))};
}

/// d omega / dA = (2/N)^2 (1 + s^2 + t^2)^(-3/2), in steradians per texel.
inline double density(int n, const glm::dvec2& p)
{
    const FacePosition at = facePosition(n, p);
    const double r2 = 1.0 + at.s * at.s + at.t * at.t;
    return 4.0 / (static_cast<double>(n) * n * r2 * std::sqrt(r2));
}

/// A rectangle inside one face, as two plane triangles: closed form without cancellation. (The usual difference of four
/// atan2(st, sqrt(s^2 + t^2 + 1)) is the same number with an absolute error of 1e-16, which is 1e-9 of a texel of a 4k face.)
double solidAngle(int n, const glm::dvec2& min, const glm::dvec2& max);

/// The neighbor is found by folding the step over the edge it crosses, first over s, then over t. Beyond a corner, where only three
/// faces meet, that ends on the face across t: a texel that exists and is as far from the corner as the step went.
Texel acrossSeam(int n, Texel chart, int x, int y);

/// How people look at it: a cross of 4N x 3N. OpenGL's face axes meet along these edges as they are, so no face is turned.
///
///          +Y
///      -X  +Z  +X  -Z
///          -Y
inline constexpr std::array<SheetCell, 6> cross{{{2, 1}, {0, 1}, {1, 0}, {1, 2}, {1, 1}, {3, 1}}}; ///< of +X -X +Y -Y +Z -Z

inline constexpr Mapping mapping{
    .kind = Parameterization::Cube,
    .name = "cube",
    .axes = "faces +X -X +Y -Y +Z -Z, each with OpenGL's face axes (OpenGL 4.5, table 8.19)",
    .seen = "faces as OpenGL draws them",
    .charts = Charts::Faces,
    .columns = 1,
    .rows = 6,
    .chartColumns = 1,
    .hasBorder = false,
    .rowsAreAlike = false,
    .oddSizesFold = false,
    .quarterTurns = 1,
    .leastQuarter = 1,
    .longestSide = 0.0,
    .latlongRows = 3,
    .sheetColumns = 4,
    .sheetRows = 3,
    .sheetCells = cross,
    .direction = [](const MapLayout& layout, const glm::dvec2& p) { return direction(layout.size, p); },
    .coordinate = [](const MapLayout& layout, const glm::dvec3& d) { return coordinate(layout.size, d); },
    .density = [](const MapLayout& layout, const glm::dvec2& p) { return density(layout.size, p); },
    .solidAngle = [](const MapLayout& layout, const glm::dvec2& min, const glm::dvec2& max) { return solidAngle(layout.size, min, max); },
    .acrossSeam = [](const MapLayout& layout, Texel chart, int x, int y) { return acrossSeam(layout.size, chart, x, y); },
};

} // namespace mirrorball::cube_map
