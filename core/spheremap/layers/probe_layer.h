#pragma once

#include "core/spheremap/document/layer_kind.h"
#include "core/spheremap/math/level.h"
#include "core/spheremap/math/span.h"

#include "core/shading/fresnel.h"

#include <glm/glm.hpp>

#include <string>

namespace mirrorball {

std::span<const std::string_view> words(FresnelKind); // none dielectric conductor

/// The lobe that a probe is filtered with, filter/lobe.h. Mirror, phong and ggx are read in the mirror direction, diffuse in that of the
/// normal.
enum class ProbeLobe { Mirror, Phong, Ggx, Diffuse };
std::span<const std::string_view> words(ProbeLobe); // mirror phong ggx diffuse

/// The part of the light that a surface mirrors, or the rest, which reaches what lies below it (000 section 3.1.1: F L_m + (1 - F) L_d).
enum class FresnelShare { Mirrored, Transmitted };
std::span<const std::string_view> words(FresnelShare); // mirrored transmitted

/// A light probe filtered through a lobe, times a Fresnel term: the look of a real material as a layer, to be painted over; the probe may
/// be changed underneath later. The probe stands in eye space: its +Z, turned by the yaw and the tilt, lies behind the eye and is mirrored
/// at the center.
struct ProbeLayer {
    static constexpr LayerKind kind{"probe", "Light probe", "a material under a light probe: lobe and Fresnel term baked in"};
    std::string source = "builtin:studio";
    double yawDeg = 0.0;
    double tiltDeg = 0.0;
    double exposure = 0.0;
    ProbeLobe lobe = ProbeLobe::Ggx;
    double exponent = 50.0;
    double roughness = 0.3;
    glm::dvec3 tint{1.0};
    FresnelKind fresnel = FresnelKind::None;
    double index = 1.5;
    std::string metal = "gold";
    FresnelShare share = FresnelShare::Mirrored;
    UnknownKeys unknown{};

    bool operator==(const ProbeLayer&) const = default;
    template <typename Self, typename Visit>
    static void visitFields(Self& self, Visit&& visit)
    {
        visit(Field{"source", "light probe: image file, or builtin:NAME"}, self.source);
        visit(Field{"yaw", "turns the probe about +Y", -36000, 36000, "degrees"}, self.yawDeg);
        visit(Field{"tilt", "then tips it about +X: what is above moves towards the eye", -180, 180, "degrees"}, self.tiltDeg);
        visit(Field{"exposure", "brightness: times 2^exposure", -64, 64, "EV"}, self.exposure);
        visit(Field{"lobe", "how the surface spreads what it mirrors; diffuse: the matt part"}, self.lobe);
        visit(Field{"exponent", "phong: the larger, the sharper", 0, 1e9}, self.exponent);
        visit(Field{"roughness", "ggx: 0 is a mirror, 1 fully rough; alpha is its square", 0, 1}, self.roughness);
        visit(Field{"tint", "color, linear RGB", 0, 1000}, self.tint);
        visit(Field{"fresnel", "none: alike at every angle; dielectric: glass, lacquer; conductor: metal"}, self.fresnel);
        visit(Field{"index", "dielectric: index of refraction", 1e-3, 1e9}, self.index);
        visit(Field{"metal", "conductor: name of a metal"}, self.metal);
        visit(Field{"share", "mirrored: F; transmitted: 1 - F, for what lies under a coat"}, self.share);
    }
};

/// @throws FileError for a probe that is missing or damaged; InvalidArgument for an unknown probe or metal
SpanGenerator prepare(const ProbeLayer& layer, const Level& level);

} // namespace mirrorball
