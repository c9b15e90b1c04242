#include "band_limit.h"

#include "bright_sum.h"
#include "bright_texels.h"
#include "truncation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace mirrorball {

namespace {

/// Shares of the allowed error, which add up as squares.
constexpr double truncationShare = 0.7, interpolationShare = 0.7;

/// And of the tolerance, for what values are divided by.
constexpr double normShare = 0.5;

int usualBandLimit(const std::vector<double>& k, double tolerance)
{
    std::vector<double> power{1.0};
    for (int l = 1; l < static_cast<int>(k.size()); ++l)
        power.push_back(usualPower(l));
    return planBandLimit(k, tolerance, power).bandLimit;
}

/// The filtered map at some hundred even directions: what an error will be relative to. The band limit may be short; where the truth goes
/// deeper into the dark than that shows, the finished map tells.
ValueDistribution coarseValues(const Spectrum& spectrum, const std::vector<double>& k, int bandLimit, const BrightLobe& bright,
                               const JobControl& job)
{
    const int l = std::min({bandLimit, spectrum.bandLimit, static_cast<int>(k.size()) - 1});
    const CoarseLook look = lookCoarsely(spectrum, {k.begin(), k.begin() + l + 1}, k, job);
    ValueDistribution values;
    for (size_t i = 0; i < look.places.size(); ++i)
        values.add(look.rings.radiance(i, bright.radiance(look.directions[i])), std::sin(look.places[i].colatitude));
    return values;
}

/// Root mean square of what the values differ from the calm mean by, relative to the whole; 1 at most.
double relativeDeviation(const ValueDistribution& values, const glm::dvec3& calmMean)
{
    return values.rms() > 0.0 ? std::min(1.0, glm::length(values.deviation(calmMean)) / values.rms()) : 0.0;
}

/// One split of a probe, looked at.
class Settling {
public:
    Settling(FilterSource& source, const PrefilterOptions& options, const JobControl& job, double strictness)
        : m_source(source), m_options(options), m_job(job), m_strictness(strictness), m_limits(errorLimits(options.tolerance))
    {
        m_k = legendreCoefficients(options.lobe, firstCoefficients);
        m_fromLobe = planBandLimit(m_k, options.tolerance);
    }

    SettledSpectral settle()
    {
        const bool kinked = splitsBrightTexels(m_options.lobe) && m_source.canSplit();
        size_t split = kinked ? 1 : 0;
        int look = m_fromLobe.bandLimit;
        if (kinked)
            look = std::min(look, std::clamp(2 * usualBandLimit(m_k, m_options.tolerance), 64, 128));
        std::optional<Choice> best;
        for (int step = 0; step < mostSteps; ++step) {
            const Choice choice = lookAt(split, look);
            if (!best || choice.split == best->split || choice.seconds < best->seconds)
                best = choice;
            const Spectrum& spectrum = m_source.calmSpectrum(split, readable(look), m_job);
            if (const std::optional<Deeper> deeper = worthSplitting(choice, spectrum)) {
                split = deeper->split;
                look = deeper->look;
                continue;
            }
            if (!choice.feasible() || best->split != choice.split || choice.bandLimit <= look)
                break;
            look = choice.bandLimit;
        }
        return finish(*best);
    }

private:
    static constexpr int mostSteps = 8;

    struct Choice {
        size_t split = 0;
        int bandLimit = -1; ///< -1: no spectrum is long enough
        int rings = 0;
        double seconds = std::numeric_limits<double>::infinity(); ///< from a spectrum to a map
        double allowed = 0.0;                                     ///< root mean square of the whole error
        glm::dvec3 shape{1.0};
        bool feasible() const { return bandLimit >= 0; }
    };

    int knownAt(size_t split) const { return m_source.knownCalmBandLimit(split); }

    int readable(int look) const // of a streamed probe what was read is all there is
    {
        return m_source.latlong() ? look : std::min(look, m_source.knownBandLimit());
    }

