#include "prefilter.h"

#include "band_limit.h"
#include "method_row.h"
#include "near_far.h"
#include "source_file.h"
#include "spectral.h"
#include "tolerance_words.h"

#include "core/base/error.h"
#include "core/image/reproject.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <sstream>

namespace mirrorball {

namespace {

/// Of an outcome or a plan.
template <typename Predicting>
void setPredicted(Predicting& p, const PredictedErrors& errors, bool promised)
{
    p.predicted = errors;
    p.promised = promised;
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

/// One map by the spectral method, as it was settled.
EnvironmentMap synthesizeMap(FilterSource& source, const SettledSpectral& settled, const PrefilterOptions& options, const JobControl& job)
{
    const auto points =
        options.target.kind == Parameterization::Latlong ? std::span<const SpherePoint>{} : source.points(options.target, job);
    const BrightLobe bright(source.brightTexels(settled.split, job), options.lobe);
    return filterSpectral(*settled.spectrum, settled.k, settled.rings, bright, options.target, points, options.yaw, job, settled.longer);
}

/// How much a finished map misses what was promised: the largest ratio of a predicted error to its limit, or of how far it goes below 0.
/// Only a probe that has no negative light itself promises to keep from it.
struct MapCheck {
    PredictedErrors predicted;
    double excess;
};

float leastOf(const std::vector<float>& values)
{
    constexpr size_t lanes = 16; // so that the compiler makes vectors of them
    std::array<float, lanes> least;
    least.fill(values.empty() ? 0.0f : values.front());
    size_t i = 0;
    for (; i + lanes <= values.size(); i += lanes)
        for (size_t k = 0; k < lanes; ++k)
            least[k] = std::min(least[k], values[i + k]);
    for (; i < values.size(); ++i)
        least[0] = std::min(least[0], values[i]);
    return *std::min_element(least.begin(), least.end());
}

MapCheck check(const EnvironmentMap& map, const SettledSpectral& settled, double tolerance)
{
    const ValueDistribution values = ValueDistribution::of(map);
    const ErrorLimits limits = errorLimits(tolerance);
    MapCheck result{.predicted = spectralErrors(values, settled), .excess = 0.0};
    result.excess = std::max(
        {result.predicted.relRms / limits.relRms, result.predicted.medianRel / limits.medianRel, result.predicted.p99Rel / limits.p99Rel});
    const double least = leastOf(map.image.texels);
    const bool nonNegative = settled.spectrum->least >= 0.0;
    if (nonNegative && least < 0.0)
        result.excess = std::max(result.excess, -least / (limits.negative * std::max(values.mean(), std::numeric_limits<double>::min())));
    return result;
}

const SettledSpectral& spectralPart(const SettledSpectral& settled) { return settled; }
const SettledSpectral& spectralPart(const SettledNearFar& settled) { return settled.far; }

/// The map, where what was settled turns out to keep the tolerance; else nothing.
/// @param make  the map, of what was settled
/// @param again  settles it with this strictness
template <typename Settled, typename Make, typename Again>
std::optional<EnvironmentMap> checkedMap(Settled settled, const char* stage, double tolerance, PrefilterOutcome& outcome, Make&& make,
                                         Again&& again)
{
    double strictness = 1.0;
    constexpr int mostTries = 3;
    for (int tries = 0; tries < mostTries && spectralPart(settled).keeps; ++tries) {
        EnvironmentMap map = timedStage(outcome.stages, stage, [&] { return make(settled); });
        const MapCheck checked = check(map, spectralPart(settled), tolerance);
        if (checked.excess <= 1.0) {
            outcome.bandLimit = spectralPart(settled).bandLimit();
            setPredicted(outcome, checked.predicted, true);
            return map;
        }
        outcome.stages.back().why = "once more: the map is darker than its spectrum let expect";
        strictness *= std::clamp(0.5 / checked.excess, 1e-4, 0.5);
        settled = again(strictness);
    }
    return std::nullopt;
}

std::optional<EnvironmentMap> runSpectral(FilterSource& source, const SettledSpectral& settled, const PrefilterOptions& options,
                                          const JobControl& job, PrefilterOutcome& outcome)
{
    return checkedMap(
        settled, "synthesis", options.tolerance, outcome, [&](const SettledSpectral& s) { return synthesizeMap(source, s, options, job); },
        [&](double strictness) { return settleSpectral(source, options, job, strictness); });
}

/// The direct method's map of a lobe that is split into near and far, where that keeps the tolerance; else nothing.
std::optional<EnvironmentMap> runNearFar(FilterSource& source, const PrefilterOptions& options, const JobControl& job,
                                         PrefilterOutcome& outcome)
{
    const SettledNearFar settled =
        timedStage(outcome.stages, "spectrum of the far part", [&] { return settleNearFar(source, options, job); });
    std::optional<EnvironmentMap> map = checkedMap(
        settled, "near sums and far part", options.tolerance, outcome,
        [&](const SettledNearFar& s) { return filterNearFar(source, s, options, job); },
        [&](double strictness) { return settleNearFar(source, options, job, strictness); });
    if (!map)
        outcome.stages.back().why = "near and far part do not keep the tolerance for this probe";
    return map;
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
    PrefilterPlan plan{
        .method = method, .bandLimit = predictedBandLimit(method, options), .predictedSeconds = predictedSeconds(method, options, probe)};
    PredictedErrors errors = predictedErrors(method, options, probe);
    const ErrorLimits limits = errorLimits(options.tolerance);
    // The spectrum of a smooth lobe ends, and is followed as far as the probe turns out to need it.
    if (method == Method::Spectral && !splitsBrightTexels(options.lobe))
        errors = {std::min(errors.relRms, limits.relRms), std::min(errors.medianRel, limits.medianRel),
                  std::min(errors.p99Rel, limits.p99Rel)};
    setPredicted(plan, errors, keepsTolerance(method) && errors.within(limits));
    return plan;
}

/// The cheapest method that keeps the tolerance by what is predicted. The error is predicted for as few as that takes, because predicting
/// costs something too.
/// @param except  methods that are out of the question
PrefilterPlan cheapestPlan(const PrefilterOptions& options, const ProbeTraits& probe, const std::vector<Method>& except = {})
{
    struct Candidate {
        Method method;
        double seconds;
    };
    std::vector<Candidate> candidates;
    for (const Method method : allMethods)
        if (method != Method::Auto && keepsTolerance(method) && refusal(method, options, probe).empty() &&
            std::find(except.begin(), except.end(), method) == except.end())
            candidates.push_back({method, predictedSeconds(method, options, probe)});
    std::stable_sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) { return a.seconds < b.seconds; });

