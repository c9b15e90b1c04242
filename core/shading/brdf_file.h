#pragma once

#include "measured_brdf.h"

#include <filesystem>

/// Files of measured BRDFs. Wavelengths become RGB through the observer (observer.h).
namespace mirrorball {

/// Reads a measurement. What the file is, its name says:
///   .binary   MERL: three little-endian int32 90, 90, 180, then 3 x 90 x 90 x 180 doubles, red first; times 1/1500, 1.15/1500, 1.66/1500
///             1/sr; a value below 0 is a hole
///   .brdf     Cornell: lines of `#` are remarks; the number of wavelengths, the wavelengths in nm, then rows of theta_i phi_i theta_s
///   phi_s
///             in radians and one value per wavelength, 1/sr
///   .csv .txt a plain table: the first line names the columns. Angles in degrees: theta_i, theta_r (or theta_o, theta_s), phi_r (phi_o,
///             phi_s), phi_i (0 where it is missing); then r, g, b; or lambda (or wavelength; nm, or micrometers below 10) and value (or
///             f, fr, fr11, brdf), one row a wavelength. Further columns are not read.
/// Directions point away from the surface: an azimuth of 180 degrees between them is the mirror's. Both are read as they stand; a row whose
/// value is not finite or below 0 is a hole and is left out, rows below the horizon likewise.
/// @throws FileError in one line with the offset or the row and what was expected there
MeasuredBrdf readBrdf(const std::filesystem::path& path);

/// Whether readBrdf() knows what a file of this name holds.
bool isBrdfFile(const std::filesystem::path& path);

} // namespace mirrorball
