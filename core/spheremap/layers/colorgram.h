#pragma once

#include "core/spheremap/document/layer_kind.h"
#include "core/spheremap/math/gradient_table.h"
#include "core/spheremap/math/level.h"
#include "core/spheremap/math/span.h"

namespace mirrorball {

/// Where a colorgram's colors come from: a gradient drawn at will, or a diffraction grating.
enum class ColorgramSource { Gradient, Grating };
std::span<const std::string_view> words(ColorgramSource); // gradient grating

/// How the grooves of a grating run. Scattered: small pieces turned every way, as in foil. Straight: one direction. Rings: around the
/// center, as on a disc that faces the eye.
enum class Grooves { Scattered, Straight, Rings };
std::span<const std::string_view> words(Grooves); // scattered straight rings

/// The stops of a rainbow that ends as it begins.
std::vector<GradientStop> rainbow();

/// Rainbow rings or arcs around a white center, which multiplied over a surface leaves it as it is where it faces the eye.
///
/// Gradient: the color at t = rings (rho - c)/(1 - c) + sweep phi' / 2 pi + ripple cos(arcs phi'), repeated, with c the center's radius
/// and phi' = phi + twist rho: the twist makes left differ from right.
///
/// Grating: light from l reaches the eye v in order m where the path difference is m wavelengths, m lambda = pitch |(l + v).t|, with t the
/// unit tangent across the grooves; for scattered ones the longest, pitch |h - (h.n) n| with h = l + v. Each order adds the color of its
/// wavelength, seen by the CIE 1931 observer (cie_observer.h) under a light of equal energy, at 1/m of the strength; `spread` is the
/// light's extent. Order 0, the mirror direction, is white. Colors outside Rec.709 are mixed with white until they lie inside.
/// Source: 003 section 6, figures 18 and 19; Born and Wolf, Principles of Optics, section 8.6.1 for the grating.
struct ColorgramLayer {
    static constexpr LayerKind kind{"colorgram", "Colorgram",
                                    "rainbow rings and arcs, drawn or diffracted, to be multiplied over a material", LayerRole::Generator,
                                    BlendMode::Multiply};
    ColorgramSource source = ColorgramSource::Gradient;
    std::vector<GradientStop> stops = rainbow();
    double rings = 2.0;
    int sweep = 0;
    int arcs = 2;
    double ripple = 0.15;
    double twistDeg = 60.0;
    double center = 0.25;
    double centerSoftness = 0.4;
    double strength = 0.8;
    double pitch = 1200.0;
    int orders = 3;
    Grooves grooves = Grooves::Scattered;
    double grooveDeg = 90.0;
    double azimuthDeg = 90.0;
    double polarDeg = 0.0;
    double spread = 0.05;
    double intensity = 1.0;
    UnknownKeys unknown{};

    bool operator==(const ColorgramLayer&) const = default;
    template <typename Self, typename Visit>
    static void visitFields(Self& self, Visit&& visit)
    {
        visit(Field{"source", "gradient: drawn at will; grating: diffracted light"}, self.source);
        visit(Field{"stops", "gradient: colors of one ring", 0, 64}, self.stops);
        visit(Field{"rings", "gradient: from the center to the rim", 0, 50}, self.rings);
        visit(Field{"sweep", "gradient: how often the colors run once around", -16, 16}, self.sweep);
        visit(Field{"arcs", "gradient: waves around the rings", 0, 64}, self.arcs);
        visit(Field{"ripple", "gradient: height of the waves, in rings", 0, 2}, self.ripple);
        visit(Field{"twist", "turns what lies outside further: the rings differ left and right", -1440, 1440, "degrees"}, self.twistDeg);
        visit(Field{"center", "radius of the white center", 0, 0.99, "disc radii"}, self.center);
        visit(Field{"center-softness", "of its edge", 0, 1, "disc radii"}, self.centerSoftness);
        visit(Field{"strength", "how far the colors differ from white", 0, 1}, self.strength);
        visit(Field{"pitch", "grating: from groove to groove", 100, 100000, "nm"}, self.pitch);
        visit(Field{"orders", "grating: rainbows on each side", 1, 12}, self.orders);
        visit(Field{"grooves", "grating: how they run"}, self.grooves);
        visit(Field{"groove-angle", "grating: of straight grooves, counterclockwise from the right", -360, 360, "degrees"}, self.grooveDeg);
        visit(Field{"azimuth", "grating: the light, counterclockwise from the right", -360, 360, "degrees"}, self.azimuthDeg);
        visit(Field{"polar", "grating: the light, away from the eye; 0: at the eye", 0, 170, "degrees"}, self.polarDeg);
        visit(Field{"spread", "grating: extent of the light, which washes the colors out", 0.001, 1}, self.spread);
        visit(Field{"intensity", "grating: of the light", 0, 1000}, self.intensity);
    }
};

SpanGenerator prepare(const ColorgramLayer& layer, const Level& level);

} // namespace mirrorball
