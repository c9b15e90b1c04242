#pragma once

#include "core/spheremap/document/layer_kind.h"
#include "core/spheremap/math/level.h"
#include "core/spheremap/math/span.h"

#include <glm/glm.hpp>

namespace mirrorball {

/// Where hatching grows: towards the outline of the model, or where a light does not reach.
enum class HatchingTone { Silhouette, Shade };
std::span<const std::string_view> words(HatchingTone); // silhouette shade

/// Parallel lines whose width grows with the tone, and a second set across them where it is darker still.
///
/// Line number i of a set lies where s = q.d / (spacing sqrt(1 - k (q.e)^2)) is i, with d across the lines, e along them and k the
/// curvature: 0 draws straight lines, 1 the meridians of the ball. A line covers what part of a texel lies within its width, exactly for
/// a straight line; where lines are closer than texels, all of them together give their average tone. Source: 000 section 4 and figure 15,
/// last column.
struct HatchingLayer {
    static constexpr LayerKind kind{"hatching", "Hatching", "pen lines towards the outline or in the shade, and across each other"};
    glm::dvec3 color{0.0};
    HatchingTone tone = HatchingTone::Silhouette;
    double density = 36.0;
    double angleDeg = 45.0;
    double width = 0.5;
    double curvature = 0.4;
    double from = 0.5;
    double to = 1.0;
    bool cross = true;
    double crossAngleDeg = 80.0;
    double crossFrom = 0.75;
    double jitter = 0.4;
    int seed = 1;
    double azimuthDeg = 125.0;
    double polarDeg = 50.0;
    UnknownKeys unknown{};

    bool operator==(const HatchingLayer&) const = default;
    template <typename Self, typename Visit>
    static void visitFields(Self& self, Visit&& visit)
    {
        visit(Field{"color", "of the ink, linear RGB", 0, 1000}, self.color);
        visit(Field{"tone", "silhouette: lines grow towards the outline; shade: away from a light"}, self.tone);
        visit(Field{"density", "lines across the disc", 1, 500}, self.density);
        visit(Field{"angle", "of the lines, counterclockwise from the right", -360, 360, "degrees"}, self.angleDeg);
        visit(Field{"width", "of a full line, as a part of the way to the next", 0, 1}, self.width);
        visit(Field{"curvature", "0: straight; 1: lines follow the ball", 0, 1}, self.curvature);
        visit(Field{"from", "tone at which lines begin: 0 is the center or full light, 1 the outline or full shade", 0, 1}, self.from);
        visit(Field{"to", "tone at which they are at their widest", 0, 1}, self.to);
        visit(Field{"cross", "a second set of lines"}, self.cross);
        visit(Field{"cross-angle", "between the two sets", -360, 360, "degrees"}, self.crossAngleDeg);
        visit(Field{"cross-from", "tone at which the second set begins", 0, 1}, self.crossFrom);
        visit(Field{"jitter", "how far lines wander, end early and vary in width", 0, 1}, self.jitter);
        visit(Field{"seed", "of the jitter", 0, 1000000}, self.seed);
        visit(Field{"azimuth", "shade: the light, counterclockwise from the right", -360, 360, "degrees"}, self.azimuthDeg);
        visit(Field{"polar", "shade: the light, away from the eye", 0, 180, "degrees"}, self.polarDeg);
    }
};

SpanGenerator prepare(const HatchingLayer& layer, const Level& level);

} // namespace mirrorball
