#include "prefilter.h"

#include "direct.h"
#include "reference.h"
#include "spectral.h"

#include "../error.h"
#include "../image/reproject.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace mirrorball {

namespace {

/// Seconds on one core of a current server; only their ratios matter, to choose a method (see tests/benchmarks).
double spectralSeconds(int bandLimit, int width, int texels, int knownBandLimit)
{
    const double l = bandLimit, rings = width / 2.0;
    const double forward = knownBandLimit >= bandLimit ? 0.0 : 8e-9 * width * rings * 3 + 0.5e-9 * l * l * rings;
    return forward + 0.6e-9 * l * l * l + 1e-7 * l * l + 6e-8 * texels;
}

double directSeconds(const Lobe& lobe, int width, int texels, double level)
{
    return texels * (2e-7 + 1.2e-8 * directTaps(lobe, width, {.level = level}));
}

/// The level that leaves out less than the tolerance, and little enough that the dark beside a sun is right.
double directLevel(double tolerance)
{
    return std::min(1e-3, 1e-7 * tolerance);
}

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

/// Lobes with a long spectrum of their own, whose kernel is cheap, are applied to the bright texels one by one (BrightTexels).
bool splitsBrightTexels(const Lobe& lobe)
{
    return lobe.kind != LobeKind::Phong || lobe.exponent < 8.0;
}

/// The bright texels are divided by the norm, whose own harmonics beyond the length of a row are felt on probes narrower than this: k_l
/// of a kinked lobe is 9e-6 at 128 columns, 3e-7 at 512.
constexpr int smallProbe = 512;

/// Coefficients looked at first: they settle every band limit up to half their number.
constexpr int firstLength = 768;

/// The spectrum a lobe needs, and how far. A slowly decaying lobe is followed step by step: each look at the probe's own power
/// tells whether a longer spectrum is worth its time.
struct Settled {
    BandLimitPlan plan{};
    const Spectrum* spectrum = nullptr;
    bool split = false;
};

Settled settleBandLimit(FilterSource& source, const PrefilterOptions& options, const JobControl& job)
{
    std::vector<double> k = legendreCoefficients(options.lobe, firstLength);
    BandLimitPlan plan = planBandLimit(k, options.tolerance);
    if (!source.latlong()) { // streamed: what was read is all there is
        const Spectrum& all = source.spectrum(0);
        if (plan.bandLimit > all.bandLimit) {
            plan = planBandLimit(k, options.tolerance, all);
            plan.bandLimit = std::min(plan.bandLimit, all.bandLimit);
            plan.k.resize(static_cast<size_t>(plan.bandLimit) + 1);
        }
        return {plan, &all};
    }
    const bool split = splitsBrightTexels(options.lobe);
    if (plan.bandLimit <= firstLength / 2) { // short whatever the probe holds
        const bool calmIsThere = split && source.width() >= smallProbe && source.knownBandLimit() < plan.bandLimit &&
                                 source.knownCalmBandLimit() >= plan.bandLimit;
        return {plan, calmIsThere ? &source.calmSpectrum(plan.bandLimit, job) : &source.spectrum(plan.bandLimit, job), calmIsThere};
    }

    const int leastForNorm = split && source.width() < smallProbe ? 2 * source.width() : 0;
    constexpr int firstLook = 128;
    // The calm part is held to the tolerance by itself: the dark side of a sunlit map is all its own.
    int next = std::max(firstLook, split ? source.knownCalmBandLimit() : source.knownBandLimit());
    for (;;) {
        const Spectrum& spectrum = split ? source.calmSpectrum(next, job) : source.spectrum(next, job);
        plan = planBandLimit(k, options.tolerance, spectrum, leastForNorm);
        if (plan.bandLimit <= spectrum.bandLimit)
            return {plan, &spectrum, split};
        next = std::min(2 * spectrum.bandLimit, plan.bandLimit);
        if (static_cast<int>(k.size()) < 2 * next)
            k = legendreCoefficients(options.lobe, 2 * next);
    }
}

EnvironmentMap runSpectral(FilterSource& source, const PrefilterOptions& options, const JobControl& job, PrefilterOutcome& outcome)
{
    const int knownBefore = source.knownBandLimit() + source.knownCalmBandLimit();
    const Settled settled = timedStage(outcome.stages, "spectrum", [&] { return settleBandLimit(source, options, job); });
    if (source.knownBandLimit() + source.knownCalmBandLimit() == knownBefore)
        outcome.stages.back() = {.name = "spectrum", .leftOut = true, .why = "kept from an earlier lobe"};
    outcome.bandLimit = settled.plan.bandLimit;
    outcome.predictedError = std::max(settled.plan.predictedError, 0.4 * options.tolerance);
    return timedStage(outcome.stages, "synthesis", [&] {
        const auto points = options.target.kind == Parameterization::Latlong ? std::span<const SpherePoint>{}
                                                                             : source.points(options.target, job);
        const BrightLobe bright(settled.split ? source.brightTexels() : BrightTexels{}, options.lobe);
        return filterSpectral(*settled.spectrum, settled.plan, bright, options.target, points, options.tolerance, options.yaw, job);
    });
}

ParaboloidKnobs paraboloidKnobs(const PrefilterOptions& options, int width)
{
    return resolved(options.knobs.paraboloid, width / 2);
}

EnvironmentMap runParaboloid(FilterSource& source, const PrefilterOptions& options, const JobControl& job, PrefilterOutcome& outcome)
{
    const ParaboloidHalves halves = timedStage(outcome.stages, "paraboloid halves", [&] {
        return layOutHalves(*source.latlong(), options.lobe, paraboloidKnobs(options, source.width()), job);
    });
    return timedStage(outcome.stages, "paraboloid sums", [&] {
        return toMap(options.target, source.paraboloidDevice()->sum(halves, lookupDirections(options.target, options.yaw), job));
    });
}

} // namespace

