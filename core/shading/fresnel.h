#pragma once

#include "core/sphere/direction.h"

#include <glm/glm.hpp>

/// How much of the light a smooth surface mirrors: the Fresnel term, unpolarised and exact. Twin: resources/shaders/lib/fresnel.glsl.
namespace mirrorball {

/// Complex index of refraction n + ik per color channel, relative to the medium outside.
struct ConductorIndex {
    glm::dvec3 n{1.0}; ///< > 0
    glm::dvec3 k{0.0}; ///< extinction, >= 0
    bool operator==(const ConductorIndex&) const = default;
};

/// How the mirrored part L_m and the diffuse part L_d make one radiance. Source: 000 section 3.1.1.
enum class Combine {
    Add,  ///< F L_m + L_d
    Coat, ///< F L_m + (1 - F) L_d: a diffuse surface under a clear coat
};

enum class FresnelKind { None, Dielectric, Conductor };

/// Which Fresnel term a material has. A value.
struct Fresnel {
    FresnelKind kind = FresnelKind::None; ///< None: F = 1 at every angle
    double index = 1.5;                   ///< dielectric: n > 0
    ConductorIndex conductor{};           ///< conductor
    bool operator==(const Fresnel&) const = default;
};

/// Unpolarised reflectance of a smooth dielectric.
///   F = (g - c)^2 / (2 (g + c)^2) [1 + (c (g + c) - 1)^2 / (c (g - c) + 1)^2],  g^2 = n^2 + c^2 - 1
/// @param cosTheta c = n.v, clamped to [0, 1]
/// @param index    index of refraction n > 0, the far side's over the near one's; below 1 the reflection is total past the critical angle
/// @return F in [0, 1]; 0 for n = 1 at every angle (grazing too), 1 at grazing incidence for every other n
/// Source: 000 eq. 13
double fresnelDielectric(double cosTheta, double index);

/// Unpolarised reflectance of a smooth conductor, one channel. k = 0 gives fresnelDielectric.
/// @param cosTheta clamped to [0, 1]; @param n > 0; @param k >= 0
double fresnelConductor(double cosTheta, double n, double k);
glm::dvec3 fresnelConductor(double cosTheta, const ConductorIndex& index);

/// Schlick's approximation f0 + (1 - f0)(1 - c)^5 from the reflectance f0 at normal incidence.
double fresnelSchlick(double cosTheta, double f0);

/// F of a material, per channel; 1 for FresnelKind::None.
glm::dvec3 reflectance(const Fresnel& fresnel, double cosTheta);

/// @throws InvalidArgument naming the field unless n is finite and > 0 and k finite and >= 0
void validate(const Fresnel& fresnel);

} // namespace mirrorball
