#pragma once

#include "spectrum.h"

#include <glm/glm.hpp>

#include <array>

/// Diffuse light as nine numbers a channel. Real spherical harmonics of degree 2 at most, all signs positive:
///   i       0      1      2      3      4       5       6                 7       8
///   l m     00     1-1    10     11     2-2     2-1     20                21      22
///   Y_i     N0     N1 y   N1 z   N1 x   N2 xy   N2 yz   N20 (3 z^2 - 1)   N2 zx   N22 (x^2 - y^2)
/// with N0 = 1/sqrt(4 pi), N1 = sqrt(3/4pi), N2 = sqrt(15/4pi), N20 = sqrt(5/16pi), N22 = sqrt(15/16pi), in our axes (direction.h).
/// Source: R. Ramamoorthi and P. Hanrahan, "An Efficient Representation for Irradiance Environment Maps", 2001.
namespace mirrorball {

/// A probe's radiance in the harmonics: L_i = integral of L Y_i.
struct RadianceSh {
    std::array<glm::dvec3, 9> coefficients{};
    bool operator==(const RadianceSh&) const = default;
};

/// N_i.
double shNorm(int i);
/// Y_i(d) / N_i.
double shPolynomial(int i, const glm::dvec3& d);
/// What the cosine lobe makes of a coefficient: E/pi has the coefficients k_i L_i, with k = 1, 2/3 and 1/4 by degree.
double shCosineFactor(int i);

/// @param spectrum  of band limit 2 or more
RadianceSh radianceSh(const Spectrum& spectrum);

/// The probe turned about +Y by `yaw` radians, see direction.h.
RadianceSh turned(const RadianceSh& sh, double yaw);

/// E(n)/pi = sum_i k_i L_i Y_i(n), n unit. Beside a sun it is negative where the sun does not shine; of a constant 1 it is 1.
glm::dvec3 irradianceOverPi(const RadianceSh& sh, const glm::dvec3& n);

/// The least value of E/pi of each channel over the sphere.
glm::dvec3 leastIrradianceOverPi(const RadianceSh& sh);

/// The coefficients whose E/pi is nowhere negative and nearest to that of `sh`: least integral of the squared difference over the sphere,
/// for each channel. Since what nine coefficients miss of the exact irradiance is orthogonal to them, no other non-negative nine lose
/// less of it. Channels without negative light stay as they are.
RadianceSh nonNegative(const RadianceSh& sh);

} // namespace mirrorball
