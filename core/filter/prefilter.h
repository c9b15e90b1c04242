#pragma once

#include "filter_source.h"
#include "lobe.h"
#include "method.h"
#include "prediction.h"

#include "core/base/job.h"
#include "core/base/stage.h"
#include "core/image/environment_map.h"

#include <string>
#include <vector>

/// Prefiltering: the one interface over the methods. Each method has a file of its own; `Auto` chooses among them.
namespace mirrorball {

/// What was done, and how well.
struct PrefilterOutcome {
    EnvironmentMap map{};
    Method method = Method::Auto; ///< the one that ran
    bool filtered = true;         ///< false: mirror or unresolved lobe, the map is a lookup of the probe
    int bandLimit = 0;            ///< of spectral, and of the far part where direct splits the lobe
    PredictedErrors predicted{};  ///< against the reference sum; where the lobe is unresolved against the bilinear lookup
    bool promised = false;        ///< the tolerance is kept, see errorLimits(); never by a method that only approximates
    std::string why{};            ///< why this method
    std::vector<Stage> stages{};
};

/// What prefilter() would do, decided without doing it.
struct PrefilterPlan {
    Method method = Method::Auto;
    bool filtered = true;
    int bandLimit = 0; ///< spectral: from the lobe alone, until it is settled
    PredictedErrors predicted{};
    bool promised = false;         ///< the tolerance is kept
    double predictedSeconds = 0.0; ///< of one thread, see predictedSeconds()
    std::string why{};
};

/// @throws InvalidArgument naming the field; for a method that refuses, with the reason
PrefilterPlan planPrefilter(const PrefilterOptions& options, const ProbeTraits& probe);

/// The filtered map of a probe, in the chosen parameterization.
/// A tolerance is a promise (errorLimits()): auto, spectral, direct, hierarchical and reference keep it or refuse.
/// @throws InvalidArgument naming the field, also where a method cannot keep the tolerance; Cancelled
PrefilterOutcome prefilter(FilterSource& source, const PrefilterOptions& options, const JobControl& job = {});

/// What the method that ran expects its error to be, now that the probe may be looked at: those that approximate read it off the probe's
/// spectrum and texels (spreadErrors()), which they do not need for their work, so that the outcome's own figures bound it for any probe.
PredictedErrors informedErrors(const PrefilterOutcome& outcome, const PrefilterOptions& options, FilterSource& source,
                               const JobControl& job = {});

/// One line that says of a map that its tolerance is not promised, and what is predicted of it.
std::string unpromisedText(const PrefilterOptions& options, const PrefilterOutcome& outcome);

/// Roughness of level i of a ggx chain of n levels: i/(n-1), so that the base is a mirror and the last level is fully rough.
/// alpha is its square.
double chainRoughness(int level, int levels);

} // namespace mirrorball
