#pragma once

#include "half_angles.h"

#include "core/sphere/direction.h"

namespace mirrorball {

/// GGX microfacets with height-correlated Smith masking:
///   f = D V,   D = alpha^2 / (pi ((n.h)^2 (alpha^2 - 1) + 1)^2),
///   V = 0.5 / ((n.l) sqrt(alpha^2 + (1 - alpha^2)(n.v)^2) + (n.v) sqrt(alpha^2 + (1 - alpha^2)(n.l)^2))
/// Reciprocal.
/// Source: Walter et al., EGSR 2007, eq. 33; Heitz, JCGT 3(2), 2014, eqs. 72 and 99
struct GgxBrdf {
    double alpha = 0.1; ///< roughness squared, in (0, 1]

    double value(double nl, double nv, double lv) const
    {
        const double nh = halfAngles(nl, nv, lv).nh, a2 = alpha * alpha;

        const double t = nh * nh * (a2 - 1.0) + 1.0;
        const double masking = nl * std::sqrt(a2 + (1.0 - a2) * nv * nv) + nv * std::sqrt(a2 + (1.0 - a2) * nl * nl);
        return a2 / (pi * t * t) * 0.5 / std::max(masking, 1e-12);
    }
    bool operator==(const GgxBrdf&) const = default;
};

} // namespace mirrorball
