#pragma once

#include "brdf_lookups.h"

namespace mirrorball {

/// What an engine of today reads from its ggx chain for a material, as lookups. It knows a material by its roughness and its reflectance F0
/// at normal incidence, and the table (A, B) of ggx at that roughness (brdf_table.h), E = A + B:
///
///   split sum   E(r) (F0 A + B), (A, B) of the material's own model                       Karis 2013
///   three       E(r') (F0 A + B)  +  irradiance(n)/pi (F0 A + B) Favg (1 - E)/(1 - Favg (1 - E)),  Favg = F0 + (1 - F0)/21
///               r187: computeMultiscattering() after Fdez-Aguera 2019, a geometric series of bounces; getIBLRadiance()
///   filament    E(r') (F0 A + B) (1 + F0 (1/E - 1))
///               surface_light_indirect.fs, energyCompensation after Lagarde and Golubev 2018
/// with r' = mix(r, n, roughness^4), which "keeps rough objects from gathering light from behind their tangent plane". irradiance/pi is the
/// ggx chain's last level, alpha = 1, at n: that lobe is the cosine's. In a white furnace (F0 = 1, L = 1) the split sum reflects E < 1,
/// what one bounce reflects; the other two 1.

/// What an engine is told of a material.
struct EngineMaterial {
    double roughness = 0.5; ///< root of equivalentAlpha(), at least three's and Filament's least, 0.045
    glm::dvec3 f0{1.0};     ///< of the Fresnel term at normal incidence; of a measurement its albedo there, at most 1
};
EngineMaterial engineMaterial(const Brdf& brdf);

/// @param view  radians in [0, pi/2)
LookupFit splitSum(const Brdf& brdf, double view);
LookupFit threeLookups(const EngineMaterial& material, double view);
LookupFit filamentLookups(const EngineMaterial& material, double view);

} // namespace mirrorball
