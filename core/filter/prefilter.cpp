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

constexpr std::array<std::string_view, allMethods.size()> methodNames{"auto", "reference", "spectral", "direct"};

/// Band limits are rounded up to steps when a spectrum is made, so that the next lobe, a little narrower, finds what it needs.
int roundedUp(int bandLimit)
{
    int step = 32;
    while (step < bandLimit)
        step = step * 3 / 2 <= bandLimit || step * 3 / 2 % 16 != 0 ? step * 2 : step * 3 / 2;
    return std::min(step, std::max(bandLimit, largestBandLimit));
}

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

EnvironmentMap toMap(const MapLayout& target, const std::vector<glm::dvec3>& values)
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

/// rel_rms of `copy`, looked up at the texels of `original`; over a part of them, which is enough for a figure.
double differenceAtTexels(const EnvironmentMap& original, const EnvironmentMap& copy)
{
    const int step = std::max(1, original.image.height / 128);
    double difference = 0.0, power = 0.0;
    for (int y = 0; y < original.image.height; y += step)
        for (int x = 0; x < original.image.width; x += step) {
            const double solidAngle = texelSolidAngle(original.layout, x, y);
            if (solidAngle <= 0.0)
                continue;
            const float* t = original.image.texel(x, y);
            const glm::dvec3 value(t[0], t[1], t[2]);
            const glm::dvec3 error = glm::dvec3(copy.radiance(texelDirection(original.layout, x, y))) - value;
            difference += solidAngle * glm::dot(error, error);
            power += solidAngle * glm::dot(value, value);
        }
    return power > 0.0 ? std::sqrt(difference / power) : 0.0;
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

} // namespace

std::string_view name(Method method)
{
    return methodNames[static_cast<size_t>(method)];
}

std::optional<Method> methodFromName(std::string_view word)
{
    for (const Method method : allMethods)
        if (name(method) == word)
            return method;
    return std::nullopt;
}

int latlongHeight(const MapLayout& layout)
{
    switch (layout.kind) {
    case Parameterization::Latlong: return layout.size;
    case Parameterization::Cube: return 3 * layout.size;
    case Parameterization::Sphere: return 2 * layout.size;
    case Parameterization::Angular: return layout.size;
    case Parameterization::Paraboloid: return 2 * layout.size;
    case Parameterization::Octahedral: return 2 * layout.size;
    }
    return layout.size;
}

FilterSource::FilterSource(EnvironmentMap probe, const JobControl& job)
{
    if (probe.layout.kind != Parameterization::Latlong) {
        EnvironmentMap latlong =
            reproject(probe, {.target = {.kind = Parameterization::Latlong, .size = latlongHeight(probe.layout)}}, job);
        m_resamplingError = differenceAtTexels(probe, latlong);
        probe = std::move(latlong);
    }
    m_width = probe.image.width;
    m_height = probe.image.height;
    m_latlong = std::make_shared<const EnvironmentMap>(std::move(probe));
}

FilterSource::FilterSource(Spectrum spectrum) : m_width(spectrum.ringLength), m_height(spectrum.rings)
{
    m_spectrum = std::make_shared<const Spectrum>(std::move(spectrum));
}

const Spectrum& FilterSource::spectrum(int bandLimit, const JobControl& job)
{
    if (!m_spectrum || m_spectrum->bandLimit < bandLimit) {
        if (!m_latlong)
            throw WorkError("spectrum: the probe was read up to band limit " + std::to_string(m_spectrum->bandLimit) + ", but " +
                            std::to_string(bandLimit) + " is needed; load it whole");
        m_spectrum = std::make_shared<const Spectrum>(analyse(*m_latlong, roundedUp(bandLimit), job));
    }
    return *m_spectrum;
}

const Spectrum& FilterSource::calmSpectrum(int bandLimit, const JobControl& job)
{
    if (!m_calm) {
        auto calm = std::make_shared<EnvironmentMap>(*m_latlong);
        m_bright = takeBrightTexels(*calm);
        m_calm = std::move(calm);
    }
    if (!m_calmSpectrum || m_calmSpectrum->bandLimit < bandLimit)
        m_calmSpectrum = std::make_shared<const Spectrum>(analyse(*m_calm, roundedUp(bandLimit), job));
    return *m_calmSpectrum;
}

std::span<const SpherePoint> FilterSource::points(const MapLayout& target, const JobControl& job)
{
    if (!m_points || m_pointsLayout != target) {
        m_points = std::make_shared<const std::vector<SpherePoint>>(spherePoints(target, job));
        m_pointsLayout = target;
    }
    return *m_points;
}

PrefilterPlan planPrefilter(const PrefilterOptions& options, int width, bool streamed, int knownBandLimit)
{
    validate(options.target);
    if (!(options.tolerance > 0.0 && options.tolerance <= 1.0))
        throw InvalidArgument("tolerance: must lie in (0, 1]");
    if (!std::isfinite(options.yaw))
        throw InvalidArgument("yaw: must be a finite angle");

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
                                 .predictedSeconds = spectralSeconds(usualLimit, width, texels, knownBandLimit)};
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
    case Method::Auto:
        plan = spectral;
        if (!streamed && direct.predictedError <= options.tolerance && direct.predictedSeconds < spectral.predictedSeconds)
            plan = direct;
        if (streamed)
            why << "the probe is read row by row";
        else
            why << "predicted " << spectral.predictedSeconds * 1e3 << " ms spectral against " << direct.predictedSeconds * 1e3
                << " ms direct";
        break;
    }
    if (streamed && plan.method != Method::Spectral)
        throw InvalidArgument("method: '" + std::string(name(plan.method)) + "' needs the whole probe in memory; use auto or spectral");
    plan.why = why.str();
    return plan;
}

PrefilterOutcome prefilter(FilterSource& source, const PrefilterOptions& options, const JobControl& job)
{
    const PrefilterPlan plan = planPrefilter(options, source.width(), source.latlong() == nullptr,
                                             std::max(source.knownBandLimit(), source.knownCalmBandLimit()));
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
