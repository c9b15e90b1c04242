#include "lobe_row.h"
#include "method_parts.h"
#include "prefilter.h"
#include "reference.h"

namespace mirrorball {

namespace {

double seconds(const PrefilterOptions& options, const ProbeTraits& probe)
{
    constexpr double power = 1e-8, products = 2e-9; // a texel of the probe under a texel of the target
    return (rowOf(options.lobe.kind).isProduct ? products : power) * probeTexels(probe) * targetTexels(options);
}

double error(const PrefilterOptions&, const ProbeTraits&) { return floatRounding; }

EnvironmentMap run(FilterSource& source, const PrefilterOptions& options, const JobControl& job, PrefilterOutcome& outcome)
{
    return timedStage(outcome.stages, "reference sum", [&] {
        return toMap(options.target, referenceSum(*source.latlong(), options.lobe, lookupDirections(options.target, options.yaw), job));
    });
}

} // namespace

constinit const MethodRow referenceMethod{
    .name = "reference",
    .help = "the sum over every texel, which all methods are measured against",
    .knobs = {},
    .needsTexels = true,
    .followsTolerance = false,
    .spread = {},
    .refusal = noRefusal,
    .seconds = seconds,
    .error = error,
    .transferModel = noTransferModel,
    .bandLimit = noBandLimit,
    .run = run,
};

} // namespace mirrorball
