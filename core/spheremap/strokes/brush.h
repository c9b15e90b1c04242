#pragma once

#include "core/base/fields.h"

#include <glm/glm.hpp>

#include <span>
#include <string_view>

namespace mirrorball {

enum class BrushMode { Paint, Erase, Smudge };

/// The words of files and forms, in the order of the values: paint erase smudge.
std::span<const std::string_view> words(BrushMode);

inline constexpr double smallestRadius = 1e-3; ///< of a tip, disc radii
inline constexpr double largestRadius = 2.0;

/// What a stroke is drawn with. Lengths are in radii of the disc, so that a stroke looks the same at every size of the map.
///
/// The footprint is a circle *on the disc*. The map is equal-area (d omega = 4 dA), so the footprint covers the same solid angle wherever
/// it lies, and on the picture of the ball, which the disc is, it stays the circle that the artist sees. Towards the rim it is
/// therefore stretched on the sphere along the rim, as everything in the map is.
///
/// A tilted pen may stretch it to an ellipse: leanAt().
///
/// Paint and erase cover: a dab of strength a at distance d takes 1 - a p(d) of what shines through, so a stroke covers
///   c = opacity (1 - prod_i (1 - a_i p(d_i)))
/// whatever the order of its dabs. Smudge moves: see stroke_raster.h.
struct Brush {
    BrushMode mode = BrushMode::Paint;
    glm::dvec3 color{0.0};
    double radius = 0.08;
    double hardness = 0.5;
    double flow = 0.6;
    double opacity = 1.0;
    double spacing = 0.1;
    double pressureRadius = 0.5;
    double pressureFlow = 0.5;
    double tilt = 0.0;
    UnknownKeys unknown{};

    bool operator==(const Brush&) const = default;
    template <typename Self, typename Visit>
    static void visitFields(Self& self, Visit&& visit)
    {
        visit(Field{"mode", "paint covers, erase uncovers, smudge pushes what is there"}, self.mode);
        visit(Field{"color", "color of the paint, linear RGB", 0, 1000}, self.color);
        visit(Field{"radius", "radius of the tip", smallestRadius, largestRadius, "disc radii"}, self.radius);
        visit(Field{"hardness", "part of the radius that covers fully; 1 has a sharp edge", 0, 1}, self.hardness);
        visit(Field{"flow", "how much one dab covers or pushes", 0, 1}, self.flow);
        visit(Field{"opacity", "the most that one stroke covers", 0, 1}, self.opacity);
        visit(Field{"spacing", "way from dab to dab; above 1 the dabs stand apart", 0.02, 10, "diameters"}, self.spacing);
        visit(Field{"pressure-radius", "how far light pressure makes the tip smaller", 0, 1}, self.pressureRadius);
        visit(Field{"pressure-flow", "how far light pressure makes the flow weaker", 0, 1}, self.pressureFlow);
        visit(Field{"tilt", "how far a tilted pen stretches the tip the way it leans", 0, 1}, self.tilt);
    }
};

/// Radius under a pressure in [0, 1]: radius (1 - k + k pressure) with k = pressureRadius, and never under 1/32 of the radius, so that
/// a stroke goes on under a pen that hardly touches.
double radiusAt(const Brush& brush, double pressure);
/// Strength of a dab under a pressure: flow (1 - k + k pressure) with k = pressureFlow.
double strengthAt(const Brush& brush, double pressure);

/// How the tip is stretched under a pen that is tilted by `tiltDeg` from upright along x and y. A round jet about the pen's axis would meet
/// the disc in an ellipse that is longer the way the pen leans by the reciprocal cosine of its inclination,
///   1 / cos = sqrt(1 + tan^2 tilt_x + tan^2 tilt_y);
/// with k = tilt of the brush the tip is s = 1 + k (1 / cos - 1) times as long, and as wide as it was.
/// @return e sqrt(1 - 1 / s^2), with e the unit vector of the way it leans: distances that measure the tip are d^2 - (d . lean)^2. 0 for
/// a round tip
glm::dvec2 leanAt(const Brush& brush, const glm::dvec2& tiltDeg);

/// The falloff of one dab on a grid of texels: a p(d), with d the distance from its center in texels.
///   p = u^2 (3 - 2u),  u = clamp((outer^2 - d^2) / (outer^2 - inner^2), 0, 1)
/// outer is the radius and inner hardness times it. The paint in a dab is the integral of p over the plane, pi m^2 with
/// m^2 = (inner^2 + outer^2) / 2: an edge of less than a texel is drawn one texel wide about the circle m, and a tip with m under one texel
/// is drawn with m = 1 and weaker by m^2. So a dab holds as much paint at every size of the map.
struct DabProfile {
    float outer2 = 0.0f;   ///< square of the outermost distance, texels^2
    float slope = 0.0f;    ///< 1 / (outer^2 - inner^2)
    float strength = 0.0f; ///< a

    float at(float d2) const
    {
        const float u = glm::clamp((outer2 - d2) * slope, 0.0f, 1.0f);
        return strength * u * u * (3.0f - 2.0f * u);
    }
};

/// @param radius  in texels, above 0
DabProfile dabProfile(double radius, double hardness, double strength);

} // namespace mirrorball
