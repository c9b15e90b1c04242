#pragma once

#include <algorithm>
#include <cmath>

namespace mirrorball {

/// The half vector's cosines, from those of the directions: h = (l + v)/|l + v|, |l + v|^2 = 2 + 2 l.v.
struct HalfAngles {
    double nh; ///< n.h, in [0, 1]
    double hl; ///< h.l = h.v, in [0, 1]
};

inline HalfAngles halfAngles(double nl, double nv, double lv)
{
    const double hl = std::sqrt(std::max(0.5 * (1.0 + lv), 1e-24));
    return {std::min(0.5 * (nl + nv) / hl, 1.0), hl};
}

} // namespace mirrorball
