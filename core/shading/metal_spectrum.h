#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

/// The metals' index of refraction over wavelengths, as it was measured. (conductor.h has the same metals at three wavelengths.)
namespace mirrorball {

/// n + ik at a wavelength.
struct IndexRow {
    double wavelength; ///< nm
    double n, k;
};

/// The rows of a metal that cover 380 to 780 nm, wavelengths increasing; empty for a name that is none.
std::span<const IndexRow> metalSpectrum(std::string_view name);

/// "silver, gold, ...": for messages.
std::string metalNames();

} // namespace mirrorball
