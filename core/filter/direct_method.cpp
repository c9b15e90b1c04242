#include "direct.h"
#include "method_parts.h"
#include "near_far.h"
#include "prefilter.h"
#include "reference.h"
#include "row_sums.h"

#include <algorithm>

namespace mirrorball {

namespace {

/// The sum over all texels under the lobe.
double wholeSumSeconds(const PrefilterOptions& options, const ProbeTraits& probe)
{
    constexpr double texel = 2e-7, term = 1.2e-8;
    return targetTexels(options) * (texel + term * directTaps(options.lobe, probe.width, {.level = directLevel(options, probe)}));
}

double seconds(const PrefilterOptions& options, const ProbeTraits& probe)
{
    if (isShortPolynomial(options.lobe))
        return rowSumsSeconds(probe.width, static_cast<int>(targetTexels(options)));
    return std::min(wholeSumSeconds(options, probe), planNearFar(options, probe).seconds);
}

double error(const PrefilterOptions& options, const ProbeTraits& probe)
{
    if (splitsKernel(options, probe))
        return 0.9 * options.tolerance; // at most; settleNearFar() tells better
    return isShortPolynomial(options.lobe) ? floatRounding : floatRounding + 0.1 * options.tolerance; // see directLevel()
}

/// Of a lobe that is not split: where it is, prefilter() settles and checks its parts.
EnvironmentMap run(FilterSource& source, const PrefilterOptions& options, const JobControl& job, PrefilterOutcome& outcome)
{
    return timedStage(outcome.stages, "direct sum", [&] {
        return toMap(options.target, directSum(*source.latlong(), options.lobe, lookupDirections(options.target, options.yaw),
                                               {.level = directLevel(options, traits(source))}, job));
    });
}

} // namespace

double directLevel(const PrefilterOptions& options, const ProbeTraits& probe)
{
    const double peak = 4.0 * pi / LobeShape(options.lobe).integral(); // of the lobe over that of a constant
    return std::min(1e-3, 0.1 * options.tolerance * std::clamp(probe.dark, 1e-6, 1.0) / peak);
}

bool splitsKernel(const PrefilterOptions& options, const ProbeTraits& probe)
{
    return !isShortPolynomial(options.lobe) && planNearFar(options, probe).seconds < wholeSumSeconds(options, probe);
}

constinit const MethodRow directMethod{
    .name = "direct",
    .help = "the sum over the texels under the lobe; of a long tail or a steep start over the near ones, with a spectrum for the rest",
    .knobs = {},
    .needsTexels = true,
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
