#include "prediction.h"

#include "band_limit.h"
#include "bright_texels.h"
#include "direct.h"
#include "importance.h"
#include "mip_blur.h"
#include "sh9.h"
#include "spectral.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace mirrorball {

namespace {

/// Seconds of one thread. Reproduce with `build/ci/bin/method_table --calibrate`.
namespace cost {
constexpr double referenceTerm = 5e-9;       // a texel of the probe under a texel of the target
constexpr double directTexel = 2e-7, directTerm = 1.2e-8;
constexpr double forwardTexel = 2.4e-8, forwardLegendre = 0.5e-9;
constexpr double inverseCubic = 0.6e-9, inverseSquare = 1e-7, inverseTexel = 6e-8;
constexpr double treeTexel = 1.8e-7, treeTerm = 4e-8;
constexpr double lookupTexel = 9e-8, lookupSample = 4e-8;
constexpr double blurTexel = 4.5e-7, blurLookup = 4e-7;
constexpr double sh9Texel = 8e-8;
} // namespace cost

/// rel_rms of a map stored as floats.
constexpr double floatRounding = 3e-8;

/// Power per degree that a usual photograph has about its mean, the mean itself being 1: suns make it flat, skies and rooms do not.
double usualPower(int l)
{
    return 3.0 / (l + 1.0);
}

/// The power of each degree, 0 .. bandLimit: the probe's own where it is known, continued at the level of its last degrees.
std::vector<double> power(const std::shared_ptr<const Spectrum>& spectrum, int bandLimit)
{
    std::vector<double> result;
    if (!spectrum) {
        result.push_back(1.0);
        for (int l = 1; l <= bandLimit; ++l)
            result.push_back(usualPower(l));
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

/// rel_rms of a filter whose transfer differs from the lobe's: sqrt(sum p_l e_l / sum p_l k_l^2), e_l = (h_l - k_l)^2 + scatter.
double transferError(const std::vector<double>& p, const std::vector<double>& k, const std::vector<double>& squaredError)
{
    double error = 0.0, total = 0.0;
    for (size_t l = 0; l < k.size(); ++l) {
        error += p[l] * squaredError[l];
        total += p[l] * k[l] * k[l];
    }
    return total > 0.0 ? std::sqrt(error / total) : 0.0;
}

double sh9Error(const PrefilterOptions& options, const ProbeTraits& probe)
{
    constexpr int bandLimit = sh9BandLimit;
    const std::vector<double> k = legendreCoefficients(options.lobe, bandLimit);
    std::vector<double> missing;
    for (size_t l = 0; l < k.size(); ++l)
        missing.push_back(l > 2 ? k[l] * k[l] : 0.0);
    return transferError(power(probe.spectrum, bandLimit), k, missing);
}

double mipError(const PrefilterOptions& options, const ProbeTraits& probe)
{
    const int bandLimit = errorBandLimit(options.lobe, probe.width);
    const std::vector<double> k = legendreCoefficients(options.lobe, bandLimit);
    const MapLayout environment = environmentCube(probe.width), &target = options.target;
    const double natural = 0.5 * std::log2(6.0 * environment.size * environment.size / (static_cast<double>(target.width()) * target.height()));
    const double level = std::max(effectiveLambda(options, probe.width), natural);
    const std::vector<double> h = mipTransfer(level, environment, bandLimit), scatter = mipScatter(level, environment, bandLimit);
    std::vector<double> difference;
    for (size_t l = 0; l < k.size(); ++l)
        difference.push_back((h[l] - k[l]) * (h[l] - k[l]) + scatter[l]);
    return transferError(power(probe.spectrum, bandLimit), k, difference);
}

/// The samples' mean transfer differs from the lobe's by their blur. About that mean they scatter: the spiral's points do not below
/// the frequency of their spacing and do like random ones above it, where their blur g_l leaves little:
///   E|kappa_lm - mean|^2 summed over m = 1/N^2 sum_i g_l(sigma_i) S(l spacing_i),  S(x) = x^4/(x^4 + x_0^4)
/// (g_l and not its square: the kernel of a trilinear lookup falls off less than the Gauss function of its variance.)
double importanceError(const PrefilterOptions& options, const ProbeTraits& probe)
{
    const int count = options.knobs.samples;
    const int bandLimit = errorBandLimit(options.lobe, probe.width);
    const std::vector<double> k = legendreCoefficients(options.lobe, bandLimit);
    const std::vector<LobeSample> all = lobeSamples(options.lobe, count, std::max(1, probe.width / 2));
    constexpr size_t enough = 512; // samples stand in order of their radius
    const size_t step = std::max<size_t>(1, all.size() / enough);
    constexpr double x0 = 3.0, latticePeak = 2.5; // the spiral is nearly a lattice: it scatters strongly at the frequency of its spacing
    std::vector<double> squaredError(k.size()), mean(k.size()), scatter(k.size());
    double used = 0.0;
    for (size_t i = step / 2; i < all.size(); i += step) {
        const LobeSample& s = all[i];
        double previous = 0.0, p = 1.0;
        for (size_t l = 0; l < k.size(); ++l) {
            const double d = static_cast<double>(l);
            const double g = std::exp(-0.5 * d * (d + 1.0) * s.variance);
            const double x = d * std::sqrt(s.cell) / x0;
            mean[l] += g * p;
            scatter[l] += latticePeak * g * x * x * x * x / (1.0 + x * x * x * x);
            previous = std::exchange(p, ((2.0 * d + 1.0) * s.z * p - d * previous) / (d + 1.0));
        }
        used += 1.0;
    }
    for (size_t l = 0; l < k.size(); ++l) {
        const double bias = mean[l] / used - k[l];
        squaredError[l] = bias * bias + scatter[l] / used / count;
    }
    return transferError(power(probe.spectrum, bandLimit), k, squaredError);
}

/// What the spectral method will do, and the spectrum it filters; null while that is not known. As settleBandLimit(): where the lobe's own
/// band limit is short, the whole probe's; else the probe's own power counts, and bright texels are taken out for the lobes that ask for it.
struct ExpectedSpectral {
    BandLimitPlan plan{};
    std::shared_ptr<const Spectrum> spectrum{};
};

ExpectedSpectral expectedSpectral(const PrefilterOptions& options, const ProbeTraits& probe)
{
    std::vector<double> k = legendreCoefficients(options.lobe, firstCoefficients);
    const BandLimitPlan plan = planBandLimit(k, options.tolerance);
    if (plan.bandLimit <= firstCoefficients / 2)
        return {plan, probe.spectrum};
    const auto& spectrum = splitsBrightTexels(options.lobe) && !probe.streamed ? probe.calmSpectrum : probe.spectrum;
    for (int length = firstCoefficients;; length *= 2) {
        const BandLimitPlan longer = planBandLimit(k, options.tolerance, power(spectrum, length));
        if (longer.predictedError <= 0.5 * options.tolerance || length >= 2 * largestBandLimit)
            return {longer, spectrum};
        k = legendreCoefficients(options.lobe, 2 * length);
    }
}

/// Terms of the hierarchical sum a direction: they grow as the tolerance shrinks, up to all the texels under the lobe.
double hierarchicalTerms(const PrefilterOptions& options, int width)
{
    const double most = directTaps(options.lobe, width, {.level = 0.1 * options.tolerance});
    return std::min(most, 2000.0 * std::pow(1e-2 / options.tolerance, 0.75));
}

} // namespace

ProbeTraits traits(const FilterSource& source)
{
    return {.width = source.width(),
            .streamed = source.latlong() == nullptr,
            .knownBandLimit = std::max(source.knownBandLimit(), source.knownCalmBandLimit()),
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
    if (method == Method::Paraboloid && !probe.hasParaboloidDevice)
        return who + "runs on a GPU and none was given; use another method";
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

double directLevel(double tolerance)
{
    return std::min(1e-3, 1e-7 * tolerance);
}

double effectiveLambda(const PrefilterOptions& options, int latlongWidth)
{
    return options.knobs.lambda ? *options.knobs.lambda : matchedLambda(options.lobe, environmentCube(latlongWidth));
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
    const auto forward = [&](double l) {
        return probe.knownBandLimit >= l ? 0.0 : cost::forwardTexel * sources + cost::forwardLegendre * l * l * rings;
    };
    switch (method) {
    case Method::Auto:
    case Method::Spectral: {
        const double l = expectedSpectral(options, probe).plan.bandLimit;
        return forward(l) + cost::inverseCubic * l * l * l + cost::inverseSquare * l * l + cost::inverseTexel * texels;
    }
    case Method::Reference: return cost::referenceTerm * sources * texels;
    case Method::Direct:
        return texels * (cost::directTexel + cost::directTerm * directTaps(options.lobe, probe.width, {.level = directLevel(options.tolerance)}));
    case Method::Hierarchical: return cost::treeTexel * sources + cost::treeTerm * texels * hierarchicalTerms(options, probe.width);
    case Method::Importance: return cost::lookupTexel * sources + cost::lookupSample * texels * options.knobs.samples;
    case Method::Mip: {
        const MapLayout cube = environmentCube(probe.width);
        return cost::blurTexel * cube.width() * cube.height() + cost::blurLookup * texels;
    }
    case Method::Sh9: return forward(sh9BandLimit) + cost::sh9Texel * texels;
    case Method::Paraboloid:
        return paraboloidSeconds(options.lobe, resolved(options.knobs.paraboloid, probe.width / 2), probe.width, static_cast<int>(texels));
    }
    return 0.0;
}

double predictedError(Method method, const PrefilterOptions& options, const ProbeTraits& probe)
{
    switch (method) {
    case Method::Reference: return floatRounding;
    case Method::Auto:
    case Method::Spectral: {
        const ExpectedSpectral expected = expectedSpectral(options, probe);
        return spectralError(expected.plan, options.target, options.tolerance,
                             expected.spectrum ? expected.spectrum->powerAboutMean() : std::vector<double>{});
    }
    case Method::Direct:
        return std::max(floatRounding, directTruncation(options.lobe, {.level = directLevel(options.tolerance)}));
    case Method::Hierarchical: return std::max(floatRounding, 0.4 * options.tolerance);
    case Method::Importance: return importanceError(options, probe);
    case Method::Mip: return mipError(options, probe);
    case Method::Sh9: return sh9Error(options, probe);
    case Method::Paraboloid: return paraboloidError(options.lobe, resolved(options.knobs.paraboloid, probe.width / 2));
    }
    return 1.0;
}

} // namespace mirrorball
