#include "prediction.h"

#include "band_limit.h"
#include "bright_texels.h"
#include "direct.h"
#include "importance.h"
#include "mip_blur.h"
#include "near_far.h"
#include "row_sums.h"
#include "sh9.h"
#include "spectral.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace mirrorball {

namespace {

/// Seconds of one thread. `build/ci/bin/method_table methods` shows them beside what is measured.
namespace cost {
constexpr double referencePower = 1e-8, referenceProducts = 2e-9; // a texel of the probe under a texel of the target
constexpr double directTexel = 2e-7, directTerm = 1.2e-8;
constexpr double treeTexel = 1.8e-7, treeTerm = 4e-8;
constexpr double lookupTexel = 9e-8, lookupSample = 4e-8;
constexpr double blurTexel = 1.3e-7, blurLookup = 1.2e-7;
constexpr double sh9Texel = 8e-8;
} // namespace cost

/// Relative error of a map stored as floats.
constexpr double floatRounding = 6e-8;

/// What a degree holds at most in a probe without negative texels, the mean being 1: all of it in one direction.
double largestPower(int l) { return 2.0 * l + 1.0; }

/// The power of each degree, 0 .. bandLimit: the probe's own where it is known, continued at the level of its last degrees.
/// @param unknown  stands for the power of degrees 1 and up of a probe that was not looked at
std::vector<double> power(const std::shared_ptr<const Spectrum>& spectrum, int bandLimit, double (&unknown)(int))
{
    std::vector<double> result;
    if (!spectrum) {
        result.push_back(1.0);
        for (int l = 1; l <= bandLimit; ++l)
            result.push_back(unknown(l));
        return result;
    }
    result = spectrum->powerAboutMean();
    const int known = static_cast<int>(result.size()) - 1;
    double tail = 0.0, weights = 0.0; // power per degree over the last third
    for (int l = std::max(1, known * 2 / 3); l <= known; ++l) {
        tail += result[static_cast<size_t>(l)];
        weights += 1.0;
    }
    result.resize(static_cast<size_t>(bandLimit) + 1, weights > 0.0 ? tail / weights : 0.0);
    return result;
}

/// Degrees that a lobe's error is looked for in: as far as it passes anything, and the blur of a texel does.
int errorBandLimit(const Lobe& lobe, int width)
{
    const double halfWidth = std::max(LobeShape(lobe).halfWidth(), pi / width);
    return std::clamp(static_cast<int>(6.0 / halfWidth), 8, 1024);
}

TransferModel sh9Model(const PrefilterOptions& options)
{
    TransferModel model{.k = legendreCoefficients(options.lobe, sh9BandLimit)};
    for (size_t l = 0; l < model.k.size(); ++l)
        model.bias.push_back(l > 2 ? -model.k[l] : 0.0);
    model.scatter.resize(model.k.size());
    return model;
}

TransferModel mipModel(const PrefilterOptions& options, const ProbeTraits& probe)
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

/// Mean square over headings of a trilinear lookup's transfer at degree l: tents, sinc^2(l h/2) along each axis of the texels, on a
/// level's boxes. It falls off far less than the Gauss function of the same variance.
double lookupTransferSquare(const LobeSample& sample, double h, double l)
{
    const double whole = std::floor(sample.level), fraction = sample.level - whole;
    const auto sinc = [](double x) { return std::abs(x) > 1e-6 ? std::sin(x) / x : 1.0; };
    const auto atWhole = [&](double n, double heading) {
        const double texel = std::exp2(n) * h, x = sinc(0.5 * l * texel * std::cos(heading)), y = sinc(0.5 * l * texel * std::sin(heading));
        const double tent = x * x * y * y;
        return n > 0.0 ? tent * x * y : tent;
    };
    constexpr int headings = 6;
    double square = 0.0;
    for (int i = 0; i < headings; ++i) {
        const double heading = 0.25 * pi * (i + 0.5) / headings;
        const double transfer =
            (1.0 - fraction) * atWhole(whole, heading) + (fraction > 0.0 ? fraction * atWhole(whole + 1.0, heading) : 0.0);
        square += transfer * transfer / headings;
    }
    return square;
}

/// The samples' mean transfer differs from the lobe's by their blur. About that mean they scatter like random ones above the frequency of
/// their spacing, and hardly below it, the spiral being nearly a lattice:
///   E|kappa_lm - mean|^2 summed over m = 1/N^2 sum_i t_l(i)^2 S(l spacing_i),  S(x) = x^6/(x^6 + x_0^6)
/// with t_l the transfer of a lookup: what they scatter has the frequencies of the texels, however wide the lobe. A square lattice's first
/// frequency is x_0 = 2 pi.
TransferModel importanceModel(const PrefilterOptions& options, const ProbeTraits& probe)
{
    const int count = options.knobs.samples;
    const int lobeLimit = errorBandLimit(options.lobe, probe.width), bandLimit = std::max(lobeLimit, 2 * probe.width);
    const double h = 2.0 * pi / probe.width;
    TransferModel model{.k = legendreCoefficients(options.lobe, lobeLimit)};
    const std::vector<LobeSample> all = lobeSamples(options.lobe, count, std::max(1, probe.width / 2));
    constexpr size_t enough = 512; // samples stand in order of their radius
    const size_t step = std::max<size_t>(1, all.size() / enough);
    constexpr double x0 = 6.0; // fits the test probes best
    std::vector<double> mean(model.k.size());
    std::vector<const LobeSample*> some;
    for (size_t i = step / 2; i < all.size(); i += step)
        some.push_back(&all[i]);
    for (const LobeSample* s : some) {
        double previous = 0.0, p = 1.0;
        for (size_t l = 0; l < mean.size(); ++l) {
            const double d = static_cast<double>(l);
            mean[l] += std::exp(-0.5 * d * (d + 1.0) * s->variance) * p / static_cast<double>(some.size());
            previous = std::exchange(p, ((2.0 * d + 1.0) * s->z * p - d * previous) / (d + 1.0));
        }
    }
    model.k.resize(static_cast<size_t>(bandLimit) + 1, 0.0);
    double scatter = 0.0;
    for (size_t l = 0; l < model.k.size(); ++l) {
        if (l == 0 || l % std::max<size_t>(1, l / 16) == 0) { // it is smooth
            scatter = 0.0;
            for (size_t i = 0; i < some.size(); i += 8) {
                const double x = static_cast<double>(l) * std::sqrt(some[i]->cell) / x0, x6 = std::pow(x, 6);
                scatter += lookupTransferSquare(*some[i], h, static_cast<double>(l)) * x6 / (1.0 + x6);
            }
            scatter /= static_cast<double>((some.size() + 7) / 8) * count;
        }
        model.bias.push_back(l < mean.size() ? mean[l] - model.k[l] : 0.0);
        model.scatter.push_back(scatter);
    }
    return model;
}

/// What the spectral method is expected to do before the probe has been looked at for this lobe: a usual probe's power, or its own as far
/// as it is known. settleSpectral() tells better.
BandLimitPlan expectedSpectral(const PrefilterOptions& options, const ProbeTraits& probe)
{
    std::vector<double> k = legendreCoefficients(options.lobe, firstCoefficients);
    const BandLimitPlan plan = planBandLimit(k, options.tolerance);
    const bool splits = splitsBrightTexels(options.lobe);
    if (!splits || plan.bandLimit <= 64)
        return plan;
    for (int length = firstCoefficients;; length *= 2) {
        const BandLimitPlan longer = planBandLimit(k, 0.5 * options.tolerance, power(probe.calmSpectrum, length, usualPower));
        if (longer.predictedError <= 0.5 * options.tolerance || length >= 2 * largestBandLimit)
            return longer;
        k = legendreCoefficients(options.lobe, 2 * length);
    }
}

/// Terms of the hierarchical sum a direction: they grow as the tolerance shrinks, up to all the texels under the lobe. A long tail is cut
/// into blocks until they are as small as their distance from the peak, however narrow that is.
double hierarchicalTerms(const PrefilterOptions& options, int width)
{
    const double most = directTaps(options.lobe, width, {.level = 0.1 * options.tolerance});
    const double peak = std::min(most, 2000.0 * std::pow(1e-2 / options.tolerance, 0.75));
    const double tail = options.lobe.kind == LobeKind::Ggx ? 5000.0 * std::pow(1e-2 / options.tolerance, 0.27) : 0.0;
    return std::max(peak, std::min(tail, 0.25 * width * width)); // no more than all above the horizon
}

/// The sum over all texels under the lobe.
double wholeSumSeconds(const PrefilterOptions& options, const ProbeTraits& probe)
{
    const double texels = static_cast<double>(options.target.width()) * options.target.height();
    return texels * (cost::directTexel + cost::directTerm * directTaps(options.lobe, probe.width, {.level = directLevel(options, probe)}));
}

} // namespace

