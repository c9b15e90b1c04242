#pragma once

#include "core/shading/reflection_kernel.h"

#include <array>
#include <span>
#include <vector>

namespace mirrorball {

/// A reflection kernel about its mirrored view r, normalized to integral 1 per channel, in harmonics:
///   K/albedo = sum_m kappa_m(gamma) cos(m chi),   kappa_m = sum_l k_lm sqrt((2l+1)/(4 pi)) lambda_lm(cos gamma),
/// the factors k_lm of spin_transform.h. k_l0 are those of a round lobe (Funk-Hecke).
struct KernelSpectrum {
    double view = 0.0;
    int bandLimit = 0;
    int orders = 0; ///< largest m
    bool isGray = true;
    glm::dvec3 albedo{1.0};
    std::array<std::vector<double>, 3> k{}; ///< [m][l], l from 0; the first channel alone where isGray
    std::array<double, 3> power{};          ///< integral of (K/albedo)^2, to which the terms below add up

    std::span<const double> order(int m, int channel) const
    {
        const auto n = static_cast<size_t>(bandLimit) + 1;
        return std::span<const double>(k[isGray ? 0 : static_cast<size_t>(channel)]).subspan(static_cast<size_t>(m) * n, n);
    }
    /// The part of `power` that degree l and order m hold.
    double term(int l, int m, int channel) const
    {
        const double v = order(m, channel)[static_cast<size_t>(l)];
        return v * v * (2.0 * l + 1.0) / (4.0 * pi) * (m == 0 ? 1.0 : 0.5);
    }
};

/// By Gauss-Legendre quadrature over lobeNodes(): no degree or order is aliased.
KernelSpectrum kernelSpectrum(const ReflectionKernel& kernel, int bandLimit, int orders);

} // namespace mirrorball
