#include "method_parts.h"
#include "paraboloid_lattice.h"
#include "prefilter.h"
#include "reference.h"

#include "core/base/error.h"

#include <algorithm>

namespace mirrorball {

namespace {

ParaboloidKnobs resolvedKnobs(const PrefilterOptions& options, const ProbeTraits& probe)
{
    return resolved(options.knobs.paraboloid, probe.width / 2);
}

std::string refusal(const PrefilterOptions& options, const ProbeTraits& probe)
{
    // A lobe that needs no filtering is looked up whatever the method.
    if (options.lobe.isMirror() || isUnresolved(options.lobe, probe.width))
        return "";
    return paraboloidRefusal(options.lobe, resolvedKnobs(options, probe));
}

double seconds(const PrefilterOptions& options, const ProbeTraits& probe)
{
    return (probe.hasParaboloidDevice ? 1.0 : 2.0) *
           paraboloidSeconds(options.lobe, resolvedKnobs(options, probe), probe.width, static_cast<int>(targetTexels(options)));
}

TransferModel transfer(const PrefilterOptions& options, const ProbeTraits& probe)
{
    return paraboloidModel(options.lobe, resolvedKnobs(options, probe), std::min(4 * errorBandLimit(options.lobe, probe.width), 1024));
}

double error(const PrefilterOptions& options, const ProbeTraits& probe)
{
    if (probe.spectrum)
        return transferError(transfer(options, probe), probe);
    return paraboloidError(options.lobe, resolvedKnobs(options, probe));
}

EnvironmentMap run(FilterSource& source, const PrefilterOptions& options, const JobControl& job, PrefilterOutcome& outcome)
{
    const ParaboloidHalves halves = timedStage(outcome.stages, "paraboloid halves", [&] {
        return layOutHalves(*source.latlong(), options.lobe, resolved(options.knobs.paraboloid, source.height()), job);
    });
    const std::vector<glm::dvec3> directions = lookupDirections(options.target, options.yaw);
    const auto summed = [&](const char* stage, const ParaboloidSums& sums) {
        return timedStage(outcome.stages, stage, [&] { return toMap(options.target, paraboloidSums(halves, directions, sums, job)); });
    };
    std::string why = "no OpenGL device was given";
    if (ParaboloidDevice* device = source.paraboloidDevice()) {
        try {
            return summed("paraboloid sums", [&](std::span<const glm::dvec3> some) { return device->sum(halves, some, job); });
        } catch (const WorkError& error) {
            why = error.what();
        }
    }
    EnvironmentMap map = summed("paraboloid sums on the CPU", [&](std::span<const glm::dvec3> some) {
        const std::vector<glm::dvec3> sums = paraboloidSum(halves, some, job);
        return std::vector<glm::vec3>(sums.begin(), sums.end());
    });
    outcome.stages.back().why = why;
    return map;
}

constexpr std::array<std::string_view, 5> knobs{"paraboloid", "paraboloid_clamp", "paraboloid_kernel", "paraboloid_half",
                                                "paraboloid_border"};

} // namespace

constinit const MethodRow paraboloidMethod{
    .name = "paraboloid",
    .help = "sums under a circle in a dual paraboloid map, where a lobe is one: what a GPU does well",
    .knobs = knobs,
    .needsTexels = true,
    .followsTolerance = false,
    .spread = ErrorSpread{0.1, 5.0},
    .refusal = refusal,
    .seconds = seconds,
    .error = error,
    .transferModel = transfer,
    .bandLimit = noBandLimit,
    .run = run,
};

} // namespace mirrorball