ProbeTraits traits(const FilterSource& source)
{
    return {.width = source.width(),
            .streamed = source.latlong() == nullptr,
            .knownBandLimit = std::max(source.knownBandLimit(), source.knownCalmBandLimit()),
            .dark = source.dark(),
            .hasParaboloidDevice = source.paraboloidDevice() != nullptr,
            .spectrum = source.knownSpectrum(),
            .calmSpectrum = source.knownCalmSpectrum()};
}

std::string refusal(Method method, const PrefilterOptions& options, const ProbeTraits& probe)
{
    const std::string who = "method: '" + std::string(name(method)) + "' ";
    const bool needsTexels = method != Method::Auto && method != Method::Spectral && method != Method::Sh9;
    if (probe.streamed && needsTexels)
        return who + "needs the whole probe in memory; use auto or spectral";
    // A lobe that needs no filtering is looked up whatever the method.
    if (method == Method::Paraboloid && !options.lobe.isMirror() && !isUnresolved(options.lobe, probe.width))
        return paraboloidRefusal(options.lobe, resolved(options.knobs.paraboloid, probe.width / 2));
    constexpr int widest = 8192; // 1.4 GB of nodes, 0.7 GB of texels
    if ((method == Method::Hierarchical || method == Method::Importance) && probe.width > widest)
        return who + "holds a pyramid of the probe in memory and width " + std::to_string(probe.width) + " is too large for it, at most " +
               std::to_string(widest) + "; use auto or spectral";
    if (method == Method::Sh9 && options.lobe.kind != LobeKind::Diffuse)
        return who + "does the diffuse lobe only, and lobe is " + describe(options.lobe) + "; use auto or spectral";
    return "";
}

