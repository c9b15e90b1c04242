#pragma once

#include "core/spheremap/document/layer_kind.h"
#include "core/spheremap/math/level.h"
#include "core/spheremap/math/span.h"

#include <glm/glm.hpp>

#include <vector>

namespace mirrorball {

struct PhongLight {
    double azimuthDeg = 125.0;
    double polarDeg = 50.0;
    glm::dvec3 color{1.0};
    double intensity = 1.0;
    double exponent = 50.0;
    double diffuse = 0.0;
    UnknownKeys unknown{};

    bool operator==(const PhongLight&) const = default;
    template <typename Self, typename Visit>
    static void visitFields(Self& self, Visit&& visit)
    {
        visit(Field{"azimuth", "counterclockwise from the right", -360, 360, "degrees"}, self.azimuthDeg);
        visit(Field{"polar", "away from the eye; 0 is the miner's hat, a light at the eye", 0, 180, "degrees"}, self.polarDeg);
        visit(Field{"color", "linear RGB", 0, 1000}, self.color);
        visit(Field{"intensity", "of the highlight", 0, 1000}, self.intensity);
        visit(Field{"exponent", "the larger, the sharper", 0, 100000}, self.exponent);
        visit(Field{"diffuse", "of the matt part, max(n.l, 0)", 0, 1000}, self.diffuse);
    }
};

/// The highlight's form: (r.l)^n, which is Phong's (R.V)^n because mirroring is mutual, or (n.h)^n.
enum class PhongModel { RV, NH };
std::span<const std::string_view> words(PhongModel); // r.v n.h

/// Which exponent n.h takes: the one that is typed, or the n' that gives the same highlight as r.v with the typed one (matchedExponent).
enum class ExponentMatch { Typed, Matched };
std::span<const std::string_view> words(ExponentMatch); // typed matched

/// Phong highlights of any number of lights over black: add or screen them over a material.
///
/// With r.v the value depends on the mirror direction alone, so the map is also the view-independent form of 003 section 5.2.2: indexed by
/// reflection in world space, it shows lights that stand in the world. With n.h it needs the eye at +Z, and lights move with the eye.
/// Source: 003 sections 5.1 and 5.2, equation 4 and figure 15.
struct PhongLightsLayer {
    static constexpr LayerKind kind{"phong-lights", "Phong lights", "highlights of lights, to be added to a material", LayerRole::Generator,
                                    BlendMode::Add};
    std::vector<PhongLight> lights{PhongLight{}};
    PhongModel model = PhongModel::RV;
    ExponentMatch match = ExponentMatch::Matched;
    glm::dvec3 ambient{0.0};
    UnknownKeys unknown{};

    bool operator==(const PhongLightsLayer&) const = default;
    template <typename Self, typename Visit>
    static void visitFields(Self& self, Visit&& visit)
    {
        visit(Field{"lights", "where they are and how bright", 0, 64}, self.lights);
        visit(Field{"model", "r.v: by the mirror direction; n.h: by the half vector"}, self.model);
        visit(Field{"match", "n.h: the exponent as typed, or the one that looks like r.v with it"}, self.match);
        visit(Field{"ambient", "light everywhere, linear RGB", 0, 1000}, self.ambient);
    }
};

/// The exponent n' with which (n.h)^n' equals (r.v)^n at an angle beta between n and h, alpha = 2 beta being that between r and v:
///   n' = n ln(2 cos^2 beta - 1) / ln(cos beta),  4 n for beta -> 0
/// @param cosBeta  in (sqrt(1/2), 1]
/// Source: 003 section 5.1.1
double matchedExponent(double exponent, double cosBeta);
/// The same at the angle where the highlight has fallen to one half.
double matchedExponent(double exponent);

SpanGenerator prepare(const PhongLightsLayer& layer, const Level& level);

} // namespace mirrorball
