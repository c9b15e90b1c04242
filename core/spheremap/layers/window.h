#pragma once

#include "core/spheremap/document/layer_kind.h"
#include "core/spheremap/math/level.h"
#include "core/spheremap/math/span.h"

#include <glm/glm.hpp>

namespace mirrorball {

/// A sketch of a window, as if mirrored in the ball: panes between bars, everything else transparent.
///
/// The window is a rectangle in coordinates (u, v) about its center c on the disc. Flat: (u, v) = q - c. Curved: lines on the tangent plane
/// of the ball at c, (u, v) = (n.e1, n.e2) / (n.c), whose images bulge as those of straight bars in a mirror ball do. `curvature` mixes the
/// two. Source: 000 section 4 and figure 15, first column.
struct WindowLayer {
    static constexpr LayerKind kind{"window", "Window", "panes and bars, as if a window were mirrored"};
    int columns = 2;
    int rows = 3;
    double width = 0.5;
    double height = 0.7;
    double frame = 0.05;
    WidthUnit unit = WidthUnit::Disc;
    double centerX = -0.3;
    double centerY = 0.3;
    double tiltDeg = -8.0;
    double curvature = 0.8;
    double softness = 0.0;
    double fade = 0.0;
    glm::dvec3 paneColor{1.0};
    glm::dvec3 frameColor{0.0};
    double frameOpacity = 1.0;
    UnknownKeys unknown{};

    bool operator==(const WindowLayer&) const = default;
    template <typename Self, typename Visit>
    static void visitFields(Self& self, Visit&& visit)
    {
        visit(Field{"columns", "panes side by side", 1, 64}, self.columns);
        visit(Field{"rows", "panes one above the other", 1, 64}, self.rows);
        visit(Field{"width", "of the window", 0.01, 8, "disc radii"}, self.width);
        visit(Field{"height", "of the window", 0.01, 8, "disc radii"}, self.height);
        visit(Field{"frame", "width of the bars", 0, 64, "disc radii or pixels"}, self.frame);
        visit(Field{"unit", "of the bars' width; pixels: the same on every level"}, self.unit);
        visit(Field{"center-x", "to the right", -1, 1, "disc radii"}, self.centerX);
        visit(Field{"center-y", "up", -1, 1, "disc radii"}, self.centerY);
        visit(Field{"tilt", "turned counterclockwise", -360, 360, "degrees"}, self.tiltDeg);
        visit(Field{"curvature", "0: straight bars; 1: bent as in a mirror ball", 0, 1}, self.curvature);
        visit(Field{"softness", "of the edges", 0, 1, "disc radii"}, self.softness);
        visit(Field{"fade", "how far the panes fade out towards the bottom", 0, 1}, self.fade);
        visit(Field{"pane-color", "linear RGB", 0, 1000}, self.paneColor);
        visit(Field{"frame-color", "linear RGB", 0, 1000}, self.frameColor);
        visit(Field{"frame-opacity", "0: the bars are gaps", 0, 1}, self.frameOpacity);
    }
};

SpanGenerator prepare(const WindowLayer& layer, const Level& level);

/// The window's coordinates (u, v) of a place on the disc, from its center, in disc radii:
///   (1 - curvature) (q - c).d + curvature (n.e) / (n.c)
/// Places that face away from the window (n.c < 0.05) are far outside it.
glm::dvec2 windowCoordinates(const WindowLayer& layer, const glm::dvec2& q);
/// The place on the disc that has such coordinates, or the nearest on the rim where the window reaches around it. By Newton's method.
glm::dvec2 windowPlace(const WindowLayer& layer, const glm::dvec2& uv);

} // namespace mirrorball
