#pragma once

#include "core/spheremap/document/layer_kind.h"
#include "core/spheremap/math/level.h"
#include "core/spheremap/math/span.h"

#include <glm/glm.hpp>

#include <vector>

namespace mirrorball {

/// One tone of a toon shading: it begins where the light is at least `from`.
struct ToonBand {
    double from = 0.0;
    glm::dvec3 color{0.5};
    UnknownKeys unknown{};

    bool operator==(const ToonBand&) const = default;
    template <typename Self, typename Visit>
    static void visitFields(Self& self, Visit&& visit)
    {
        visit(Field{"from", "light at which the band begins: 0 faces away from the light, 1 faces it", 0, 1}, self.from);
        visit(Field{"color", "linear RGB", 0, 1000}, self.color);
    }
};

/// Flat tones by the angle to a light, t = (n.l + 1)/2, a round highlight where n.h > cos(size) with h halfway between light and eye, and a
/// rim along the outline. Without bands of one's own, `count` of them are mixed in Oklab from the shade's color to the light's, with their
/// edges evenly spaced from `shade-end` to 1.
struct ToonLayer {
    static constexpr LayerKind kind{"toon", "Toon bands", "flat tones from shade to light, a hard highlight, a rim"};
    int count = 3;
    glm::dvec3 shadeColor{0.05, 0.03, 0.12};
    glm::dvec3 lightColor{0.85, 0.32, 0.12};
    double shadeEnd = 0.42;
    std::vector<ToonBand> bands{};
    double softness = 0.0;
    double azimuthDeg = 125.0;
    double polarDeg = 50.0;
    double highlightDeg = 9.0;
    glm::dvec3 highlightColor{1.0};
    double rim = 0.0;
    glm::dvec3 rimColor{1.0};
    double rimTurnDeg = 180.0;
    UnknownKeys unknown{};

    bool operator==(const ToonLayer&) const = default;
    template <typename Self, typename Visit>
    static void visitFields(Self& self, Visit&& visit)
    {
        visit(Field{"count", "tones, where there are no bands of one's own", 1, 16}, self.count);
        visit(Field{"shade-color", "of the darkest tone, linear RGB", 0, 1000}, self.shadeColor);
        visit(Field{"light-color", "of the brightest tone, linear RGB", 0, 1000}, self.lightColor);
        visit(Field{"shade-end", "light at which the darkest tone ends", 0, 1}, self.shadeEnd);
        visit(Field{"bands", "tones of one's own instead of count", 0, 16}, self.bands);
        visit(Field{"softness", "of the edges between tones, as light", 0, 1}, self.softness);
        visit(Field{"azimuth", "the light, counterclockwise from the right", -360, 360, "degrees"}, self.azimuthDeg);
        visit(Field{"polar", "the light, away from the eye", 0, 180, "degrees"}, self.polarDeg);
        visit(Field{"highlight", "radius of the highlight; 0: none", 0, 60, "degrees"}, self.highlightDeg);
        visit(Field{"highlight-color", "linear RGB", 0, 1000}, self.highlightColor);
        visit(Field{"rim", "width of the bright rim; 0: none", 0, 1, "disc radii"}, self.rim);
        visit(Field{"rim-color", "linear RGB", 0, 1000}, self.rimColor);
        visit(Field{"rim-turn", "where the rim is widest, from the light on: 180 is opposite", -360, 360, "degrees"}, self.rimTurnDeg);
    }
};

SpanGenerator prepare(const ToonLayer& layer, const Level& level);

} // namespace mirrorball
