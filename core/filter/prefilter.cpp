#include "prefilter.h"

#include "band_limit.h"
#include "direct.h"
#include "hierarchical.h"
#include "importance.h"
#include "mip_blur.h"
#include "reference.h"
#include "sh9.h"
#include "spectral.h"

#include "core/base/error.h"
#include "core/image/reproject.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace mirrorball {

namespace {

template <typename Value>
EnvironmentMap toMap(const MapLayout& target, const std::vector<Value>& values)
{
    EnvironmentMap map(target);
    for (size_t i = 0; i < values.size(); ++i)
        for (int c = 0; c < 3; ++c)
            map.image.texels[3 * i + static_cast<size_t>(c)] = static_cast<float>(values[i][c]);
    return map;
}

EnvironmentMap lookUp(const EnvironmentMap& probe, const MapLayout& target, double yaw, const JobControl& job)
{
    EnvironmentMap map(target);
    parallelRows(map.image.height, job, [&](int first, int last) {
        for (int y = first; y < last; ++y)
            for (int x = 0; x < map.image.width; ++x) {
                const glm::vec3 value = probe.radiance(yawed(texelDirection(target, x, y), -yaw));
                std::copy_n(&value.x, 3, map.image.texel(x, y));
            }
    });
    return map;
}

EnvironmentMap runSpectral(FilterSource& source, const PrefilterOptions& options, const JobControl& job, PrefilterOutcome& outcome)
{
    const int knownBefore = source.knownBandLimit() + source.knownCalmBandLimit();
    const SettledBandLimit settled =
        timedStage(outcome.stages, "spectrum", [&] { return settleBandLimit(source, options.lobe, options.tolerance, job); });
    if (source.knownBandLimit() + source.knownCalmBandLimit() == knownBefore)
        outcome.stages.back() = {.name = "spectrum", .leftOut = true, .why = "kept from an earlier lobe"};
    outcome.bandLimit = settled.plan.bandLimit;
    outcome.predictedError = spectralError(settled.plan, options.target, options.tolerance, settled.spectrum->powerAboutMean());
    return timedStage(outcome.stages, "synthesis", [&] {
        const auto points =
            options.target.kind == Parameterization::Latlong ? std::span<const SpherePoint>{} : source.points(options.target, job);
        const BrightLobe bright(settled.split ? source.brightTexels() : BrightTexels{}, options.lobe);
        return filterSpectral(*settled.spectrum, settled.plan, bright, options.target, points, options.tolerance, options.yaw, job);
    });
}

EnvironmentMap runSh9(FilterSource& source, const PrefilterOptions& options, const JobControl& job, PrefilterOutcome& outcome)
{
    if (source.knownBandLimit() >= sh9BandLimit)
        outcome.stages.push_back({.name = "spectrum", .leftOut = true, .why = "kept from an earlier lobe"});
    else
        timedStage(outcome.stages, "spectrum", [&] { source.spectrum(source.latlong() ? sh9BandLimit : 2, job); });
    outcome.bandLimit = 2;
    outcome.predictedError = predictedError(Method::Sh9, options, traits(source));
    return timedStage(outcome.stages, "nine coefficients", [&] { return filterSh9(source.spectrum(2), options.target, options.yaw, job); });
}

EnvironmentMap runMip(FilterSource& source, const PrefilterOptions& options, const JobControl& job, PrefilterOutcome& outcome)
{
    const MipFiltering filtering = options.knobs.mipFiltering;
    const MipPyramid& pyramid =
        timedStage(outcome.stages, "mip pyramid of the environment",
                   [&]() -> std::reference_wrapper<const MipPyramid> { return source.blurPyramid(filtering, job); });
    const double lambda = effectiveLambda(options, source.width());
    return timedStage(outcome.stages, "mip lookup", [&] { return mipBlur(pyramid, filtering, lambda, options.target, options.yaw, job); });
}

EnvironmentMap runParaboloid(FilterSource& source, const PrefilterOptions& options, const JobControl& job, PrefilterOutcome& outcome)
{
    const ParaboloidHalves halves = timedStage(outcome.stages, "paraboloid halves", [&] {
        return layOutHalves(*source.latlong(), options.lobe, resolved(options.knobs.paraboloid, source.height()), job);
    });
    const std::vector<glm::dvec3> directions = lookupDirections(options.target, options.yaw);
    std::string why = "no OpenGL device was given";
    if (ParaboloidDevice* device = source.paraboloidDevice()) {
        try {
            return timedStage(outcome.stages, "paraboloid sums",
                              [&] { return toMap(options.target, device->sum(halves, directions, job)); });
        } catch (const WorkError& error) {
            why = error.what();
        }
    }
    EnvironmentMap map = timedStage(outcome.stages, "paraboloid sums on the CPU",
                                    [&] { return toMap(options.target, paraboloidSum(halves, directions, job)); });
    outcome.stages.back().why = why;
    return map;
}

EnvironmentMap run(Method method, FilterSource& source, const PrefilterOptions& options, const JobControl& job, PrefilterOutcome& outcome)
{
    std::vector<Stage>& stages = outcome.stages;
    switch (method) {
    case Method::Spectral:
        return runSpectral(source, options, job, outcome);
    case Method::Sh9:
        return runSh9(source, options, job, outcome);
    case Method::Mip:
        return runMip(source, options, job, outcome);
    case Method::Direct:
        return timedStage(stages, "direct sum", [&] {
            return toMap(options.target, directSum(*source.latlong(), options.lobe, lookupDirections(options.target, options.yaw),
                                                   {.level = directLevel(options.tolerance)}, job));
        });
    case Method::Hierarchical: {
        timedStage(stages, "pyramid of sums", [&] { source.radianceTree(job); });
        return timedStage(stages, "hierarchical sum", [&] {
            return toMap(options.target, hierarchicalSum(source.radianceTree(), options.lobe, lookupDirections(options.target, options.yaw),
                                                         {.tolerance = options.tolerance}, job)
                                             .values);
        });
    }
    case Method::Importance:
        timedStage(stages, "mip pyramid of the probe", [&] { source.lookupPyramid(job); });
        return timedStage(stages, "importance samples", [&] {
            return importanceSample(source.lookupPyramid(), options.lobe, options.knobs.samples, options.target, options.yaw, job);
        });
    case Method::Paraboloid:
        return runParaboloid(source, options, job, outcome);
    case Method::Reference:
    case Method::Auto:
        break;
    }
    return timedStage(stages, "reference sum", [&] {
        return toMap(options.target, referenceSum(*source.latlong(), options.lobe, lookupDirections(options.target, options.yaw), job));
    });
}

void validate(const PrefilterOptions& options)
{
    validate(options.target);
    if (!(options.tolerance > 0.0 && options.tolerance <= 1.0))
        throw InvalidArgument("tolerance: must lie in (0, 1]");
    if (!std::isfinite(options.yaw))
        throw InvalidArgument("yaw: must be a finite angle");
    if (options.knobs.samples < 1 || options.knobs.samples > (1 << 20))
        throw InvalidArgument("samples: must lie in [1, 1048576]");
    if (options.knobs.lambda && !(*options.knobs.lambda >= 0.0 && *options.knobs.lambda <= 32.0))
        throw InvalidArgument("lambda: must lie in [0, 32]");
}

PrefilterPlan planOf(Method method, const PrefilterOptions& options, const ProbeTraits& probe)
{
    return {.method = method,
            .bandLimit = predictedBandLimit(method, options),
            .predictedError = predictedError(method, options, probe),
            .predictedSeconds = predictedSeconds(method, options, probe)};
}

/// The cheapest method whose predicted error meets the tolerance. The error is predicted for as few as that takes, because predicting
/// costs something too.
PrefilterPlan cheapestPlan(const PrefilterOptions& options, const ProbeTraits& probe)
{
    struct Candidate {
        Method method;
        double seconds;
    };
    std::vector<Candidate> candidates;
    for (const Method method : allMethods)
        if (method != Method::Auto && (method != Method::Paraboloid || probe.hasParaboloidDevice) &&
            refusal(method, options, probe).empty())
            candidates.push_back({method, predictedSeconds(method, options, probe)});
    std::stable_sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) { return a.seconds < b.seconds; });

    std::ostringstream why;
    why.precision(3);
    PrefilterPlan closest{.predictedError = std::numeric_limits<double>::infinity()};
    for (const Candidate& candidate : candidates) {
        PrefilterPlan plan = planOf(candidate.method, options, probe);
        why << (candidate.method == candidates.front().method ? "predicted " : ", ") << plan.predictedSeconds * 1e3 << " ms "
            << name(plan.method);
        if (plan.predictedError <= options.tolerance) {
            plan.why = why.str();
            return plan;
        }
        why << " (error " << plan.predictedError << ')';
        if (plan.predictedError < closest.predictedError)
            closest = plan;
    }
    closest.why = why.str() + ": none meets the tolerance, " + std::string(name(closest.method)) + " comes closest";
    return closest;
}

} // namespace

