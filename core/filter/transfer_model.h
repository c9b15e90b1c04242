#pragma once

#include <vector>

namespace mirrorball {

/// What a method puts in the lobe's place, degree by degree.
struct TransferModel {
    std::vector<double> k{};       ///< the lobe's coefficients
    std::vector<double> bias{};    ///< h_l - k_l, of the mean transfer h
    std::vector<double> scatter{}; ///< variance of the transfer over places

    /// Where h is a sum of Gauss functions of the angle: each one's share of it, and its variance per axis in square radians.
    struct Blur {
        double share, variance;
    };
    std::vector<Blur> blurs{};
    /// Coefficients of a kernel whose square tells from how far away a texel is felt where the method errs; empty:
    /// from as far as h reaches.
    std::vector<double> felt{};

    /// rel_rms: sqrt(sum p_l (bias_l^2 + scatter_l) / sum p_l k_l^2).
    /// @param power  the probe's, per degree, at least as long as k
    double relRms(const std::vector<double>& power) const;
};

} // namespace mirrorball
