#pragma once

#include "fresnel.h"

#include <optional>
#include <span>
#include <string_view>

/// Built-in metals.
namespace mirrorball {

/// The wavelengths in micrometres at which the red, green and blue channel of a metal are read: the dominant wavelengths of the
/// Rec.709 primaries under D65, 611.4, 549.1 and 464.2 nm, rounded to whole nanometres.
inline constexpr double conductorWavelengths[3] = {0.611, 0.549, 0.464};

struct Conductor {
    std::string_view name; ///< "gold"
    ConductorIndex index;
    std::string_view source; ///< author and year of the measurement
};

/// All built-in metals, in the order a list should show them.
std::span<const Conductor> conductors();
/// The metal of this name, or nothing.
std::optional<ConductorIndex> conductorFromName(std::string_view name);

} // namespace mirrorball
