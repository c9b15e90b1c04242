#pragma once

#include "core/spheremap/document/layer_kind.h"
#include "core/spheremap/math/level.h"
#include "warp.h"

/// Layers that move what lies below them.
namespace mirrorball {

/// Turns the disc about its center, by an angle that falls off with the distance: angle (1 - rho / radius)^2 inside the radius.
struct TwistLayer {
    static constexpr LayerKind kind{"twist", "Twist", "a whirl around the center", LayerRole::Warp};
    double angleDeg = 120.0;
    double radius = 1.0;
    UnknownKeys unknown{};

    bool operator==(const TwistLayer&) const = default;
    template <typename Self, typename Visit>
    static void visitFields(Self& self, Visit&& visit)
    {
        visit(Field{"angle", "at the center, counterclockwise", -1440, 1440, "degrees"}, self.angleDeg);
        visit(Field{"radius", "where it ends", 0.01, 2, "disc radii"}, self.radius);
    }
};

/// Turns the ball: about the view axis, and towards the right and up, so that what lay at the center moves. What comes from the ball's
/// back takes the color of the rim.
struct RotateLayer {
    static constexpr LayerKind kind{"rotate", "Rotate", "turns the whole ball", LayerRole::Warp};
    double angleDeg = 0.0;
    double rightDeg = 0.0;
    double upDeg = 0.0;
    UnknownKeys unknown{};

    bool operator==(const RotateLayer&) const = default;
    template <typename Self, typename Visit>
    static void visitFields(Self& self, Visit&& visit)
    {
        visit(Field{"angle", "about the view axis, counterclockwise", -360, 360, "degrees"}, self.angleDeg);
        visit(Field{"right", "the center moves to the right", -180, 180, "degrees"}, self.rightDeg);
        visit(Field{"up", "the center moves up", -180, 180, "degrees"}, self.upDeg);
    }
};

Warp prepare(const TwistLayer& layer, const Level& level);
Warp prepare(const RotateLayer& layer, const Level& level);

} // namespace mirrorball
