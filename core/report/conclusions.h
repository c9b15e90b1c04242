#pragma once

#include "report.h"

#include <string>
#include <vector>

namespace mirrorball {

/// What to conclude, in sentences that the figures of this report make; each says over how many probes and lobes it holds. Nothing is
/// said about what was not measured.
std::vector<std::string> conclusions(const Report& report);

} // namespace mirrorball