double directLevel(const PrefilterOptions& options, const ProbeTraits& probe)
{
    const double peak = 4.0 * pi / LobeShape(options.lobe).integral(); // of the lobe over that of a constant
    return std::min(1e-3, 0.1 * options.tolerance * std::clamp(probe.dark, 1e-6, 1.0) / peak);
}

double effectiveLambda(const PrefilterOptions& options, int latlongWidth)
{
    return options.knobs.lambda ? *options.knobs.lambda : matchedLambda(options.lobe, environmentCube(latlongWidth));
}

bool splitsKernel(const PrefilterOptions& options, const ProbeTraits& probe)
{
    return !isShortPolynomial(options.lobe) && planNearFar(options, probe).seconds < wholeSumSeconds(options, probe);
}

int predictedBandLimit(Method method, const PrefilterOptions& options)
{
    if (method == Method::Spectral)
        return planBandLimit(legendreCoefficients(options.lobe, firstCoefficients), options.tolerance).bandLimit;
    return method == Method::Sh9 ? 2 : 0;
}

double predictedSeconds(Method method, const PrefilterOptions& options, const ProbeTraits& probe)
{
    const double rings = probe.width / 2.0, sources = probe.width * rings;
    const double texels = static_cast<double>(options.target.width()) * options.target.height();
    const auto forward = [&](int l) { return probe.knownBandLimit >= l ? 0.0 : forwardSeconds(probe.width, l); };
    switch (method) {
    case Method::Auto:
    case Method::Spectral: {
        const BandLimitPlan plan = expectedSpectral(options, probe);
        return forward(plan.bandLimit) + inverseSeconds(plan.bandLimit, 4 * plan.bandLimit, options.target);
    }
    case Method::Reference: {
        const bool isProduct = options.lobe.kind == LobeKind::Diffuse || options.lobe.kind == LobeKind::Ggx;
        return (isProduct ? cost::referenceProducts : cost::referencePower) * sources * texels;
    }
    case Method::Direct:
        if (isShortPolynomial(options.lobe))
            return rowSumsSeconds(probe.width, static_cast<int>(texels));
        return std::min(wholeSumSeconds(options, probe), planNearFar(options, probe).seconds);
    case Method::Hierarchical:
        return cost::treeTexel * sources + cost::treeTerm * texels * hierarchicalTerms(options, probe.width);
    case Method::Importance:
        return cost::lookupTexel * sources + cost::lookupSample * texels * options.knobs.samples;
    case Method::Mip: {
        const MapLayout cube = environmentCube(probe.width);
        return cost::blurTexel * cube.width() * cube.height() + cost::blurLookup * texels;
    }
    case Method::Sh9:
        return forward(sh9BandLimit) + cost::sh9Texel * texels;
    case Method::Paraboloid:
        return (probe.hasParaboloidDevice ? 1.0 : 2.0) *
               paraboloidSeconds(options.lobe, resolved(options.knobs.paraboloid, probe.width / 2), probe.width, static_cast<int>(texels));
    }
    return 0.0;
}

