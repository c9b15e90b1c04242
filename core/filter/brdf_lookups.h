#pragma once

#include "filter_source.h"
#include "kernel_spectrum.h"
#include "reflection_frame.h"

#include "core/base/job.h"
#include "core/image/environment_map.h"

#include <span>
#include <vector>

namespace mirrorball {

/// One lookup into an ordinary chain of ggx-filtered maps.
struct BrdfLookup {
    double offset = 0.0;    ///< radians in the plane of incidence from r: towards the normal where positive, to the horizon where negative
    double alpha = 0.1;     ///< of the ggx lobe (lobe.h); each engine's law turns it into a level
    glm::dvec3 weight{1.0}; ///< at least 0
    double turn = 0.0;      ///< radians out of that plane, after the offset; lookups beside it come in pairs, one a side
};

/// A BRDF at one angle of view as a few lookups, the successor of the split sum's one:
///   L_o(r) = sum_k w_k E(axis_k; alpha_k),   axis_k in the plane of n and r, or two of them on either side of it.
/// The weights add up to the directional albedo, so a constant probe is exact. Fitted without any probe: the mean square of the error over
/// all frames under light whose power sum_m |a_lm|^2 ~ p_l about its mean is even up to l = 50 and falls beyond, which by the power of
/// kernels in degrees is
///   sum_l p_l/(2l+1) |K_l - sum_k w_k G_kl|^2,   p_l = 1/(1 + (l/50)^2)^2   (lookup_products.h: naturalPower).
/// Over all frames a probe counts by its power in degrees alone, whatever lies where in it.
struct LookupFit {
    double view = 0.0;
    std::vector<BrdfLookup> lookups{};
    double residual = 0.0; ///< root of that sum over that of K: rel_rms about the mean under such light
};

/// @param count  1 to 8
LookupFit fitLookups(const Brdf& brdf, double view, int count);
/// The same at many views, in their order, each fitted from its neighbor's so that they change smoothly; how many lookups stand in pairs
/// is decided for all views together.
std::vector<LookupFit> fitLookups(const Brdf& brdf, std::span<const double> views, int count, const JobControl& job = {});

/// Kautz and McCool's round lobe: one radially symmetric lobe about r that varies with the view, the azimuthal mean of the kernel; exact
/// under every light that is alike all around r. Source: 000 section 3.2.3, eqs. 18 and 19
/// It is order 0 of a stack: planStack(brdf, view, tolerance, 0, source).

/// The map of reflected radiance that the lookups give, each of an exactly filtered chain (no levels, no texels between).
EnvironmentMap filterBrdfLookups(FilterSource& source, const LookupFit& fit, double azimuth, const MapLayout& target, double yaw,
                                 double tolerance, const JobControl& job = {});

} // namespace mirrorball
