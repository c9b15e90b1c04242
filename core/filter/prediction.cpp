#include "prediction.h"

#include "method_parts.h"

#include <algorithm>

namespace mirrorball {

namespace {

/// What a degree holds at most in a probe without negative texels, the mean being 1: all of it in one direction.
double largestPower(int l) { return 2.0 * l + 1.0; }

} // namespace

ProbeTraits traits(const FilterSource& source)
{
    return {.width = source.width(),
            .streamed = source.latlong() == nullptr,
            .knownBandLimit = std::max(source.knownBandLimit(), source.knownCalmBandLimit()),
            .dark = source.dark(),
            .hasParaboloidDevice = source.paraboloidDevice() != nullptr,
            .spectrum = source.knownSpectrum(),
            .calmSpectrum = source.knownCalmSpectrum()};
}

std::string refusal(Method method, const PrefilterOptions& options, const ProbeTraits& probe)
{
    const MethodRow& row = rowOf(method);
    if (probe.streamed && row.needsTexels)
        return refuser(row.name) + "needs the whole probe in memory; use auto or spectral";
    return row.refusal(options, probe);
}

int predictedBandLimit(Method method, const PrefilterOptions& options) { return rowOf(method).bandLimit(options); }

double predictedSeconds(Method method, const PrefilterOptions& options, const ProbeTraits& probe)
{
    return rowOf(method).seconds(options, probe);
}

double predictedError(Method method, const PrefilterOptions& options, const ProbeTraits& probe)
{
    return rowOf(method).error(options, probe);
}

TransferModel transferModel(Method method, const PrefilterOptions& options, const ProbeTraits& probe)
{
    return rowOf(method).transferModel(options, probe);
}

double transferError(const TransferModel& model, const ProbeTraits& probe)
{
    return model.relRms(continuedPower(probe.spectrum, static_cast<int>(model.k.size()) - 1, largestPower));
}

PredictedErrors predictedErrors(Method method, const PrefilterOptions& options, const ProbeTraits& probe)
{
    const double relRms = predictedError(method, options, probe);
    if (const std::optional<ErrorSpread>& spread = rowOf(method).spread)
        return {relRms, spread->median * relRms, spread->p99 * relRms};
    const ErrorLimits limits = errorLimits(options.tolerance);
    return {relRms, relRms, std::max(relRms, relRms / options.tolerance * limits.p99Rel)};
}

} // namespace mirrorball
