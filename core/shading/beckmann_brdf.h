#pragma once

#include "half_angles.h"

#include "core/sphere/direction.h"

namespace mirrorball {

/// Beckmann's microfacets with height-correlated Smith masking:
///   f = D G / (4 (n.l)(n.v)),   D = exp(-tan^2(theta_h)/alpha^2) / (pi alpha^2 cos^4(theta_h)),   G = 1/(1 + L(n.l) + L(n.v)),
///   L(c) = (1 - 1.259 a + 0.396 a^2)/(3.535 a + 2.181 a^2) for a = c/(alpha sqrt(1 - c^2)) < 1.6, else 0
/// Reciprocal. L is the rational fit to Smith's integral.
/// Source: Walter, Marschner, Li and Torrance, "Microfacet Models for Refraction through Rough Surfaces", EGSR 2007, eqs. 25 to 27;
/// Heitz, "Understanding the Masking-Shadowing Function", JCGT 3(2), 2014, eq. 99
struct BeckmannBrdf {
    double alpha = 0.2; ///< > 0

    static double lambda(double c, double alpha)
    {
        const double a = std::max(c / (alpha * std::sqrt(std::max(1.0 - c * c, 1e-24))), 1e-12);
        return a < 1.6 ? (1.0 - 1.259 * a + 0.396 * a * a) / (3.535 * a + 2.181 * a * a) : 0.0;
    }
    double value(double nl, double nv, double lv) const
    {
        const HalfAngles h = halfAngles(nl, nv, lv);
        const double nh2 = std::max(h.nh * h.nh, 1e-12), a2 = alpha * alpha;
        const double d = std::exp(std::max(-(1.0 - nh2) / (nh2 * a2), -700.0)) / (pi * a2 * nh2 * nh2);
        return d / ((1.0 + lambda(nl, alpha) + lambda(nv, alpha)) * 4.0 * std::max(nl * nv, 1e-12));
    }
    bool operator==(const BeckmannBrdf&) const = default;
};

} // namespace mirrorball
