#pragma once

#include "band_limit.h"
#include "prefilter.h"

#include <string>

/// What is said where a tolerance cannot be promised.
namespace mirrorball {

/// Why the spectral method cannot keep it and what to do, in one line: the message of the InvalidArgument that prefilter() throws.
/// @param settled  as far as its spectrum goes
std::string cannotKeep(const PrefilterOptions& options, const SettledSpectral& settled, const ProbeTraits& probe);

} // namespace mirrorball
