#pragma once

#include <string>
#include <vector>

/// Lobes: radially symmetric kernels k(cos t) about the lookup direction, zero below its horizon, integral 1 over the sphere.
namespace mirrorball {

enum class LobeKind { Phong, Diffuse, Ggx, Tabulated };

/// One lobe. Build it with the functions below, which check the ranges.
///
///   phong(n)    k = (n+1)/(2 pi) max(c, 0)^n                 looked up by reflection   000 eq. 17, normalised; roughness there is 1/n
///   diffuse     k = max(c, 0)/pi                             looked up by normal       000 eq. 15 over pi
///   ggx(alpha)  k ~ D(t/2) max(c, 0), N = V = R              looked up by reflection   split-sum prefilter; alpha = roughness^2
///   tabulated   linear between samples equally spaced in c over [0, 1], scaled to integral 1     looked up by reflection
/// with c = cos t.
struct Lobe {
    LobeKind kind = LobeKind::Phong;
    double exponent = 50.0;          ///< phong: n >= 0
    double alpha = 0.1;              ///< ggx: [0, 1]; 0 is the mirror
    std::vector<double> samples{};   ///< tabulated: k at c = i/(size - 1), at least 2, non-negative, not all 0

    /// A mirror needs no filtering: ggx with alpha = 0, or any lobe so narrow that doubles cannot tell it from one.
    bool isMirror() const;
    bool operator==(const Lobe&) const = default;
};

/// @throws InvalidArgument unless n is finite and >= 0
Lobe phongLobe(double n);
Lobe diffuseLobe();
/// @throws InvalidArgument unless alpha is in [0, 1]
Lobe ggxLobe(double alpha);
/// @throws InvalidArgument for fewer than 2 samples, a negative or non-finite one, or a sum of 0
Lobe tabulatedLobe(std::vector<double> samples);

/// "phong:50", "diffuse", "ggx:0.09": for plans, statistics and reports.
std::string describe(const Lobe& lobe);

} // namespace mirrorball
