#pragma once

#include "beckmann_brdf.h"
#include "brdf_fresnel.h"
#include "cook_torrance_brdf.h"
#include "ggx_brdf.h"
#include "lafortune_brdf.h"
#include "measured_brdf.h"
#include "phong_brdf.h"
#include "ward_brdf.h"

#include <string>
#include <variant>

/// Bidirectional reflectance distribution functions f(l, v), in 1/sr: values. All are isotropic, so that three cosines name a pair of
/// directions: n.l, n.v and l.v.
namespace mirrorball {

using BrdfModel = std::variant<PhongBrdf, LafortuneBrdf, WardBrdf, CookTorranceBrdf, BeckmannBrdf, GgxBrdf, MeasuredBrdf>;

/// A model and the Fresnel term that stands beside it, at h.l, inside the integral. A measurement has its own in its values.
struct Brdf {
    BrdfModel model = GgxBrdf{};
    BrdfFresnel fresnel{};
    bool operator==(const Brdf&) const = default;
};

/// f of a pair of directions in the frame of the surface, whose normal is +Z; 0 where one lies below the horizon. Many values at
/// one view are ReflectionKernel's.
glm::dvec3 evaluate(const Brdf& brdf, const glm::dvec3& l, const glm::dvec3& v);

/// A BRDF from what the command line and scenes write: a file's path (brdf_file.h), or MODEL[:key=value,...] with
///   phong           exponent, strength (1)
///   lafortune       cxy (-1), cz (1), exponent, weight (1); further lobes after `/`
///   ward            alpha
///   cook-torrance   m
///   beckmann, ggx   alpha, or roughness, whose square it is
/// and for all of them one of ior, f0, metal.
/// @throws InvalidArgument naming the key and what it must be; FileError
Brdf brdfFromText(const std::string& text);

/// The text that makes it again; of a measurement the file's name.
std::string describe(const Brdf& brdf);

/// The width alpha of the GGX lobe that an engine would take for this material: its own, or that of equal spread. Ward and Beckmann: alpha;
/// Cook-Torrance: m; phong: sqrt(2/(n' + 2)) with n' = 4 n, the exponent of n.h (003 section 5.1.1 for small angles); of lafortune the
/// heaviest lobe's; of a measurement what its highlight falls to half by at normal incidence, tan^2(theta_h) = alpha^2 (sqrt(2) - 1).
double equivalentAlpha(const Brdf& brdf);

} // namespace mirrorball