TransferModel transferModel(Method method, const PrefilterOptions& options, const ProbeTraits& probe)
{
    switch (method) {
    case Method::Importance:
        return importanceModel(options, probe);
    case Method::Mip:
        return mipModel(options, probe);
    case Method::Sh9:
        return sh9Model(options);
    case Method::Paraboloid:
        return paraboloidModel(options.lobe, resolved(options.knobs.paraboloid, probe.width / 2),
                               std::min(4 * errorBandLimit(options.lobe, probe.width), 1024));
    case Method::Auto:
    case Method::Reference:
    case Method::Spectral:
    case Method::Direct:
    case Method::Hierarchical:
        break;
    }
    return {};
}

double transferError(const TransferModel& model, const ProbeTraits& probe)
{
    return model.relRms(power(probe.spectrum, static_cast<int>(model.k.size()) - 1, largestPower));
}

double predictedError(Method method, const PrefilterOptions& options, const ProbeTraits& probe)
{
    switch (method) {
    case Method::Reference:
        return floatRounding;
    case Method::Auto:
    case Method::Spectral: {
        return spectralError(expectedSpectral(options, probe), options.target, options.tolerance);
    }
    case Method::Direct:
        if (splitsKernel(options, probe))
            return 0.9 * options.tolerance; // at most; settleNearFar() tells better
        return isShortPolynomial(options.lobe) ? floatRounding : floatRounding + 0.1 * options.tolerance; // see directLevel()
    case Method::Hierarchical:
        return floatRounding + 0.5 * options.tolerance;
    case Method::Importance:
    case Method::Mip:
    case Method::Sh9:
        return transferError(transferModel(method, options, probe), probe);
    case Method::Paraboloid:
        if (probe.spectrum)
            return transferError(transferModel(method, options, probe), probe);
        return paraboloidError(options.lobe, resolved(options.knobs.paraboloid, probe.width / 2));
    }
    return 1.0;
}

namespace {

/// How the error of a method that approximates is spread over a probe that was not looked at: its median and its 99th percentile over
/// rel_rms. Geometric means over five lobes and four test probes of 256 x 128, from which a probe with much dark or a sun differs by up to
/// a factor of ten; spreadErrors() looks.
struct Spread {
    double median, p99;
};
Spread spreadOf(Method method)
{
    switch (method) {
    case Method::Importance:
        return {0.5, 13.0};
    case Method::Mip:
        return {0.16, 2.8};
    case Method::Paraboloid:
        return {0.1, 5.0};
    default:
        return {1.0, 15.0};
    }
}

} // namespace

PredictedErrors predictedErrors(Method method, const PrefilterOptions& options, const ProbeTraits& probe)
{
    const double relRms = predictedError(method, options, probe);
    if (const auto [median, p99] = spreadOf(method); !keepsTolerance(method))
        return {relRms, median * relRms, p99 * relRms};
    const ErrorLimits limits = errorLimits(options.tolerance);
    return {relRms, relRms, std::max(relRms, relRms / options.tolerance * limits.p99Rel)};
}

} // namespace mirrorball