    Choice lookAt(size_t split, int look)
    {
        const Spectrum& spectrum = m_source.calmSpectrum(split, readable(look), m_job);
        const BrightLobe bright(m_source.brightTexels(split, m_job), m_options.lobe);
        const int coarse = std::min(std::max(m_fromLobe.bandLimit, 32), std::max(256, look));
        m_calmMean = meanOf(spectrum);
        m_values = coarseValues(spectrum, m_k, coarse, bright, m_job);
        for (;;) {
            m_model.emplace(spectrum, m_k);
            Choice choice = choose(split, 1.0);
            const bool longer = !choice.feasible() && m_model->longest() < 2 * largestBandLimit && m_source.latlong();
            if (!longer)
                return choice;
            m_k = legendreCoefficients(m_options.lobe, 2 * m_model->longest());
        }
    }

    /// What the model at hand asks for. @param quieter  were the calm part's errors so much smaller
    Choice choose(size_t split, double quieter)
    {
        Choice choice{.split = split, .shape = m_model->shape()};
        // What rounding and the norm take is not there for the rest.
        const double differs = std::max(relativeDeviation(m_values, m_calmMean), 1e-12),
                     normLimit = normShare * m_options.tolerance / differs;
        const double taken = (spectralRounding + differs * std::min(m_model->normError(0), normLimit)) / m_options.tolerance;
        choice.allowed = m_strictness * std::max(0.0, 0.9 - taken) * m_values.allowedRms(choice.shape, m_limits);
        choice.bandLimit = m_model->bandLimitFor(truncationShare * choice.allowed * quieter, choice.shape);
        const int longest = m_source.latlong() ? largestBandLimit : m_source.knownBandLimit();
        if (!choice.feasible() || choice.bandLimit > longest)
            return {.split = split, .allowed = choice.allowed, .shape = choice.shape};
        choice.bandLimit = std::max(choice.bandLimit, 2);
        // The norm's repetition along the rows, which small probes show, is followed where it would be felt.
        choice.bandLimit = std::max(choice.bandLimit, m_model->bandLimitForNorm(normLimit));
        if (choice.bandLimit > longest)
            return {.split = split, .allowed = choice.allowed, .shape = choice.shape};
        if (m_options.target.kind != Parameterization::Latlong)
            choice.rings = m_model->ringsFor(choice.bandLimit, interpolationShare * choice.allowed * quieter, choice.shape);
        if (choice.rings > largestRings) {
            choice.bandLimit = -1;
            return choice;
        }
        choice.seconds = inverseSeconds(choice.bandLimit, choice.rings, m_options.target) +
                         brightSeconds(m_options.lobe, m_source.brightTexels(split, m_job).directions.size(), m_options.target);
        return choice;
    }

    /// A deeper split, and how far the spectrum of what it leaves is to be looked at.
    struct Deeper {
        size_t split;
        int look;
    };

    /// Where taking out more promises to pay; else nothing.
    std::optional<Deeper> worthSplitting(const Choice& choice, const Spectrum& spectrum)
    {
        if (!m_source.canSplit() || m_values.mean() == 0.0)
            return std::nullopt;
        constexpr double worth = 0.7;
        const double here =
            choice.seconds + (knownAt(choice.split) < choice.bandLimit ? forwardSeconds(m_source.width(), choice.bandLimit) : 0.0);
        // Before bright texels are looked for: were there hardly anything left.
        if (const Choice least = choose(choice.split, 1e3); least.feasible() && least.seconds > worth * here)
            return std::nullopt;
        const BrightTexels& now = m_source.brightTexels(choice.split, m_job);
        std::optional<Deeper> best;
        double shortest = worth * here;
        for (size_t split = choice.split + 1; split < brightSplits.size(); ++split) {
            const BrightTexels& then = m_source.brightTexels(split, m_job);
            if (then.directions.size() <= now.directions.size())
                continue;
            const double power = remainingPower(spectrum, now, then);
            const Choice calmer = choose(choice.split, 1.0 / std::sqrt(std::max(power, 1e-12)));
            if (!calmer.feasible())
                continue;
            const double seconds = calmer.seconds + brightSeconds(m_options.lobe, then.directions.size(), m_options.target) -
                                   brightSeconds(m_options.lobe, now.directions.size(), m_options.target) +
                                   (knownAt(split) < calmer.bandLimit ? forwardSeconds(m_source.width(), calmer.bandLimit) : 0.0);
            if (seconds < shortest) {
                shortest = seconds;
                best = {split, std::max(calmer.bandLimit, 32)};
            }
        }
        if (best || choice.feasible())
            return best;
        // Bright texels hold more of the high degrees than of the power that this was judged by, and what is left to try costs a sum over
        // all texels: look.
        for (size_t split = choice.split + 1; split < brightSplits.size(); ++split)
            if (m_source.brightTexels(split, m_job).directions.size() > now.directions.size())
                return Deeper{split, 128};
        return std::nullopt;
    }

