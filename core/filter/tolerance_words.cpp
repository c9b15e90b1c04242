#include "tolerance_words.h"

#include "source_file.h"

#include <algorithm>
#include <sstream>

namespace mirrorball {

namespace {

/// What to do where the spectrum of a probe that is not held whole does not keep the tolerance. A probe's file was read as far as its lobes
/// ask for; less of it is what the file of a spectrum has.
std::string remedyOfStreamed(const PrefilterOptions& options, const ProbeTraits& probe)
{
    const int degree = probe.knownBandLimit, needed = streamedBandLimit(options);
    if (degree >= needed)
        return "allow a larger one, or make the probe smaller than 33 million texels so that it is read whole; of a spectrum, make it "
               "again with a larger --degree, or with a --bright that takes more of its suns out";
    const std::string known = "its spectrum goes to degree " + std::to_string(degree);
    if (needed >= std::min(largestBandLimit, probe.width - 1))
        return known + ", and no spectrum holds this lobe; allow a larger tolerance, or filter the probe itself";
    return known + "; make it again with --degree " + std::to_string(needed) + ", or allow a larger tolerance";
}

} // namespace

std::string cannotKeep(const PrefilterOptions& options, const SettledSpectral& settled, const ProbeTraits& probe)
{
    std::ostringstream text;
    text.precision(2);
    text << "tolerance: 'spectral' cannot keep " << options.tolerance << " for lobe " << describe(options.lobe) << " (predicted: rel_rms "
         << settled.predicted.relRms << ", median_rel " << settled.predicted.medianRel << ", p99_rel " << settled.predicted.p99Rel << "); "
         << (probe.streamed ? remedyOfStreamed(options, probe) : "use auto, or allow a larger one");
    return text.str();
}

std::string unpromisedText(const PrefilterOptions& options, const PrefilterOutcome& outcome)
{
    std::ostringstream text;
    text.precision(2);
    text << describe(options.lobe) << " by '" << name(outcome.method) << "' is not promised; predicted are rel_rms "
         << outcome.predicted.relRms << ", median_rel " << outcome.predicted.medianRel << ", p99_rel " << outcome.predicted.p99Rel;
    return text.str();
}

} // namespace mirrorball