PrefilterPlan planPrefilter(const PrefilterOptions& options, const ProbeTraits& probe)
{
    validate(options);
    if (const std::string why = refusal(options.method, options, probe); !why.empty())
        throw InvalidArgument(why);

    const bool blursByHand = options.method == Method::Mip && options.knobs.lambda; // whatever the lobe
    if (options.lobe.isMirror() && !blursByHand)
        return {.method = Method::Direct, .filtered = false, .why = "the lobe is a mirror: the probe is resampled, not filtered"};
    if (isUnresolved(options.lobe, probe.width) && !blursByHand) {
        std::ostringstream why;
        why.precision(3);
        why << "the lobe is " << 2.0 * LobeShape(options.lobe).halfWidth() / (2.0 * pi / probe.width)
            << " texels wide at half maximum, under 1.5: the map is the bilinear lookup";
        return {.method = Method::Direct, .filtered = false, .why = why.str()};
    }
    if (options.method == Method::Auto && !probe.streamed)
        return cheapestPlan(options, probe);
    PrefilterPlan plan = planOf(options.method == Method::Auto ? Method::Spectral : options.method, options, probe);
    plan.why = options.method == Method::Auto ? "the probe is read row by row" : "asked for";
    return plan;
}

PrefilterOutcome prefilter(FilterSource& source, const PrefilterOptions& options, const JobControl& job)
{
    const PrefilterPlan plan = planPrefilter(options, traits(source));
    PrefilterOutcome outcome{.method = plan.method, .filtered = plan.filtered, .predictedError = plan.predictedError, .why = plan.why};
    if (plan.filtered) {
        outcome.map = run(plan.method, source, options, job, outcome);
        return outcome;
    }
    if (!source.latlong())
        throw InvalidArgument("lobe: too narrow to filter a probe that is read row by row; use convert");
    outcome.stages.push_back({.name = "filter", .leftOut = true, .why = plan.why});
    outcome.map = timedStage(outcome.stages, "resample", [&] {
        return options.lobe.isMirror() ? reproject(*source.latlong(), {.target = options.target, .yaw = options.yaw}, job)
                                       : lookUp(*source.latlong(), options.target, options.yaw, job);
    });
    return outcome;
}

double informedError(const PrefilterOutcome& outcome, const PrefilterOptions& options, FilterSource& source, const JobControl& job)
{
    const Method method = outcome.method;
    if (!outcome.filtered || (method != Method::Importance && method != Method::Mip && method != Method::Sh9))
        return outcome.predictedError;
    constexpr int enough = 256; // beyond it a spectrum goes on at the level of its last degrees
    if (source.latlong())
        source.spectrum(enough, job);
    return predictedError(method, options, traits(source));
}

double chainRoughness(int level, int levels) { return levels > 1 ? static_cast<double>(level) / (levels - 1) : 0.0; }

} // namespace mirrorball
