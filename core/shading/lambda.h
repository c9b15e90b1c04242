#pragma once

#include <algorithm>
#include <cmath>

namespace mirrorball {

/// Least mip level of a reflection seen at the angle whose cosine is c = n.v: what 002 section 3 wishes for, a level by the lookup instead
/// of one for the whole object, "in which case such noticeable effects as sharper reflections near the grazing angle could be simulated".
///
///   lambda(c) = max(0, lambda + g/2 log2 c)
///
/// How much sharper follows from the surface. Its normals spread over a solid angle d omega_h; mirrored about them, the viewer's direction
/// spreads over d omega_r = 4 (v.h) d omega_h (Torrance and Sparrow 1967), less in proportion to c. A level's texel covers 4^lambda times
/// that of the base, and the same share c of it lies log2(c)/2 levels below. That is g = 1; g = 0 is the paper's one lambda for all angles,
/// and larger g exaggerates.
/// @param lambda   at normal incidence, at least 0
/// @param grazing  g, at least 0
inline double lambdaAt(double lambda, double grazing, double cosTheta)
{
    return std::max(0.0, lambda + 0.5 * grazing * std::log2(std::max(cosTheta, 1e-6)));
}

} // namespace mirrorball
