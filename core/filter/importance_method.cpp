#include "importance.h"

#include "method_parts.h"
#include "prefilter.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace mirrorball {

namespace {

std::string refusal(const PrefilterOptions&, const ProbeTraits& probe) { return pyramidRefusal(importanceMethod.name, probe); }

double seconds(const PrefilterOptions& options, const ProbeTraits& probe)
{
    constexpr double texel = 9e-8, sample = 4e-8;
    return texel * probeTexels(probe) + sample * targetTexels(options) * options.knobs.samples;
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
TransferModel transfer(const PrefilterOptions& options, const ProbeTraits& probe)
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

double error(const PrefilterOptions& options, const ProbeTraits& probe) { return transferError(transfer(options, probe), probe); }

EnvironmentMap run(FilterSource& source, const PrefilterOptions& options, const JobControl& job, PrefilterOutcome& outcome)
{
    timedStage(outcome.stages, "mip pyramid of the probe", [&] { source.lookupPyramid(job); });
    return timedStage(outcome.stages, "importance samples", [&] {
        return importanceSample(source.lookupPyramid(), options.lobe, options.knobs.samples, options.target, options.yaw, job);
    });
}

constexpr std::array<std::string_view, 1> knobs{"samples"};

} // namespace

constinit const MethodRow importanceMethod{
    .name = "importance",
    .help = "the mean of samples of the lobe, each looked up in the probe's mip pyramid",
    .knobs = knobs,
    .needsTexels = true,
    .followsTolerance = false,
    .spread = ErrorSpread{0.5, 13.0},
    .refusal = refusal,
    .seconds = seconds,
    .error = error,
    .transferModel = transfer,
    .bandLimit = noBandLimit,
    .run = run,
};

} // namespace mirrorball
