#pragma once

#include "core/spheremap/document/layer_kind.h"
#include "core/spheremap/math/level.h"
#include "core/spheremap/math/span.h"

#include <glm/glm.hpp>

namespace mirrorball {

/// Cold-warm shading: the disc in two halves, one cold and one warm, a white disc on the warm one, all under a Gaussian blur, computed in
/// closed form. The halves are the two triangles of the paper's hand-drawn map, cut by the disc.
///   half   (1 + erf(d / (sqrt 2 sigma))) / 2,  d the distance from the dividing line
///   disc   (erf((R - d) / (sqrt 2 sigma)) + erf((R + d) / (sqrt 2 sigma))) / 2,  d the distance from its center
/// Source: 000 section 4 and figure 15, second column, after Gooch et al. 1999.
struct ColdWarmLayer {
    static constexpr LayerKind kind{"cold-warm", "Cold and warm", "blue in the shade, yellow in the light, and a white highlight"};
    glm::dvec3 coldColor{0.02, 0.08, 0.42};
    glm::dvec3 warmColor{0.95, 0.62, 0.08};
    glm::dvec3 highlightColor{1.0};
    double angleDeg = 125.0;
    double balance = 0.0;
    double blur = 0.25;
    double highlight = 0.22;
    double highlightDistance = 0.45;
    UnknownKeys unknown{};

    bool operator==(const ColdWarmLayer&) const = default;
    template <typename Self, typename Visit>
    static void visitFields(Self& self, Visit&& visit)
    {
        visit(Field{"cold-color", "of the shade, linear RGB", 0, 1000}, self.coldColor);
        visit(Field{"warm-color", "of the light, linear RGB", 0, 1000}, self.warmColor);
        visit(Field{"highlight-color", "of the white disc, linear RGB", 0, 1000}, self.highlightColor);
        visit(Field{"angle", "where the warm side lies, counterclockwise from the right", -360, 360, "degrees"}, self.angleDeg);
        visit(Field{"balance", "moves the dividing line: above 0 there is more warmth", -1, 1, "disc radii"}, self.balance);
        visit(Field{"blur", "standard deviation", 0, 2, "disc radii"}, self.blur);
        visit(Field{"highlight", "radius of the white disc", 0, 1, "disc radii"}, self.highlight);
        visit(Field{"highlight-distance", "of the white disc from the center, on the warm side", 0, 1, "disc radii"},
              self.highlightDistance);
    }
};

SpanGenerator prepare(const ColdWarmLayer& layer, const Level& level);

} // namespace mirrorball
