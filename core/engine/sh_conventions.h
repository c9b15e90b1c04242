#pragma once

#include "core/filter/irradiance_sh.h"
#include "core/image/container/babylon_env.h"
#include "core/image/environment_map.h"

#include <string>
#include <string_view>

/// Nine coefficients in the order, signs and scale that each engine asks for; what they are of the same light.
namespace mirrorball {

enum class ShConvention {
    Three,    ///< LightProbe.sh: radiance, integral of L Y_i
    Filament, ///< `sh` of .ktx files, sh.txt: E/pi as a polynomial, k_i N_i L_i, for terms 1 y z x xy yz 3z^2-1 zx x^2-y^2
    Babylon,  ///< .env: polynomial x y z xx yy zz yz zx xy, mirrored in x, convolved with the cosine once more
    Gltf      ///< EXT_lights_image_based: irradiance, pi k_i L_i
};

/// "three", "filament", "babylon", "gltf"
std::string_view name(ShConvention convention);

/// The coefficients in the convention's order.
std::array<glm::dvec3, 9> inConvention(const RadianceSh& sh, ShConvention convention);

/// The polynomial of a .env file: with c the coefficients of Filament's convention,
///   x = -2/3 c3, y = 2/3 c1, z = 2/3 c2, xx = c0 + (c8 - c6)/4, yy = c0 - (c6 + c8)/4, zz = c0 + c6/2, yz = c5/4, zx = -c7/4, xy = -c4/4
babylon_env::Polynomial babylonPolynomial(const RadianceSh& sh);

/// Nine lines "r g b", numbers parted by exactly one blank: the value of the key `sh` in Filament's .ktx.
std::string filamentMetadata(const RadianceSh& sh);

/// Nine lines as cmgen writes into sh.txt.
std::string filamentText(const RadianceSh& sh);

/// What the nine lose of the exact irradiance: rel_rms (docs/conventions.md) over the texels of an exact diffuse map.
double shError(const RadianceSh& sh, const EnvironmentMap& exactDiffuse);

/// Every convention and how good the coefficients are, as JSON.
struct ShQuality {
    double error = 0.0;          ///< of the coefficients that are written
    double unclampedError = 0.0; ///< of those that may be negative
    double least = 0.0;          ///< E/pi of the latter at its least, relative to its mean
};
std::string shJson(const RadianceSh& sh, const ShQuality& quality);

} // namespace mirrorball
