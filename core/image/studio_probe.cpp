#include "studio_probe.h"

#include "core/sphere/direction.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace mirrorball {

namespace {

using glm::dvec2;
using glm::dvec3;

constexpr double rad(double degrees) { return degrees * pi / 180.0; }

double smoothStep(double low, double high, double x)
{
    const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

/// A flat lamp or a black card that faces the object at the origin.
struct Panel {
    dvec3 towards;     ///< unit direction of its center
    double distance;   ///< of its center
    dvec3 right, up;   ///< unit axes of the panel; `right` is horizontal
    dvec2 half;        ///< half its width and height
    double edge;       ///< width of the falloff inside its edge
    double frame;      ///< width of the black frame around it
    dvec3 color;       ///< radiance at the center of the cloth
    double rim;        ///< share of that which is left in the corners
    double flash;      ///< radiance of the tube that shines through the cloth
    double flashWidth; ///< its standard deviation
    double reach;      ///< cosine of the angle about the center beyond which the panel is not seen
};

Panel panel(double lonDeg, double latDeg, double distance, dvec2 half, double edge, double frame, dvec3 color, double rim,
            double flash = 0.0, double flashWidth = 1.0)
{
    const dvec3 towards = directionFromLonLat(rad(lonDeg), rad(latDeg));
    // Horizontal and perpendicular to the line of sight; the overhead panel keeps its longitude's orientation.
    const dvec3 right = directionFromLonLat(rad(lonDeg) - pi / 2, 0.0);
    const dvec3 up = glm::cross(right, towards);
    const double extent = glm::length(half + dvec2(frame));
    return {towards, distance, right, up, half, edge, frame, color, rim, flash, flashWidth, std::cos(std::atan2(extent, distance))};
}

const std::array studioPanels{
    // Key: a large soft box up at the camera's left, its tube glowing through the cloth.
    panel(-46, 38, 3.0, {0.95, 1.15}, 0.06, 0.05, {8.2, 7.9, 7.4}, 0.30, 340.0, 0.055),
    // Strip: a narrow warm-to-neutral line down the camera's right.
    panel(62, 14, 2.8, {0.16, 1.55}, 0.05, 0.03, {15.0, 15.2, 15.6}, 0.45),
    // Overhead box, the long highlight on lids and shoulders.
    panel(170, 72, 2.8, {1.05, 0.42}, 0.08, 0.04, {5.2, 5.3, 5.5}, 0.40),
    // Rim light behind on the right, cool.
    panel(140, 24, 3.0, {0.42, 0.95}, 0.05, 0.03, {8.6, 9.6, 11.0}, 0.35),
    // Fill: a large dim reflector behind on the left, warm.
    panel(-122, 8, 3.0, {0.85, 1.25}, 0.16, 0.02, {1.55, 1.42, 1.25}, 0.55),
    // Black cards, which give metal its dark edges.
    panel(36, 6, 2.8, {0.30, 1.30}, 0.10, 0.0, {0.02, 0.02, 0.02}, 1.0),
    panel(-88, 2, 3.0, {0.24, 1.20}, 0.10, 0.0, {0.02, 0.02, 0.02}, 1.0),
};

/// The room without its lamps: a floor that sweeps up into the wall, a lit backdrop at -Z, a dark ceiling.
dvec3 studioRoom(const dvec3& d)
{
    const double toBackdrop = std::max(-d.z, 0.0);
    const double wall = 0.11 + 0.42 * toBackdrop * toBackdrop * std::exp(-7.0 * (d.y - 0.04) * (d.y - 0.04));
    const double ceiling = 0.035;
    const dvec3 above = glm::mix(wall * dvec3(0.97, 0.99, 1.04), ceiling * dvec3(0.95, 0.98, 1.08), smoothStep(0.05, 0.95, d.y));
    if (d.y >= 0.0)
        return above;
    // The floor lies one unit below the object; the key light pools on it around the object's feet.
    const double h = std::max(-d.y, 0.02);
    const dvec2 p(d.x / h, d.z / h);
    const double pool = 1.0 / (1.0 + 0.16 * glm::dot(p - dvec2(0.5, -0.7), p - dvec2(0.5, -0.7)));
    const double underObject = 1.0 - 0.55 * std::exp(-1.6 * glm::dot(p, p));
    const dvec3 floor = (0.07 + 0.25 * pool) * underObject * dvec3(1.03, 1.0, 0.96);
    return glm::mix(above, floor, smoothStep(0.02, 0.42, -d.y));
}

} // namespace

dvec3 studioRadiance(const dvec3& d)
{
    dvec3 radiance = studioRoom(d);
    for (const Panel& p : studioPanels) {
        const double cosine = glm::dot(d, p.towards);
        if (cosine < p.reach)
            continue;
        // The plane through the center, perpendicular to the line of sight: d reaches it at t d.
        const dvec3 onPlane = d * (p.distance / cosine);
        const dvec2 q(glm::dot(onPlane, p.right), glm::dot(onPlane, p.up));
        const double corner = 0.25 * std::min(p.half.x, p.half.y);
        const dvec2 outside = glm::abs(q) - p.half + corner;
        const double sd = glm::length(glm::max(outside, 0.0)) + std::min(std::max(outside.x, outside.y), 0.0) - corner;
        if (sd >= p.frame)
            continue;
        if (sd >= 0.0) {
            radiance = dvec3(0.012);
            continue;
        }
        const dvec2 s = q / p.half;
        const double cloth = p.rim + (1.0 - p.rim) * std::exp(-1.1 * glm::dot(s, s));
        const double flash = p.flash * std::exp(-0.5 * glm::dot(q, q) / (p.flashWidth * p.flashWidth));
        const double in = smoothStep(0.0, p.edge, -sd);
        const dvec3 lamp = p.color * cloth + flash * dvec3(1.0, 0.97, 0.92);
        radiance = p.frame > 0.0 ? in * lamp : glm::mix(radiance, lamp, in);
    }
    return radiance;
}

} // namespace mirrorball