ProbeTraits traits(const FilterSource& source)
{
    return {.width = source.width(),
            .streamed = source.latlong() == nullptr,
            .knownBandLimit = std::max(source.knownBandLimit(), source.knownCalmBandLimit()),
            .hasParaboloidDevice = source.paraboloidDevice() != nullptr};
}

std::string refusal(Method method, const PrefilterOptions& options, const ProbeTraits& probe)
{
    const std::string who = "method: '" + std::string(name(method)) + "' ";
    if (probe.streamed && method != Method::Spectral && method != Method::Auto)
        return who + "needs the whole probe in memory; use auto or spectral";
    switch (method) {
    case Method::Auto:
    case Method::Reference:
    case Method::Spectral:
    case Method::Direct: return "";
    case Method::Paraboloid:
        if (!probe.hasParaboloidDevice)
            return who + "runs on a GPU and none was given; use another method";
        // A lobe that needs no filtering is looked up whatever the method.
        return options.lobe.isMirror() || isUnresolved(options.lobe, probe.width)
                   ? ""
                   : paraboloidRefusal(options.lobe, paraboloidKnobs(options, probe.width));
    case Method::Hierarchical:
    case Method::Importance:
    case Method::Mip:
    case Method::Sh9: break;
    }
    return who + "is not built yet; use auto";
}

