#include "band_limit.h"

#include "bright_texels.h"

#include <algorithm>

namespace mirrorball {

namespace {

/// The bright texels are divided by the norm, whose own harmonics beyond the length of a row are felt on probes narrower than this: k_l
/// of a kinked lobe is 9e-6 at 128 columns, 3e-7 at 512.
constexpr int smallProbe = 512;

int usualBandLimit(const std::vector<double>& k, double tolerance)
{
    std::vector<double> power{1.0};
    for (int l = 1; l < static_cast<int>(k.size()); ++l)
        power.push_back(usualPower(l));
    return planBandLimit(k, tolerance, power).bandLimit;
}

} // namespace

double usualPower(int l) { return 3.0 / (l + 1.0); }

bool isSettled(const BandLimitPlan& fromLobe, const std::vector<double>& k, double tolerance)
{
    constexpr int cheap = 144; // costs little more than a shorter one, and a second look at the probe costs as much as the first
    return fromLobe.bandLimit <= cheap ||
           (fromLobe.bandLimit <= firstCoefficients / 2 && 2 * fromLobe.bandLimit <= 3 * usualBandLimit(k, tolerance));
}

SettledBandLimit settleBandLimit(FilterSource& source, const Lobe& lobe, double tolerance, const JobControl& job)
{
    std::vector<double> k = legendreCoefficients(lobe, firstCoefficients);
    BandLimitPlan plan = planBandLimit(k, tolerance);
    if (!source.latlong()) { // streamed: what was read is all there is
        const Spectrum& all = source.spectrum(0);
        if (plan.bandLimit > all.bandLimit) {
            plan = planBandLimit(k, tolerance, all);
            plan.bandLimit = std::min(plan.bandLimit, all.bandLimit);
            plan.k.resize(static_cast<size_t>(plan.bandLimit) + 1);
        }
        return {plan, &all};
    }
    const bool split = splitsBrightTexels(lobe);
    if (isSettled(plan, k, tolerance)) {
        const bool calmIsThere = split && source.width() >= smallProbe && source.knownBandLimit() < plan.bandLimit &&
                                 source.knownCalmBandLimit() >= plan.bandLimit;
        return {plan, calmIsThere ? &source.calmSpectrum(plan.bandLimit, job) : &source.spectrum(plan.bandLimit, job), calmIsThere};
    }

    const int leastForNorm = split && source.width() < smallProbe ? 2 * source.width() : 0;
    const int firstLook = std::clamp(2 * usualBandLimit(k, tolerance), 64, 128);
    // The calm part is held to the tolerance by itself: the dark side of a sunlit map is all its own.
    int next = std::max(firstLook, split ? source.knownCalmBandLimit() : source.knownBandLimit());
    for (;;) {
        const Spectrum& spectrum = split ? source.calmSpectrum(next, job) : source.spectrum(next, job);
        plan = planBandLimit(k, tolerance, spectrum, leastForNorm);
        if (plan.bandLimit <= spectrum.bandLimit)
            return {plan, &spectrum, split};
        next = std::min(2 * spectrum.bandLimit, plan.bandLimit);
        if (static_cast<int>(k.size()) < 2 * next)
            k = legendreCoefficients(lobe, 2 * next);
    }
}

} // namespace mirrorball
