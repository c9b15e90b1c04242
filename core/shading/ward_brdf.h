#pragma once

#include "half_angles.h"

#include "core/sphere/direction.h"

namespace mirrorball {

/// Ward's isotropic gloss:
///   f = exp(-tan^2(theta_h)/alpha^2) / (4 pi alpha^2 sqrt((n.l)(n.v)))
/// Reciprocal; it loses light towards grazing views.
/// Source: Ward, "Measuring and Modeling Anisotropic Reflection", SIGGRAPH 92, eq. 4, rho_d = 0, rho_s = 1
struct WardBrdf {
    double alpha = 0.1; ///< standard deviation of the slopes, > 0

    double value(double nl, double nv, double lv) const
    {
        const double nh2 = std::max(halfAngles(nl, nv, lv).nh * halfAngles(nl, nv, lv).nh, 1e-12);
        return std::exp(std::max(-(1.0 - nh2) / (nh2 * alpha * alpha), -700.0)) /
               (4.0 * pi * alpha * alpha * std::sqrt(std::max(nl * nv, 1e-12)));
    }
    bool operator==(const WardBrdf&) const = default;
};

} // namespace mirrorball