PrefilterPlan planPrefilter(const PrefilterOptions& options, const ProbeTraits& probe)
{
    validate(options.target);
    if (!(options.tolerance > 0.0 && options.tolerance <= 1.0))
        throw InvalidArgument("tolerance: must lie in (0, 1]");
    if (!std::isfinite(options.yaw))
        throw InvalidArgument("yaw: must be a finite angle");
    if (const std::string why = refusal(options.method, options, probe); !why.empty())
        throw InvalidArgument(why);
    const int width = probe.width;

    std::ostringstream why;
    why.precision(3);
    if (options.lobe.isMirror())
        return {.method = Method::Direct, .filtered = false, .why = "the lobe is a mirror: the probe is resampled, not filtered"};
    if (isUnresolved(options.lobe, width)) {
        why << "the lobe is " << 2.0 * LobeShape(options.lobe).halfWidth() / (2.0 * pi / width)
            << " texels wide at half maximum, under 1.5: the map is the bilinear lookup";
        return {.method = Method::Direct, .filtered = false, .why = why.str()};
    }

    const int texels = options.target.width() * options.target.height();
    const BandLimitPlan band = planBandLimit(legendreCoefficients(options.lobe, firstLength), options.tolerance);
    const double level = directLevel(options.tolerance);
    // A lobe that decays slowly whatever the probe holds is hardly ever followed that far: its bright texels are taken out.
    const int usualLimit = splitsBrightTexels(options.lobe) ? std::min(band.bandLimit, firstLength / 3) : band.bandLimit;
    const PrefilterPlan spectral{.method = Method::Spectral,
                                 .bandLimit = band.bandLimit,
                                 .predictedError = std::max(band.predictedError, 0.4 * options.tolerance),
                                 .predictedSeconds = spectralSeconds(usualLimit, width, texels, probe.knownBandLimit)};
    const PrefilterPlan direct{.method = Method::Direct,
                               .predictedError = directTruncation(options.lobe, {.level = level}),
                               .predictedSeconds = directSeconds(options.lobe, width, texels, level)};
    PrefilterPlan plan;
    switch (options.method) {
    case Method::Reference:
        plan = {.method = Method::Reference, .predictedSeconds = 5e-9 * width * (width / 2.0) * texels};
        why << "asked for";
        break;
    case Method::Spectral:
        plan = spectral;
        why << "asked for";
        break;
    case Method::Direct:
        plan = direct;
        why << "asked for";
        break;
    case Method::Paraboloid:
        plan = {.method = Method::Paraboloid,
                .predictedError = paraboloidError(options.lobe, paraboloidKnobs(options, width)),
                .predictedSeconds = paraboloidSeconds(options.lobe, paraboloidKnobs(options, width), width, texels)};
        why << "asked for";
        break;
    case Method::Hierarchical:
    case Method::Importance:
    case Method::Mip:
    case Method::Sh9:
    case Method::Auto:
        plan = spectral;
        if (!probe.streamed && direct.predictedError <= options.tolerance && direct.predictedSeconds < spectral.predictedSeconds)
            plan = direct;
        if (probe.streamed)
            why << "the probe is read row by row";
        else
            why << "predicted " << spectral.predictedSeconds * 1e3 << " ms spectral against " << direct.predictedSeconds * 1e3
                << " ms direct";
        break;
    }
    plan.why = why.str();
    return plan;
}

PrefilterOutcome prefilter(FilterSource& source, const PrefilterOptions& options, const JobControl& job)
{
    const PrefilterPlan plan = planPrefilter(options, traits(source));
    PrefilterOutcome outcome{.method = plan.method, .filtered = plan.filtered, .predictedError = plan.predictedError, .why = plan.why};
    if (!plan.filtered) {
        if (!source.latlong())
            throw InvalidArgument("lobe: too narrow to filter a probe that is read row by row; use convert");
        outcome.stages.push_back({.name = "filter", .leftOut = true, .why = plan.why});
        outcome.map = timedStage(outcome.stages, "resample", [&] {
            return options.lobe.isMirror() ? reproject(*source.latlong(), {.target = options.target, .yaw = options.yaw}, job)
                                           : lookUp(*source.latlong(), options.target, options.yaw, job);
        });
        return outcome;
    }
    switch (plan.method) {
    case Method::Spectral: outcome.map = runSpectral(source, options, job, outcome); break;
    case Method::Direct:
        outcome.map = timedStage(outcome.stages, "direct sum", [&] {
            return toMap(options.target, directSum(*source.latlong(), options.lobe, lookupDirections(options.target, options.yaw),
                                                   {.level = directLevel(options.tolerance)}, job));
        });
        break;
    case Method::Paraboloid:
        outcome.map = runParaboloid(source, options, job, outcome);
        break;
    case Method::Hierarchical:
    case Method::Importance:
    case Method::Mip:
    case Method::Sh9:
    case Method::Reference:
    case Method::Auto:
        outcome.map = timedStage(outcome.stages, "reference sum", [&] {
            return toMap(options.target,
                         referenceSum(*source.latlong(), options.lobe, lookupDirections(options.target, options.yaw), job));
        });
        break;
    }
    return outcome;
}

double chainRoughness(int level, int levels)
{
    return levels > 1 ? static_cast<double>(level) / (levels - 1) : 0.0;
}

} // namespace mirrorball
