#pragma once

#include "half_angles.h"

#include "core/sphere/direction.h"

namespace mirrorball {

/// The specular term of Cook and Torrance as they printed it (F stands beside, in Brdf):
///   R_s = D G / (pi (n.l)(n.v)),   G = min(1, 2 (n.h)(n.l)/(v.h), 2 (n.h)(n.v)/(v.h)),   D = exp(-tan^2(theta_h)/m^2) / (m^2
///   cos^4(theta_h))
/// Reciprocal. The D of a surface whose facets cover it once is 1/pi of this one, and a mirror facet spreads it by 1/4 and not by 1/pi: the
/// term reflects about four times the light that arrives. beckmann_brdf.h is the same surface within that bound.
/// Source: 003 eqs. 6 and 7; D: Cook and Torrance, "A Reflectance Model for Computer Graphics", ACM TOG 1(1), 1982
struct CookTorranceBrdf {
    double m = 0.2; ///< root mean square slope, > 0

    double value(double nl, double nv, double lv) const
    {
        const HalfAngles h = halfAngles(nl, nv, lv);
        const double nh2 = std::max(h.nh * h.nh, 1e-12), m2 = m * m;
        const double d = std::exp(std::max(-(1.0 - nh2) / (nh2 * m2), -700.0)) / (m2 * nh2 * nh2);
        const double g = std::min(1.0, 2.0 * h.nh / h.hl * std::min(nl, nv));
        return d * g / (pi * std::max(nl * nv, 1e-12));
    }
    bool operator==(const CookTorranceBrdf&) const = default;
};

} // namespace mirrorball
