#pragma once

#include "core/sphere/direction.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace mirrorball {

/// One generalized cosine lobe. Its axis for a view v is (cxy v_x, cxy v_y, cz v_z) in the frame of the surface: cxy = -cz reflects, cxy =
/// cz returns the light to where it came from, cxy closer to 0 leans towards the normal, cxy farther from 0 off-specular to the horizon.
struct LafortuneLobe {
    double cxy = -1.0;
    double cz = 1.0;
    double exponent = 50.0; ///< n, at least 0
    double weight = 1.0;    ///< at least 0
    bool operator==(const LafortuneLobe&) const = default;
};

/// A sum of generalized cosine lobes, isotropic and reciprocal:
///   f = sum_i w_i (n_i + 2)/(2 pi) max(cxy_i (l_x v_x + l_y v_y) + cz_i l_z v_z, 0)^n_i
/// One lobe of cxy = -1, cz = 1, w = 1 is the modified Phong model, whose albedo at normal incidence is 1.
/// Source: Lafortune, Foo, Torrance and Greenberg, "Non-Linear Approximation of Reflectance Functions", SIGGRAPH 97, eq. 7
struct LafortuneBrdf {
    std::vector<LafortuneLobe> lobes{LafortuneLobe{}};

    double value(double nl, double nv, double lv) const
    {
        double sum = 0.0;
        for (const LafortuneLobe& lobe : lobes) {
            const double c = lobe.cxy * (lv - nl * nv) + lobe.cz * nl * nv;
            sum += lobe.weight * (lobe.exponent + 2.0) / (2.0 * pi) * std::pow(std::max(c, 1e-300), lobe.exponent) * (c > 0.0 ? 1.0 : 0.0);
        }
        return sum;
    }
    bool operator==(const LafortuneBrdf&) const = default;
};

} // namespace mirrorball
