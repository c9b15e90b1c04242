#pragma once

#include "filter_source.h"
#include "method.h"
#include "prediction.h"
#include "transfer_model.h"

#include "core/base/job.h"
#include "core/image/environment_map.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace mirrorball {

struct PrefilterOutcome;

/// How the error of a method that approximates is spread over a probe that was not looked at: its median and its 99th percentile over
/// rel_rms. Geometric means over five lobes and four test probes of 256 x 128, from which a probe with much dark or a sun differs by up to
/// a factor of ten; spreadErrors() looks.
struct ErrorSpread {
    double median, p99;
};

/// All that the library knows of a filtering method: one row, in the method's own file (<name>_method.cpp), from which plans, predictions
/// and prefilter(), command line and forms know it. Its functions are references and nothing has a default, so that a row which lacks
/// something does not compile.
struct MethodRow {
    std::string_view name;                   ///< the word of files and of the command line
    std::string_view help;                   ///< one line, no full stop
    std::span<const std::string_view> knobs; ///< the fields of MethodKnobs that belong to it
    bool needsTexels;                        ///< works on the probe's texels; else on its spectrum, which a probe read row by row has too
    bool followsTolerance;                   ///< a smaller tolerance costs it more: the tolerance is its knob
    std::optional<ErrorSpread> spread;       ///< of a method that approximates; empty: it keeps a tolerance or refuses

    /// Why it cannot do this, beside that it needs the texels: a whole line. Empty where it can.
    std::string (&refusal)(const PrefilterOptions& options, const ProbeTraits& probe);
    /// See predictedSeconds() and predictedError().
    double (&seconds)(const PrefilterOptions& options, const ProbeTraits& probe);
    double (&error)(const PrefilterOptions& options, const ProbeTraits& probe);
    /// What it puts in the lobe's place, where it approximates; else noTransferModel().
    TransferModel (&transferModel)(const PrefilterOptions& options, const ProbeTraits& probe);
    /// See predictedBandLimit().
    int (&bandLimit)(const PrefilterOptions& options);
    /// Makes the map, and notes its stages; the outcome has its prediction already.
    EnvironmentMap (&run)(FilterSource& source, const PrefilterOptions& options, const JobControl& job, PrefilterOutcome& outcome);
};

extern const MethodRow autoMethod, referenceMethod, spectralMethod, directMethod, hierarchicalMethod, importanceMethod, paraboloidMethod,
    mipMethod, sh9Method;

const MethodRow& rowOf(Method method);

} // namespace mirrorball