    std::ostringstream why;
    why.precision(3);
    PrefilterPlan closest{.predicted = {.relRms = std::numeric_limits<double>::infinity()}};
    for (const Candidate& candidate : candidates) {
        PrefilterPlan plan = planOf(candidate.method, options, probe);
        why << (candidate.method == candidates.front().method ? "predicted " : ", ") << plan.predictedSeconds * 1e3 << " ms "
            << name(plan.method);
        if (plan.promised) {
            plan.why = why.str();
            return plan;
        }
        why << " (error " << plan.predicted.relRms << ')';
        if (plan.predicted.relRms < closest.predicted.relRms)
            closest = plan;
    }
    closest.why = why.str() + ": none meets the tolerance, " + std::string(name(closest.method)) + " comes closest";
    return closest;
}

} // namespace

/// Relative error of a bilinear lookup in floats.
constexpr double floatLookup = 1.5e-7;

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
        PrefilterPlan lookup{.method = Method::Direct, .filtered = false, .why = why.str()};
        setPredicted(lookup, {floatLookup, floatLookup, 10.0 * floatLookup}, true);
        return lookup;
    }
    if (options.method == Method::Auto && !probe.streamed)
        return cheapestPlan(options, probe);
    PrefilterPlan plan = planOf(options.method == Method::Auto ? Method::Spectral : options.method, options, probe);
    plan.why = options.method == Method::Auto ? "the probe is read row by row" : "asked for";
    return plan;
}

namespace {

/// What follows once the spectral method, which the plan chose, is settled: it, or for auto another method that is cheaper or the only one
/// to keep the tolerance.
/// @param except  spectral, and what has turned out not to keep it
PrefilterPlan afterSettling(PrefilterPlan plan, const SettledSpectral& settled, const PrefilterOptions& options, const ProbeTraits& probe,
                            const std::vector<Method>& except)
{
    std::ostringstream text;
    text.precision(3);
    const bool mayChange = options.method == Method::Auto && !probe.streamed;
    if (mayChange) {
        const PrefilterPlan other = cheapestPlan(options, probe, except);
        if (other.promised && (!settled.keeps || other.predictedSeconds < settled.seconds)) {
            PrefilterPlan changed = other;
            text << other.why << (settled.keeps ? "; spectral would take " : "; spectral does not keep the tolerance: ");
            if (settled.keeps)
                text << settled.seconds * 1e3 << " ms";
            else
                text << "median_rel " << settled.predicted.medianRel << " at band limit " << settled.bandLimit();
            changed.why = text.str();
            return changed;
        }
    }
    plan.bandLimit = settled.bandLimit();
    setPredicted(plan, settled.predicted, settled.keeps);
    return plan;
}

} // namespace

