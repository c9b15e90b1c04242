#pragma once

#include "core/spheremap/document/layer_kind.h"
#include "core/spheremap/math/level.h"
#include "core/spheremap/math/span.h"

#include <glm/glm.hpp>

namespace mirrorball {

/// A ring along the rim, which draws silhouettes. In disc units it is wide on flat parts of a model and narrow on curved ones; in pixels of
/// the level it draws a line of about that many pixels on the screen, whatever the curvature.
/// Source: 000 section 4 and figure 15, third column, after Gooch et al. 1999.
struct SilhouetteLayer {
    static constexpr LayerKind kind{"silhouette", "Silhouette ring", "a line along the outline of the model"};
    glm::dvec3 color{0.0};
    double width = 0.1;
    WidthUnit unit = WidthUnit::Disc;
    double softness = 0.0;
    double swell = 0.0;
    double swellDeg = -60.0;
    UnknownKeys unknown{};

    bool operator==(const SilhouetteLayer&) const = default;
    template <typename Self, typename Visit>
    static void visitFields(Self& self, Visit&& visit)
    {
        visit(Field{"color", "of the line, linear RGB", 0, 1000}, self.color);
        visit(Field{"width", "from the rim inwards", 0, 64, "disc radii or pixels"}, self.width);
        visit(Field{"unit", "disc: wider on flat parts; pixels: the same width everywhere, through levels made for it"}, self.unit);
        visit(Field{"softness", "of the inner edge, as a part of the width", 0, 1}, self.softness);
        visit(Field{"swell", "makes the line thicker on one side and thinner on the other, as a pen does", 0, 1}, self.swell);
        visit(Field{"swell-angle", "where it is thickest, counterclockwise from the right", -360, 360, "degrees"}, self.swellDeg);
    }
};

SpanGenerator prepare(const SilhouetteLayer& layer, const Level& level);

} // namespace mirrorball
