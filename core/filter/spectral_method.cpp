#include "band_limit.h"
#include "bright_texels.h"
#include "method_parts.h"
#include "spectral.h"

namespace mirrorball {

namespace {

/// What the spectral method is expected to do before the probe has been looked at for this lobe: a usual probe's power, or its own as far
/// as it is known. settleSpectral() tells better.
BandLimitPlan expected(const PrefilterOptions& options, const ProbeTraits& probe)
{
    std::vector<double> k = legendreCoefficients(options.lobe, firstCoefficients);
    const BandLimitPlan plan = planBandLimit(k, options.tolerance);
    const bool splits = splitsBrightTexels(options.lobe);
    if (!splits || plan.bandLimit <= 64)
        return plan;
    for (int length = firstCoefficients;; length *= 2) {
        const BandLimitPlan longer = planBandLimit(k, 0.5 * options.tolerance, continuedPower(probe.calmSpectrum, length, usualPower));
        if (longer.predictedError <= 0.5 * options.tolerance || length >= 2 * largestBandLimit)
            return longer;
        k = legendreCoefficients(options.lobe, 2 * length);
    }
}

double seconds(const PrefilterOptions& options, const ProbeTraits& probe)
{
    const BandLimitPlan plan = expected(options, probe);
    return spectrumSeconds(probe, plan.bandLimit) + inverseSeconds(plan.bandLimit, 4 * plan.bandLimit, options.target);
}

double error(const PrefilterOptions& options, const ProbeTraits& probe)
{
    return spectralError(expected(options, probe), options.target, options.tolerance);
}

int bandLimit(const PrefilterOptions& options)
{
    return planBandLimit(legendreCoefficients(options.lobe, firstCoefficients), options.tolerance).bandLimit;
}

/// The method itself is settled, compared with others and checked by prefilter(), step by step; where that does not keep the tolerance, the
/// sum over all texels is what remains.
EnvironmentMap run(FilterSource& source, const PrefilterOptions& options, const JobControl& job, PrefilterOutcome& outcome)
{
    return referenceMethod.run(source, options, job, outcome);
}

} // namespace

constinit const MethodRow spectralMethod{
    .name = "spectral",
    .help = "a product per degree of the probe's spherical harmonics, followed as far as the tolerance asks for",
    .knobs = {},
    .needsTexels = false,
    .followsTolerance = true,
    .spread = {},
    .refusal = noRefusal,
    .seconds = seconds,
    .error = error,
    .transferModel = noTransferModel,
    .bandLimit = bandLimit,
    .run = run,
};

/// Costs and misses no more than the spectral method, which it falls back on.
constinit const MethodRow autoMethod{
    .name = "auto",
    .help = "the cheapest method that keeps the tolerance",
    .knobs = {},
    .needsTexels = false,
    .followsTolerance = true,
    .spread = {},
    .refusal = noRefusal,
    .seconds = seconds,
    .error = error,
    .transferModel = noTransferModel,
    .bandLimit = noBandLimit,
    .run = run,
};

} // namespace mirrorball
