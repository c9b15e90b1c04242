#pragma once

#include "core/spheremap/document/layer_kind.h"
#include "gradient_table.h"
#include "level.h"
#include "span.h"

namespace mirrorball {

/// One color everywhere.
struct FillLayer {
    static constexpr LayerKind kind{"fill", "Fill", "one color everywhere"};
    glm::dvec3 color{0.5};
    UnknownKeys unknown{};

    bool operator==(const FillLayer&) const = default;
    template <typename Self, typename Visit>
    static void visitFields(Self& self, Visit&& visit)
    {
        visit(Field{"color", "linear RGB", 0, 1000}, self.color);
    }
};

/// What a gradient runs along. Radial: t = |q - center| / radius. Linear: t = (q - center).d / (2 radius) + 1/2, d at the angle. Angular:
/// once around the center, from the angle on. Shaded: t = (n.l + 1) / 2, from the point that faces away from a light to the one that faces
/// it.
enum class GradientShape { Radial, Linear, Angular, Shaded };
std::span<const std::string_view> words(GradientShape); // radial linear angular shaded

/// What happens outside [0, 1].
enum class GradientRepeat { Clamp, Repeat, Mirror };
std::span<const std::string_view> words(GradientRepeat); // clamp repeat mirror

struct GradientLayer {
    static constexpr LayerKind kind{"gradient", "Gradient",
                                    "colors between stops, around a center, across, around, or from shade to light"};
    GradientShape shape = GradientShape::Shaded;
    std::vector<GradientStop> stops{{0.0, {0.02, 0.02, 0.03}}, {1.0, {0.9, 0.88, 0.85}}};
    ColorMixing mixing = ColorMixing::Oklab;
    GradientRepeat repeat = GradientRepeat::Clamp;
    double centerX = 0.0;
    double centerY = 0.0;
    double radius = 1.0;
    double angleDeg = 90.0;
    double azimuthDeg = 120.0;
    double polarDeg = 50.0;
    UnknownKeys unknown{};

    bool operator==(const GradientLayer&) const = default;
    template <typename Self, typename Visit>
    static void visitFields(Self& self, Visit&& visit)
    {
        visit(Field{"shape", "radial: around the center; linear: across; angular: once around; shaded: by the angle to a light"},
              self.shape);
        visit(Field{"stops", "colors and where they stand", 0, 64}, self.stops);
        visit(Field{"mixing", "oklab: steps look even; linear: as light mixes"}, self.mixing);
        visit(Field{"repeat", "what happens past the ends"}, self.repeat);
        visit(Field{"center-x", "radial, linear, angular: center, to the right", -2, 2, "disc radii"}, self.centerX);
        visit(Field{"center-y", "radial, linear, angular: center, up", -2, 2, "disc radii"}, self.centerY);
        visit(Field{"radius", "radial, linear: from the center to the last stop", 1e-3, 4, "disc radii"}, self.radius);
        visit(Field{"angle", "linear, angular: direction, counterclockwise from the right", -360, 360, "degrees"}, self.angleDeg);
        visit(Field{"azimuth", "shaded: the light, counterclockwise from the right", -360, 360, "degrees"}, self.azimuthDeg);
        visit(Field{"polar", "shaded: the light, away from the eye", 0, 180, "degrees"}, self.polarDeg);
    }
};

SpanGenerator prepare(const FillLayer& layer, const Level& level);
SpanGenerator prepare(const GradientLayer& layer, const Level& level);

} // namespace mirrorball
