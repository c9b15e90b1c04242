#pragma once

#include "core/sphere/direction.h"

#include <algorithm>
#include <cmath>

namespace mirrorball {

/// Phong's lobe as a BRDF:
///   f = k_s max(r_v.l, 0)^n / (n.l),   r_v.l = 2 (n.v)(n.l) - v.l
/// It divides by the cosine that the integral multiplies with, so the reflected radiance is that of one round lobe about r whatever the
/// view; and it is not reciprocal. With k_s = (n + 1)/(2 pi) the lobe's integral is 1 as long as it lies above the horizon.
/// Source: 000 eqs. 16 and 17; its roughness is 1/n
struct PhongBrdf {
    double exponent = 50.0; ///< n, at least 0
    double strength = 1.0;  ///< k_s over (n + 1)/(2 pi), at least 0

    double value(double nl, double nv, double lv) const
    {
        const double rl = std::clamp(2.0 * nv * nl - lv, 0.0, 1.0);
        return strength * (exponent + 1.0) / (2.0 * pi) * std::pow(std::max(rl, 1e-300), exponent) * (rl > 0.0 ? 1.0 : 0.0) /
               std::max(nl, 1e-12);
    }
    bool operator==(const PhongBrdf&) const = default;
};

} // namespace mirrorball
