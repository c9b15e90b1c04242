#pragma once

#include "lobe.h"
#include "promise.h"
#include "spectrum.h"
#include "transfer_model.h"

#include "core/base/job.h"
#include "core/image/environment_map.h"

/// Where on the sphere a method that approximates errs: its rel_rms tells of the light, median and 99th percentile of where the light is
/// not.
namespace mirrorball {

/// Median and 99th percentile of the error, over some hundred directions r of a probe. The error at r is taken to be
///
///   b(r) + s sqrt(v(r)) g,    b = sum over the texels of L (h - k)(r.d),    v = sum of D q(r.d),    g normal
///
/// what is systematic being the probe seen through the difference of the kernels, and the rest as large as the light nearby has detail D:
/// the mean square of what texels and their slopes do not tell, since lookups between texels get slopes right. q, of integral 1, says from
/// how far away: it falls like h^2 where the method reads blurred levels, like h^1.5 where it takes samples, and else as the square of
/// TransferModel::felt. s makes the root mean square of the whole relRms. Sums run over the probe averaged down to texels as wide as the
/// lobe.
/// @param model  without coefficients: nothing is systematic
/// @throws Cancelled
PredictedErrors spreadErrors(const EnvironmentMap& latlong, const Spectrum& spectrum, const Lobe& lobe, const TransferModel& model,
                             double relRms, const JobControl& job = {});

} // namespace mirrorball
