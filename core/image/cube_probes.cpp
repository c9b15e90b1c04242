#include "cube_probes.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace mirrorball {

namespace {

using glm::dvec2;
using glm::dvec3;

/// A face of the cube as an observer at its center sees it.
struct Face {
    dvec3 forward, right, up;
};

/// +X -X +Y -Y +Z -Z; right = forward x up, the handedness of space.
const std::array<Face, 6> faces = [] {
    const std::array<std::array<dvec3, 2>, 6> forwardUp{{{dvec3(1, 0, 0), dvec3(0, 1, 0)},
                                                         {dvec3(-1, 0, 0), dvec3(0, 1, 0)},
                                                         {dvec3(0, 1, 0), dvec3(0, 0, -1)},
                                                         {dvec3(0, -1, 0), dvec3(0, 0, 1)},
                                                         {dvec3(0, 0, 1), dvec3(0, 1, 0)},
                                                         {dvec3(0, 0, -1), dvec3(0, 1, 0)}}};
    std::array<Face, 6> result;
    for (size_t i = 0; i < 6; ++i)
        result[i] = {forwardUp[i][0], glm::cross(forwardUp[i][0], forwardUp[i][1]), forwardUp[i][1]};
    return result;
}();

/// The face that d points at: 0 .. 5 for +X -X +Y -Y +Z -Z.
int faceOf(const dvec3& d)
{
    const dvec3 a = glm::abs(d);
    const int axis = a.x >= a.y && a.x >= a.z ? 0 : a.y >= a.z ? 1 : 2;
    return 2 * axis + (d[axis] < 0.0 ? 1 : 0);
}

/// Where d meets the face, right and up, each in [-1, 1].
dvec2 onFace(const Face& face, const dvec3& d) { return dvec2(glm::dot(d, face.right), glm::dot(d, face.up)) / glm::dot(d, face.forward); }

/// 1 + amount or 1 - amount on the squares of an 8 x 8 board.
double checker(const dvec2& p, double amount)
{
    const int square = static_cast<int>(std::floor(4.0 * p.x)) + static_cast<int>(std::floor(4.0 * p.y));
    return square % 2 == 0 ? 1.0 + amount : 1.0 - amount;
}

/// Squared distance from p to the segment ab.
double toSegment(const dvec2& p, const dvec2& a, const dvec2& b)
{
    const dvec2 ab = b - a;
    const double t = std::clamp(glm::dot(p - a, ab) / glm::dot(ab, ab), 0.0, 1.0);
    const dvec2 gap = p - a - t * ab;
    return glm::dot(gap, gap);
}

/// Distance from p to the strokes of an axis name ("+X" ... "-Z") of height 1, centered at the origin: the sign stands left of the
/// letter, so a mirrored name is wrong at once even though X and Y mirror into themselves. The strokes lie in |x| < 0.8, |y| <= 0.5.
double toAxisName(const dvec2& p, int axis)
{
    const auto stroke = [&](double x0, double y0, double x1, double y1) { return toSegment(p, {x0, y0}, {x1, y1}); };
    double squared = stroke(-0.78, 0.0, -0.26, 0.0);
    if (axis % 2 == 0)
        squared = std::min(squared, stroke(-0.52, -0.26, -0.52, 0.26));
    constexpr double left = 0.02, right = 0.72, center = 0.37;
    switch (axis / 2) {
    case 0:
        squared = std::min({squared, stroke(left, 0.5, right, -0.5), stroke(left, -0.5, right, 0.5)});
        break;
    case 1:
        squared =
            std::min({squared, stroke(left, 0.5, center, 0.02), stroke(right, 0.5, center, 0.02), stroke(center, 0.02, center, -0.5)});
        break;
    default:
        squared = std::min({squared, stroke(left, 0.5, right, 0.5), stroke(right, 0.5, left, -0.5), stroke(left, -0.5, right, -0.5)});
    }
    return std::sqrt(squared);
}

} // namespace

dvec3 cubeRoomRadiance(const dvec3& d)
{
    // Red, green, white, violet, yellow, blue, with luminances 0.16 0.28 0.87 0.05 0.50 0.09.
    static constexpr std::array<dvec3, 6> walls{dvec3(0.58, 0.045, 0.06), dvec3(0.06, 0.36, 0.08), dvec3(0.88, 0.87, 0.82),
                                                dvec3(0.12, 0.02, 0.14),  dvec3(0.72, 0.48, 0.03), dvec3(0.03, 0.07, 0.45)};
    const int face = faceOf(d);
    const dvec2 p = onFace(faces[static_cast<size_t>(face)], d);
    constexpr double line = 0.018; // half the width of the dark line that two walls share
    if (std::max(std::abs(p.x), std::abs(p.y)) > 1.0 - line)
        return dvec3(0.012);
    return walls[static_cast<size_t>(face)] * checker(p, 0.11);
}

dvec3 axesRadiance(const dvec3& d)
{
    static constexpr std::array<dvec3, 6> colors{dvec3(0.62, 0.05, 0.04), dvec3(0.04, 0.42, 0.46), dvec3(0.10, 0.40, 0.06),
                                                 dvec3(0.46, 0.06, 0.36), dvec3(0.05, 0.11, 0.62), dvec3(0.72, 0.50, 0.04)};
    const dvec3 white(0.95), ink(0.012);
    const int index = faceOf(d);
    const Face& face = faces[static_cast<size_t>(index)];
    const dvec2 p = onFace(face, d);
    const double edge = std::max(std::abs(p.x), std::abs(p.y));
    if (edge > 0.985)
        return ink;
    if (p.x + p.y > 1.72)
        return p.x + p.y > 1.75 ? white : ink;

    // Signed distances to all that is drawn in white; each drawing has a dark outline of its own.
    double distance = 1.0, outline = 0.030;
    if (std::abs(p.x) < 0.70 && std::abs(p.y) < 0.47) // the big name
        distance = toAxisName(p / 0.74, index) * 0.74 - 0.055;
    if (std::abs(p.x) < 0.12 && p.y > 0.46 && p.y < 0.74) { // the arrow to the upper edge
        const double squared = std::min(
            {toSegment(p, {0.0, 0.50}, {0.0, 0.70}), toSegment(p, {0.0, 0.70}, {-0.08, 0.60}), toSegment(p, {0.0, 0.70}, {0.08, 0.60})});
        const double arrow = std::sqrt(squared) - 0.018;
        if (arrow < distance) {
            distance = arrow;
            outline = 0.016;
        }
    }
    if (edge > 0.66) { // the neighbor's name inside each edge
        const bool sideways = std::abs(p.x) > std::abs(p.y);
        const dvec3 neighbor = sideways ? face.right * (p.x < 0 ? -1.0 : 1.0) : face.up * (p.y < 0 ? -1.0 : 1.0);
        const dvec2 place = sideways ? dvec2(p.x < 0 ? -0.84 : 0.84, 0.0) : dvec2(0.0, p.y < 0 ? -0.87 : 0.87);
        if (std::abs(p.x - place.x) < 0.14 && std::abs(p.y - place.y) < 0.10) {
            const double small = toAxisName((p - place) / 0.14, faceOf(neighbor)) * 0.14 - 0.013;
            if (small < distance) {
                distance = small;
                outline = 0.012;
            }
        }
    }
    if (distance < 0.0)
        return white;
    if (distance < outline)
        return ink;
    return colors[static_cast<size_t>(index)] * checker(p, 0.06);
}

} // namespace mirrorball
