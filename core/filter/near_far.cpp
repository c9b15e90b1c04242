#include "near_far.h"

#include "horizon_split.h"
#include "horizon_sum.h"
#include "kernel_split.h"
#include "near_sum.h"
#include "row_sums.h"
#include "truncation.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

namespace mirrorball {

namespace {

/// Relative error of the floats that near sums are made of; those of the far part are spectralRounding.
constexpr double nearRounding = 4e-7;

/// Share of what the tolerance leaves for the near sum's end, which changes numerator and denominator.
constexpr double leftOutShare = 0.7;

/// Share of what is allowed for reading rings; the kink at the horizon has as much, and they add up as squares.
constexpr double interpolationShare = 0.7;

/// Bright texels go through the lobe one by one, as with the spectral method, whose spectrum of the rest is shared then; and the kink at
/// the horizon, which they would show most, is exact for them.
constexpr size_t brightSplit = 1;

/// Degrees to which the kink at the horizon is looked at, in band limits.
constexpr int kinkReach = 2;

/// Seconds of one thread, measured beside those of the spectral method.
namespace cost {
constexpr double place = 1e-7, row = 1.4e-8, texel = 0.5e-9; // of the near sum
constexpr double run = 1.2e-8, runTexel = 1e-9;              // of the sum along the horizon
constexpr double sourceTexel = 6e-9;                         // its tables
constexpr double coefficient = 1e-8;                         // of the far kernel, times the band limit
constexpr double ring = 0.5e-9;                              // of the far part, times the band limit squared
} // namespace cost

double nearSeconds(double reach, int probeWidth, double places)
{
    const double rows = reach * probeWidth / pi + 1.0;
    return cost::sourceTexel * probeWidth * probeWidth / 2.0 +
           places * (cost::place + rows * cost::row + cost::texel * NearSum::texels(reach, probeWidth));
}

double horizonSeconds(double width, int probeWidth, double places)
{
    return cost::sourceTexel * probeWidth * probeWidth / 2.0 +
           places * (cost::run * HorizonSum::runs(probeWidth) + cost::runTexel * HorizonSum::texels(width, probeWidth));
}

double farSeconds(int bandLimit, double places)
{
    const double l = bandLimit, rings = 1.25 * l; // about what real probes ask for
    return (cost::coefficient + cost::ring * rings) * l * l + 1.2e-8 * rings * rings + 6e-8 * places;
}

/// The filtered map at some hundred even directions.
ValueDistribution coarseValues(const SettledNearFar& settled, const BrightLobe& bright, const JobControl& job)
{
    const SettledSpectral& far = settled.far;
    const CoarseLook look = lookCoarsely(*far.spectrum, far.k, far.longer, job);
    std::vector<glm::dvec4> sums(look.places.size());
    const std::span<const SpherePoint> places = look.places;
    parallelRows(static_cast<int>(places.size()), {.stop = job.stop, .progress = {}, .threads = job.threads}, [&](int first, int last) {
        const auto from = static_cast<size_t>(first);
        settled.near(places.subspan(from, static_cast<size_t>(last - first)), 0.0, sums.data() + from);
    });
    ValueDistribution values;
    for (size_t i = 0; i < look.places.size(); ++i) {
        const double norm = settled.farShare * look.rings.norm[i];
        const glm::dvec3 sum = look.rings.radiance(i) * norm + glm::dvec3(sums[i]) + bright.radiance(look.directions[i]);
        values.add(sum / (norm + sums[i].w), std::sin(look.places[i].colatitude));
    }
    return values;
}

SplitAt splitOf(const Lobe& lobe)
{
    if (isShortPolynomial(lobe))
        return SplitAt::Nowhere;
    switch (lobe.kind) {
    case LobeKind::Phong:
        return lobe.exponent <= HorizonSplit::largestExponent ? SplitAt::Horizon : SplitAt::Nowhere;
    case LobeKind::Ggx:
        return lobe.alpha > 0.0 ? SplitAt::Axis : SplitAt::Nowhere;
    case LobeKind::Diffuse:
    case LobeKind::Tabulated:
        break;
    }
    return SplitAt::Nowhere;
}

double horizonWidth(const NearFarPlan& plan) { return plan.sharpness / plan.bandLimit; }

/// By then the far part's spectrum has fallen below the rounding of floats.
constexpr double mostSharpness = 100.0;

/// What real probes ask for at a tolerance, about.
double usualSharpness(double tolerance) { return std::clamp(4.0 - 4.0 * std::log10(tolerance), 8.0, 40.0); }

/// What both kinds of split are to the rest.
struct Parts {
    std::vector<double> far{}; ///< Legendre coefficients, kinkReach band limits of them
    double miss = 0.0;         ///< what near and far are off by together, relative to the lobe
    std::function<void(std::span<const SpherePoint>, double, glm::dvec4*)> near{};
};

/// @param strictness  see settleNearFar()
Parts split(const Lobe& lobe, const NearFarPlan& plan, double strictness, const EnvironmentMap& latlong, const BrightTexels& bright,
            const JobControl& job)
{
    const auto sums = [](auto near) {
        return [near = std::make_shared<decltype(near)>(std::move(near))](std::span<const SpherePoint> places, double yaw, glm::dvec4* to) {
            near->at(places, yaw, to);
        };
    };
    const int last = kinkReach * plan.bandLimit;
    if (plan.at == SplitAt::Horizon) {
        const HorizonSplit parts(lobe, horizonWidth(plan));
        return {.far = parts.farCoefficients(last), .near = sums(HorizonSum(latlong, bright.changes, parts, job))};
    }
    const KernelSplit parts(lobe, plan.bandLimit, strictness * plan.leftOut);
    std::vector<double> far = parts.farCoefficients(last);
    const double miss = 2.0 * (1.0 + KernelSplit::polynomialShare) * std::max(parts.leftOut(), largestMiss(parts, far));
    return {.far = std::move(far), .miss = miss, .near = sums(NearSum(latlong, bright.changes, parts, job))};
}

} // namespace

NearFarPlan planNearFar(const PrefilterOptions& options, const ProbeTraits& probe, int least, double leastSharpness)
{
    NearFarPlan best;
    const Lobe& lobe = options.lobe;
    const double available = options.tolerance - nearRounding - spectralRounding;
    const SplitAt at = splitOf(lobe);
    if (at == SplitAt::Nowhere || probe.streamed || available < 0.2 * options.tolerance)
        return best;
    const double leftOut = std::min(0.1, 0.5 * leftOutShare * available),
                 texels = static_cast<double>(options.target.width()) * options.target.height() + CoarseLook::count;
    const double sharpness = std::max(leastSharpness, usualSharpness(options.tolerance));
    for (int step = 64; step <= largestBandLimit; step *= 2)
        for (const int bandLimit : {step, step * 3 / 2}) { // as FilterSource rounds them
            if (bandLimit < least || bandLimit > largestBandLimit ||
                (at == SplitAt::Horizon && sharpness > std::min<double>(bandLimit, mostSharpness)))
                continue;
            NearFarPlan plan{.at = at, .bandLimit = bandLimit, .leftOut = leftOut, .sharpness = sharpness};
            double near = 0.0;
            if (at == SplitAt::Axis) {
                const KernelSplit parts(lobe, bandLimit, leftOut);
                if (!parts.hasReach())
                    continue;
                near = nearSeconds(parts.reachAngle(), probe.width, texels);
            } else {
                near = horizonSeconds(horizonWidth(plan), probe.width, texels);
            }
            const double forward = probe.knownBandLimit >= bandLimit ? 0.0 : forwardSeconds(probe.width, bandLimit);
            plan.seconds = forward + farSeconds(bandLimit, texels) + near +
                           brightSeconds(lobe, brightSplits[brightSplit].mostTexels / 2, options.target);
            if (plan.seconds < best.seconds)
                best = plan;
        }
    return best;
}

SettledNearFar settleNearFar(FilterSource& source, const PrefilterOptions& options, const JobControl& job, double strictness)
{
    const ErrorLimits limits = errorLimits(options.tolerance);
    NearFarPlan plan = planNearFar(options, traits(source));
    const double mostSeconds = 4.0 * plan.seconds + 0.02; // beyond it another method is left to try
    const BrightTexels& bright = source.brightTexels(brightSplit, job);
    SettledNearFar settled;
    while (plan.possible()) {
        const int bandLimit = plan.bandLimit;
        Parts parts = split(options.lobe, plan, strictness, *source.latlong(), bright, job);
        std::vector<double>& k = parts.far;
        settled = {.farShare = k[0], .near = std::move(parts.near)};
        for (double& value : k)
            value /= settled.farShare;
        SettledSpectral& far = settled.far;
        far.k.assign(k.begin(), k.begin() + bandLimit + 1);
        far.longer = k;
        far.split = brightSplit;
        far.spectrum = &source.calmSpectrum(brightSplit, bandLimit, job);
        far.seconds = plan.seconds;
        far.relative = parts.miss + nearRounding;
        far.calmMean = meanOf(*far.spectrum);

        const ValueDistribution values = coarseValues(settled, BrightLobe(bright, options.lobe), job);
        const TruncationModel model(*far.spectrum, k);
        const double relative = spectralRounding + far.relative; // taken off what the limits allow the rest
        const ErrorLimits rest{.relRms = limits.relRms - relative,
                               .medianRel = limits.medianRel - relative,
                               .p99Rel = limits.p99Rel - relative,
                               .negative = limits.negative};
        const double allowed = 0.9 * strictness * std::max(0.0, values.allowedRms(model.shape(), rest)) / settled.farShare;
        far.rings = allowed > 0.0 ? std::min(largestRings, model.ringsFor(bandLimit, interpolationShare * allowed, model.shape()))
                                  : RingGrid::leastRings(2 * bandLimit);
        const glm::dvec3 kink = model.truncation(bandLimit), read = model.interpolation(bandLimit, far.rings);
        far.error = settled.farShare * glm::sqrt(kink * kink + read * read);
        far.normError = settled.farShare * model.normError(bandLimit);
        far.predicted = spectralErrors(values, far);
        // The bound on what is left out takes light for positive.
        const bool nonNegative = plan.at == SplitAt::Horizon || far.spectrum->least >= 0.0;
        far.keeps = nonNegative && far.predicted.within(limits);
        if (far.keeps || !nonNegative)
            return settled;
        const double excess = std::max({kink.r, kink.g, kink.b}) / std::max(interpolationShare * allowed, 1e-300);
        if (plan.at == SplitAt::Horizon) {
            // Beyond where the far part's spectrum begins to fall it falls like the sharpness to the power of some -5.
            const double sharpness = plan.sharpness * std::clamp(std::pow(1.5 * excess, 0.2), 1.15, 2.0);
            plan = planNearFar(options, traits(source), 0, sharpness);
        } else {
            // The kink's error falls like the band limit to the power of -2.5.
            const double least = bandLimit * std::max(1.1, std::pow(1.2 * excess, 0.4));
            if (least > largestBandLimit)
                return settled;
            plan = planNearFar(options, traits(source), static_cast<int>(least));
        }
        if (plan.seconds > mostSeconds)
            return settled;
    }
    return settled;
}

EnvironmentMap filterNearFar(FilterSource& source, const SettledNearFar& settled, const PrefilterOptions& options, const JobControl& job)
{
    const SettledSpectral& far = settled.far;
    EnvironmentMap map(options.target);
    const int width = map.image.width;
    const auto w = static_cast<size_t>(width);
    const std::span<const SpherePoint> points = source.points(options.target, job);
    const RingGrid grid(*far.spectrum, far.k, far.rings, options.yaw, {.stop = job.stop, .progress = {}, .threads = job.threads},
                        far.longer);
    const BrightLobe bright(source.brightTexels(far.split, job), options.lobe);
    parallelRows(
        map.image.height, job,
        [&](int first, int last) {
            const auto places = points.subspan(static_cast<size_t>(first) * w, static_cast<size_t>(last - first) * w);
            std::vector<float> rgbn(4 * places.size());
            std::vector<glm::dvec4> sums(places.size());
            grid.read(places, rgbn.data());
            settled.near(places, options.yaw, sums.data());
            float* to = map.image.row(first);
            for (size_t i = 0; i < places.size(); ++i) {
                glm::dvec3 seen(0.0);
                if (!bright.empty()) {
                    const int x = static_cast<int>(i % w), y = first + static_cast<int>(i / w);
                    seen = bright.radiance(yawed(texelDirection(options.target, x, y), -options.yaw));
                }
                const double norm = sums[i].w + settled.farShare * (1.0 + rgbn[4 * i + 3]);
                for (int c = 0; c < 3; ++c) { // what comes out below 0 stays so: it is for the check of the map to see
                    const double sum = sums[i][c] + settled.farShare * rgbn[4 * i + static_cast<size_t>(c)] + seen[c];
                    *to++ = static_cast<float>(sum / norm);
                }
            }
        },
        4);
    return map;
}

} // namespace mirrorball