    /// What a deeper split leaves of the power about the mean: exactly over all degrees, and of the high ones hardly more.
    static double remainingPower(const Spectrum& spectrum, const BrightTexels& now, const BrightTexels& then)
    {
        const glm::dvec3 before = spectrum.varianceAboutMean();
        double largest = 0.0;
        for (int c = 0; c < 3; ++c) {
            const double energy =
                spectrum.coefficients[static_cast<size_t>(c)][0].real() * std::sqrt(4.0 * pi) + now.energy[c] - then.energy[c];
            const double after = spectrum.secondMoment[c] + now.squares[c] - then.squares[c] - energy * energy / (4.0 * pi);
            if (before[c] > 0.0)
                largest = std::max(largest, std::clamp(after / before[c], 0.0, 1.0));
        }
        return largest;
    }

    SettledSpectral finish(Choice choice)
    {
        SettledSpectral settled{.split = choice.split};
        if (!choice.feasible()) { // as far as it goes
            choice.bandLimit = std::min(largestBandLimit, readable(largestBandLimit));
            if (m_options.target.kind != Parameterization::Latlong)
                choice.rings = RingGrid::leastRings(2 * choice.bandLimit);
            choice.seconds = inverseSeconds(choice.bandLimit, choice.rings, m_options.target);
        }
        if (static_cast<int>(m_k.size()) <= choice.bandLimit)
            m_k = legendreCoefficients(m_options.lobe, choice.bandLimit);
        settled.k.assign(m_k.begin(), m_k.begin() + choice.bandLimit + 1);
        settled.longer = m_k;
        settled.rings = choice.rings;
        settled.seconds = choice.seconds;
        if (choice.feasible() || knownAt(choice.split) >= choice.bandLimit)
            settled.spectrum = &m_source.calmSpectrum(choice.split, choice.bandLimit, m_job);
        const Spectrum& spectrum = settled.spectrum ? *settled.spectrum : m_source.calmSpectrum(choice.split, 0, m_job);
        const TruncationModel model(spectrum, m_k);
        settled.error = model.truncation(choice.bandLimit);
        if (choice.rings > 0) {
            const glm::dvec3 read = model.interpolation(choice.bandLimit, choice.rings);
            settled.error = glm::sqrt(settled.error * settled.error + read * read);
        }
        settled.normError = model.normError(choice.bandLimit);
        settled.calmMean = meanOf(spectrum);
        settled.predicted = spectralErrors(m_values, settled);
        settled.keeps = choice.feasible() && settled.predicted.within(m_limits);
        return settled;
    }

    FilterSource& m_source;
    const PrefilterOptions& m_options;
    const JobControl& m_job;
    double m_strictness;
    ErrorLimits m_limits;
    std::vector<double> m_k;
    BandLimitPlan m_fromLobe;
    std::optional<TruncationModel> m_model{};
    glm::dvec3 m_calmMean{0.0};
    ValueDistribution m_values{};
};

} // namespace

