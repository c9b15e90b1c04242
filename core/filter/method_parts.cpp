#include "method_parts.h"

#include "band_limit.h"

#include <algorithm>
#include <cmath>

namespace mirrorball {

double targetTexels(const PrefilterOptions& options) { return static_cast<double>(options.target.width()) * options.target.height(); }

double probeTexels(const ProbeTraits& probe) { return probe.width * (probe.width / 2.0); }

std::vector<double> continuedPower(const std::shared_ptr<const Spectrum>& spectrum, int bandLimit, double (&unknown)(int))
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

int errorBandLimit(const Lobe& lobe, int width)
{
    const double halfWidth = std::max(LobeShape(lobe).halfWidth(), pi / width);
    return std::clamp(static_cast<int>(6.0 / halfWidth), 8, 1024);
}

double spectrumSeconds(const ProbeTraits& probe, int bandLimit)
{
    return probe.knownBandLimit >= bandLimit ? 0.0 : forwardSeconds(probe.width, bandLimit);
}

std::string refuser(std::string_view name) { return "method: '" + std::string(name) + "' "; }

std::string pyramidRefusal(std::string_view name, const ProbeTraits& probe)
{
    constexpr int widest = 8192; // 1.4 GB of nodes, 0.7 GB of texels
    if (probe.width <= widest)
        return "";
    return refuser(name) + "holds a pyramid of the probe in memory and width " + std::to_string(probe.width) +
           " is too large for it, at most " + std::to_string(widest) + "; use auto or spectral";
}

std::string noRefusal(const PrefilterOptions&, const ProbeTraits&) { return ""; }
TransferModel noTransferModel(const PrefilterOptions&, const ProbeTraits&) { return {}; }
int noBandLimit(const PrefilterOptions&) { return 0; }

} // namespace mirrorball
