#pragma once

#include "filter_source.h"
#include "kernel_spectrum.h"
#include "reflection_frame.h"
#include "spin_transform.h"

#include "core/base/job.h"
#include "core/image/environment_map.h"

#include <functional>
#include <vector>

namespace mirrorball {

/// Exact maps that know the view. A probe filtered by the kernel of a BRDF at the angle of view t is
///   L_o(r, psi) = albedo Re sum_m e^(-i m psi) A_m(r),   A_m from synthesizeOrder() with kappa_m of the kernel at t,
/// psi the azimuth of the normal: a stack of complex maps, of which order 0 is the map of one round lobe. One forward transform of the
/// probe serves every view and order. The excess of the probe's few brightest texels (bright_texels.h) does not go through it: the kernel
/// is evaluated at each of them, so that a sun behind the horizon is behind a sharp one.
///
/// How far a kernel is followed for a probe. Over all frames (r, psi) the mean square of a response is sum_l S_l T_l/(2l+1), S_l the
/// kernel's power in degree l and T_l the calm probe's; what is left out is a part of that sum, and the error is the root of its share.
struct StackPlan {
    Brdf brdf{};
    KernelSpectrum kernel{}; ///< cut to the degrees and orders that are used
    double predictedError = 0.0;
};

/// rel_rms over a map at one azimuth strays from that over all frames: what the share is multiplied with, so that the figure bounds it.
inline constexpr double stackMargin = 2.0;

/// The largest degree and order that are ever used.
inline constexpr int largestStackDegree = 1024, largestStackOrder = 40;

/// Cheapest degrees and orders within the tolerance.
/// @param tolerance  rel_rms, in (0, 1]. The plan's own figure says what is reached, where the largest degree and order do not suffice.
StackPlan planStack(const Brdf& brdf, double view, double tolerance, FilterSource& source, const JobControl& job = {});
/// The same with orders up to a given one, however far that takes.
StackPlan planStack(const Brdf& brdf, double view, double tolerance, int orders, FilterSource& source, const JobControl& job = {});

/// The same for light of any power: what it has in each degree up to a band limit, as Spectrum::powerAboutMean() counts it.
using PowerByDegree = std::function<std::vector<double>(int bandLimit)>;
StackPlan planStack(const Brdf& brdf, double view, double tolerance, int orders, const PowerByDegree& powerOf);

/// The map of reflected radiance, as filterBrdfSum() has it. Normalized by the same filter of a constant 1, and not below 0 where the probe
/// never is.
EnvironmentMap filterBrdfStack(FilterSource& source, const StackPlan& plan, double azimuth, const MapLayout& target, double yaw,
                               const JobControl& job = {});

/// What the harmonics are made of: the probe without its bright texels, or the whole of one that was streamed.
const Spectrum& stackSpectrum(FilterSource& source, int bandLimit, const JobControl& job = {});

/// Rings that hold the texels of a layout, in its order: rows of a latlong map, single places of any other.
RingSet ringsOf(const MapLayout& layout, double yaw);

} // namespace mirrorball
