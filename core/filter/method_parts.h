#pragma once

#include "method_row.h"

#include <memory>
#include <string>
#include <string_view>
#include <vector>

/// What the rows of several methods are put together from.
namespace mirrorball {

/// Relative error of a map stored as floats.
inline constexpr double floatRounding = 6e-8;

/// Texels of the target, and of the probe's latlong form.
double targetTexels(const PrefilterOptions& options);
double probeTexels(const ProbeTraits& probe);

/// The power of each degree, 0 .. bandLimit: the probe's own where it is known, continued at the level of its last degrees.
/// @param unknown  stands for the power of degrees 1 and up of a probe that was not looked at
std::vector<double> continuedPower(const std::shared_ptr<const Spectrum>& spectrum, int bandLimit, double (&unknown)(int));

/// Degrees that a lobe's error is looked for in: as far as it passes anything, and the blur of a texel does.
int errorBandLimit(const Lobe& lobe, int width);

/// Seconds of a spectrum of the probe, if it is not known that far.
double spectrumSeconds(const ProbeTraits& probe, int bandLimit);

/// "method: 'mip' ", which refusals start with.
std::string refuser(std::string_view name);
/// Refuses a probe whose pyramid would be too large.
std::string pyramidRefusal(std::string_view name, const ProbeTraits& probe);

/// Of methods that refuse nothing, put nothing in the lobe's place, have no band limit.
std::string noRefusal(const PrefilterOptions& options, const ProbeTraits& probe);
TransferModel noTransferModel(const PrefilterOptions& options, const ProbeTraits& probe);
int noBandLimit(const PrefilterOptions& options);

/// The values of a target's texels, row by row, as a map.
template <typename Value>
EnvironmentMap toMap(const MapLayout& target, const std::vector<Value>& values)
{
    EnvironmentMap map(target);
    for (size_t i = 0; i < values.size(); ++i)
        for (int c = 0; c < 3; ++c)
            map.image.texels[3 * i + static_cast<size_t>(c)] = static_cast<float>(values[i][c]);
    return map;
}

} // namespace mirrorball
