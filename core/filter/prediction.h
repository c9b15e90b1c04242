#pragma once

#include "error_spread.h"
#include "filter_source.h"
#include "lobe.h"
#include "method.h"
#include "promise.h"

#include "core/image/environment_map.h"

#include <memory>
#include <string>

namespace mirrorball {

struct PrefilterOptions {
    Lobe lobe{};
    MapLayout target{.kind = Parameterization::Cube, .size = 128};
    Method method = Method::Auto;
    double tolerance = 1e-5; ///< what is promised of the map, see errorLimits(); (0, 1]
    double yaw = 0.0;        ///< radians about +Y, see direction.h
    MethodKnobs knobs{};     ///< of the method, where it has some

    bool operator==(const PrefilterOptions&) const = default;
};

/// What a plan must know of a probe. traits() tells it of one that is open.
struct ProbeTraits {
    int width = 1024;        ///< columns of the probe's latlong form
    bool streamed = false;   ///< the texels are not in memory, so that only methods that need no more than a spectrum can run
    int knownBandLimit = -1; ///< of a spectrum of the probe that is there already and costs nothing; -1: none
    double dark = 1e-3;      ///< the darkest half per cent of the sphere is no darker, relative to the mean
    bool hasParaboloidDevice = false;
    std::shared_ptr<const Spectrum> spectrum{};     ///< says how the probe's power is spread; null: it was not looked at
    std::shared_ptr<const Spectrum> calmSpectrum{}; ///< the same without its bright texels
};
ProbeTraits traits(const FilterSource& source);

/// Why a method cannot do this: one line that names the method and the field. Empty where it can; `Auto` always can.
std::string refusal(Method method, const PrefilterOptions& options, const ProbeTraits& probe);

/// What a method is expected to take, in seconds of one thread of a current server, and to miss, as rel_rms. Calibrated on the 1k probes of
/// the test data: the seconds within a factor of 2.5 of what `build/ci/bin/method_table methods` measures and prints beside them, the error
/// within a factor of 2.5 for the methods that approximate (mip: 4), once the probe's spectrum is known
/// (tests/core/filter/prediction_test.cpp). Of the methods that hold a tolerance it is an upper bound, and so it is of the others while the
/// spectrum is not known: a probe may be all sun. The seconds then are those of a usual photograph.
double predictedSeconds(Method method, const PrefilterOptions& options, const ProbeTraits& probe);
double predictedError(Method method, const PrefilterOptions& options, const ProbeTraits& probe);
/// How far the spectral method or sh9 follows the spectrum whatever the probe holds; 0 for the others.
int predictedBandLimit(Method method, const PrefilterOptions& options);

/// What importance, mip, paraboloid and sh9 put in the lobe's place; without coefficients for the others.
TransferModel transferModel(Method method, const PrefilterOptions& options, const ProbeTraits& probe);

/// rel_rms of such a model over the probe's spectrum, or where that is not known over one that is all sun.
double transferError(const TransferModel& model, const ProbeTraits& probe);

/// All of what is predicted of an error; relRms as predictedError().
PredictedErrors predictedErrors(Method method, const PrefilterOptions& options, const ProbeTraits& probe);

/// The level at which the direct sum ends the lobe: all that is left out, were all of the probe's light there, is a tenth of the tolerance
/// where the probe is dark.
double directLevel(const PrefilterOptions& options, const ProbeTraits& probe);

/// Whether the direct method splits the lobe into a near and a far part, see near_far.h.
bool splitsKernel(const PrefilterOptions& options, const ProbeTraits& probe);

/// Lambda of the mip method: as asked for, else matched to the lobe.
double effectiveLambda(const PrefilterOptions& options, int latlongWidth);

} // namespace mirrorball
