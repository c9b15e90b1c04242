#include "method_parts.h"
#include "prefilter.h"
#include "sh9.h"

namespace mirrorball {

namespace {

std::string refusal(const PrefilterOptions& options, const ProbeTraits&)
{
    if (options.lobe.kind == LobeKind::Diffuse)
        return "";
    return refuser(sh9Method.name) + "does the diffuse lobe only, and lobe is " + describe(options.lobe) + "; use auto or spectral";
}

double seconds(const PrefilterOptions& options, const ProbeTraits& probe)
{
    constexpr double texel = 8e-8;
    return spectrumSeconds(probe, sh9BandLimit) + texel * targetTexels(options);
}

TransferModel transfer(const PrefilterOptions& options, const ProbeTraits&)
{
    TransferModel model{.k = legendreCoefficients(options.lobe, sh9BandLimit)};
    for (size_t l = 0; l < model.k.size(); ++l)
        model.bias.push_back(l > 2 ? -model.k[l] : 0.0);
    model.scatter.resize(model.k.size());
    return model;
}

double error(const PrefilterOptions& options, const ProbeTraits& probe) { return transferError(transfer(options, probe), probe); }

int bandLimit(const PrefilterOptions&) { return 2; }

EnvironmentMap run(FilterSource& source, const PrefilterOptions& options, const JobControl& job, PrefilterOutcome& outcome)
{
    if (source.knownBandLimit() >= sh9BandLimit)
        outcome.stages.push_back({.name = "spectrum", .leftOut = true, .why = "kept from an earlier lobe"});
    else
        timedStage(outcome.stages, "spectrum", [&] { source.spectrum(source.latlong() ? sh9BandLimit : 2, job); });
    outcome.bandLimit = 2;
    outcome.predicted = predictedErrors(Method::Sh9, options, traits(source)); // the probe is known better by now
    outcome.promised = false;
    return timedStage(outcome.stages, "nine coefficients", [&] { return filterSh9(source.spectrum(2), options.target, options.yaw, job); });
}

} // namespace

constinit const MethodRow sh9Method{
    .name = "sh9",
    .help = "nine coefficients of the probe's spectrum; the diffuse lobe only",
    .knobs = {},
    .needsTexels = false,
    .followsTolerance = false,
    .spread = ErrorSpread{1.0, 15.0},
    .refusal = refusal,
    .seconds = seconds,
    .error = error,
    .transferModel = transfer,
    .bandLimit = bandLimit,
    .run = run,
};

} // namespace mirrorball