glm::dvec3 meanOf(const Spectrum& spectrum)
{
    glm::dvec3 mean;
    for (int c = 0; c < 3; ++c)
        mean[c] = spectrum.coefficients[static_cast<size_t>(c)][0].real() / spectrum.unit[0].real();
    return mean;
}

CoarseLook lookCoarsely(const Spectrum& spectrum, const std::vector<double>& k, const std::vector<double>& longer, const JobControl& job)
{
    constexpr int rings = CoarseLook::ringCount, samples = CoarseLook::samples;
    std::vector<double> theta;
    for (int j = 0; j < rings; ++j)
        theta.push_back(pi * (j + 0.5) / rings);
    CoarseLook look{
        .rings = synthesize(spectrum, k, theta, samples, pi / samples, std::vector<std::complex<double>>(k.size(), 1.0), job, longer)};
    for (const double t : theta)
        for (int i = 0; i < samples; ++i) {
            const double azimuth = 2.0 * pi * (i + 0.5) / samples, lon = pi - azimuth;
            look.places.push_back({.azimuth = azimuth, .colatitude = t});
            look.directions.emplace_back(std::sin(lon) * std::sin(t), std::cos(t), std::cos(lon) * std::sin(t));
        }
    return look;
}

double usualPower(int l) { return 3.0 / (l + 1.0); }

PredictedErrors spectralErrors(const ValueDistribution& values, const SettledSpectral& settled)
{
    // With S the numerator, m the calm mean and d the norm's error, (S + m d)/(N + d) - S/N = d (m - E)/N: nothing where all is constant,
    // and relative to E no more than d max(1, m/E), however bright the sun.
    PredictedErrors errors = values.errors(settled.error);
    const double d = settled.normError;
    const PredictedErrors spread = values.errors(d * values.deviation(settled.calmMean)), dark = values.errors(d * settled.calmMean);
    errors.relRms = std::hypot(errors.relRms, std::min(d, spread.relRms)) + spectralRounding + settled.relative;
    errors.medianRel += std::min(std::max(d, dark.medianRel), spread.medianRel) + spectralRounding + settled.relative;
    errors.p99Rel += std::min(std::max(d, dark.p99Rel / std::sqrt(200.0)), spread.p99Rel) + 3.0 * spectralRounding +
                     settled.relative; // no tail of d's own
    return errors;
}

SettledSpectral settleSpectral(FilterSource& source, const PrefilterOptions& options, const JobControl& job, double strictness)
{
    return Settling(source, options, job, strictness).settle();
}

// Calibrated by `build/ci/bin/method_table methods`.
double forwardSeconds(int probeWidth, int bandLimit)
{
    const double rings = probeWidth / 2.0, l = bandLimit;
    return 2.4e-8 * probeWidth * rings + 0.5e-9 * l * l * rings;
}

double inverseSeconds(int bandLimit, int rings, const MapLayout& target)
{
    const double l = bandLimit, texels = static_cast<double>(target.width()) * target.height();
    if (target.kind == Parameterization::Latlong)
        return 0.12e-9 * target.height() * l * l + 3e-8 * texels;
    return 0.12e-9 * rings * l * l + 1.2e-8 * rings * static_cast<double>(rings) + 6e-8 * texels;
}

double brightSeconds(const Lobe& lobe, size_t brightTexels, const MapLayout& target)
{
    if (brightTexels == 0)
        return 0.0;
    const double texels = static_cast<double>(target.width()) * target.height();
    const double reach = LobeShape(lobe).support(1e-30);
    const double share = std::min(1.0, 0.5 * (1.0 - std::cos(std::min(pi, reach + 0.1)))); // of the map that sees a texel
    const double term = lobe.kind == LobeKind::Diffuse || hasQuickPowers(lobe) ? 0.7e-9 : lobe.kind == LobeKind::Ggx ? 1.5e-9 : 6e-9;
    return texels * (2e-8 + static_cast<double>(brightTexels) * (0.2e-9 + share * term));
}

} // namespace mirrorball
