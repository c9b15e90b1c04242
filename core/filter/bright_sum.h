#pragma once

#include "lobe.h"

#include <glm/glm.hpp>

#include <cstddef>

namespace mirrorball {

/// Directions and weighted fluxes of bright texels, a plane each.
struct BrightPlanes {
    const double *x, *y, *z, *red, *green, *blue;
};

/// Whether a lobe costs a few products a texel: phong with a small whole exponent.
bool hasQuickPowers(const Lobe& lobe);

/// sum over [first, last) of flux_b k(r.d_b)/k(1): the loop that a split probe's maps are made of.
glm::dvec3 brightSum(const BrightPlanes& planes, size_t first, size_t last, const Lobe& lobe, const LobeShape& shape, const glm::dvec3& r);

} // namespace mirrorball
