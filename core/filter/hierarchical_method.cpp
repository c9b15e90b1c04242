#include "direct.h"
#include "hierarchical.h"
#include "lobe_row.h"
#include "method_parts.h"
#include "prefilter.h"
#include "reference.h"

#include <algorithm>
#include <cmath>

namespace mirrorball {

namespace {

std::string refusal(const PrefilterOptions&, const ProbeTraits& probe) { return pyramidRefusal(hierarchicalMethod.name, probe); }

/// Terms of the sum a direction: they grow as the tolerance shrinks, up to all the texels under the lobe. A long tail is cut into blocks
/// until they are as small as their distance from the peak, however narrow that is.
double termsOf(const PrefilterOptions& options, int width)
{
    const double most = directTaps(options.lobe, width, {.level = 0.1 * options.tolerance});
    const double peak = std::min(most, 2000.0 * std::pow(1e-2 / options.tolerance, 0.75));
    const double tail = rowOf(options.lobe.kind).hasLongTail ? 5000.0 * std::pow(1e-2 / options.tolerance, 0.27) : 0.0;
    return std::max(peak, std::min(tail, 0.25 * width * width)); // no more than all above the horizon
}

double seconds(const PrefilterOptions& options, const ProbeTraits& probe)
{
    constexpr double texel = 1.8e-7, term = 4e-8;
    return texel * probeTexels(probe) + term * targetTexels(options) * termsOf(options, probe.width);
}

double error(const PrefilterOptions& options, const ProbeTraits&) { return floatRounding + 0.5 * options.tolerance; }

EnvironmentMap run(FilterSource& source, const PrefilterOptions& options, const JobControl& job, PrefilterOutcome& outcome)
{
    timedStage(outcome.stages, "pyramid of sums", [&] { source.radianceTree(job); });
    return timedStage(outcome.stages, "hierarchical sum", [&] {
        return toMap(options.target, hierarchicalSum(source.radianceTree(), options.lobe, lookupDirections(options.target, options.yaw),
                                                     {.tolerance = options.tolerance}, job)
                                         .values);
    });
}

} // namespace

constinit const MethodRow hierarchicalMethod{
    .name = "hierarchical",
    .help = "the sum over blocks of texels, as coarse as the lobe and the tolerance let them be",
    .knobs = {},
    .needsTexels = true,
    .followsTolerance = true,
    .spread = {},
    .refusal = refusal,
    .seconds = seconds,
    .error = error,
    .transferModel = noTransferModel,
    .bandLimit = noBandLimit,
    .run = run,
};

} // namespace mirrorball
