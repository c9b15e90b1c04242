#include "method_parts.h"
#include "mip_blur.h"
#include "prefilter.h"

#include <algorithm>
#include <cmath>

namespace mirrorball {

namespace {

double seconds(const PrefilterOptions& options, const ProbeTraits& probe)
{
    constexpr double texel = 1.3e-7, lookup = 1.2e-7;
    const MapLayout cube = environmentCube(probe.width);
    return texel * cube.width() * cube.height() + lookup * targetTexels(options);
}

TransferModel transfer(const PrefilterOptions& options, const ProbeTraits& probe)
{
    const int bandLimit = errorBandLimit(options.lobe, probe.width);
    const MapLayout environment = environmentCube(probe.width), &target = options.target;
    const double natural =
        0.5 * std::log2(6.0 * environment.size * environment.size / (static_cast<double>(target.width()) * target.height()));
    const double level = std::max(effectiveLambda(options, probe.width), natural);
    TransferModel model{.k = legendreCoefficients(options.lobe, bandLimit),
                        .bias = mipTransfer(level, environment, bandLimit),
                        .scatter = mipScatter(level, environment, bandLimit),
                        .blurs = mipBlurs(level, environment)};
    for (size_t l = 0; l < model.k.size(); ++l)
        model.bias[l] -= model.k[l];
    return model;
}

double error(const PrefilterOptions& options, const ProbeTraits& probe) { return transferError(transfer(options, probe), probe); }

EnvironmentMap run(FilterSource& source, const PrefilterOptions& options, const JobControl& job, PrefilterOutcome& outcome)
{
    const MipFiltering filtering = options.knobs.mipFiltering;
    timedStage(outcome.stages, "mip pyramid of the environment", [&] { source.blurPyramid(filtering, job); });
    const MipPyramid& pyramid = source.blurPyramid(filtering, job); // which keeps it
    const double lambda = effectiveLambda(options, source.width());
    return timedStage(outcome.stages, "mip lookup", [&] { return mipBlur(pyramid, filtering, lambda, options.target, options.yaw, job); });
}

constexpr std::array<std::string_view, 2> knobs{"lambda", "mip_filtering"};

} // namespace

double effectiveLambda(const PrefilterOptions& options, int latlongWidth)
{
    return options.knobs.lambda ? *options.knobs.lambda : matchedLambda(options.lobe, environmentCube(latlongWidth));
}

constinit const MethodRow mipMethod{
    .name = "mip",
    .help = "one lookup in the mip pyramid of the environment, at a level as wide as the lobe",
    .knobs = knobs,
    .needsTexels = true,
    .followsTolerance = false,
    .spread = ErrorSpread{0.16, 2.8},
    .refusal = noRefusal,
    .seconds = seconds,
    .error = error,
    .transferModel = transfer,
    .bandLimit = noBandLimit,
    .run = run,
};

} // namespace mirrorball