PrefilterOutcome prefilter(FilterSource& source, const PrefilterOptions& options, const JobControl& job)
{
    PrefilterPlan plan = planPrefilter(options, traits(source));
    PrefilterOutcome outcome{.filtered = plan.filtered};
    if (!plan.filtered) {
        outcome.method = plan.method;
        outcome.why = plan.why;
        setPredicted(outcome, plan.predicted, plan.promised);
        if (!source.latlong())
            throw InvalidArgument(
                "lobe: too narrow to filter a probe that is read row by row, or of which there is a spectrum; use convert on "
                "the probe itself");
        outcome.stages.push_back({.name = "filter", .leftOut = true, .why = plan.why});
        outcome.map = timedStage(outcome.stages, "resample", [&] {
            return options.lobe.isMirror() ? reproject(*source.latlong(), {.target = options.target, .yaw = options.yaw}, job)
                                           : lookUp(*source.latlong(), options.target, options.yaw, job);
        });
        return outcome;
    }
    const bool mayChange = options.method == Method::Auto && !traits(source).streamed;
    const auto splits = [&] { return plan.method == Method::Direct && splitsKernel(options, traits(source)); };
    std::optional<EnvironmentMap> map;
    std::vector<Method> failed;
    const auto trySplit = [&] {
        map = runNearFar(source, options, job, outcome);
        if (!map)
            failed.push_back(Method::Direct); // what is left of it is the sum over all texels, for who asks for that by name
    };
    if (splits()) {
        trySplit();
        if (!map && mayChange)
            plan = cheapestPlan(options, traits(source), failed);
    }
    if (plan.method == Method::Spectral) {
        const int knownBefore = source.knownBandLimits();
        const SettledSpectral settled = timedStage(outcome.stages, "spectrum", [&] { return settleSpectral(source, options, job); });
        if (source.knownBandLimits() == knownBefore)
            outcome.stages.back() = {.name = "spectrum", .leftOut = true, .why = "kept from an earlier lobe"};
        const PrefilterPlan spectral = plan;
        failed.push_back(Method::Spectral); // it is compared with the others from here on
        plan = afterSettling(spectral, settled, options, traits(source), failed);
        if (splits()) {
            trySplit();
            if (!map)
                plan = afterSettling(spectral, settled, options, traits(source), failed);
        }
        if (plan.method == Method::Spectral) {
            map = runSpectral(source, settled, options, job, outcome);
            if (!map && !mayChange)
                throw InvalidArgument(cannotKeep(options, settled, traits(source)));
            if (!map)
                plan = cheapestPlan(options, traits(source), failed);
            if (!map && splits()) {
                trySplit();
                if (!map)
                    plan = cheapestPlan(options, traits(source), failed);
            }
        }
    }
    outcome.method = plan.method;
    outcome.why = plan.why;
    if (!map) {
        setPredicted(outcome, plan.predicted, plan.promised);
        map = rowOf(plan.method).run(source, options, job, outcome);
    }
    outcome.map = std::move(*map);
    return outcome;
}

PredictedErrors informedErrors(const PrefilterOutcome& outcome, const PrefilterOptions& options, FilterSource& source,
                               const JobControl& job)
{
    const Method method = outcome.method;
    if (!outcome.filtered || keepsTolerance(method))
        return outcome.predicted;
    if (!source.latlong())
        return predictedErrors(method, options, traits(source));
    constexpr int enough = 256; // beyond it a spectrum goes on at the level of its last degrees
    const Spectrum& spectrum = source.spectrum(enough, job);
    const ProbeTraits probe = traits(source);
    const TransferModel model = transferModel(method, options, probe);
    return spreadErrors(*source.latlong(), spectrum, options.lobe, model, transferError(model, probe), job);
}

double chainRoughness(int level, int levels) { return levels > 1 ? static_cast<double>(level) / (levels - 1) : 0.0; }

} // namespace mirrorball
