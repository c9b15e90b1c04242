#pragma once

#include "plan.h"

#include <cstdint>
#include <string>
#include <vector>

/// What exports will cost, told before anything is computed.
namespace mirrorball {

struct ExportEstimate {
    std::string name{};               ///< of the target
    std::vector<std::string> files{}; ///< names that exportScene() will write, in its order, without the folder; NAME.json last
    int levels = 1;
    bool isPainted = false;      ///< it needs no probe
    std::int64_t texelBytes = 0; ///< all levels as the format stores a texel, before compression; exact but for opacity
    /// Size on disk. Formats that compress are taken at the mean ratio measured on filtered and unfiltered maps of real probes: right to
    /// a factor of two or so, and never above texelBytes by more than headers.
    std::int64_t fileBytes = 0;
    double seconds =
        0.0; ///< CPU time of making and saving it, within a factor of two; reading the probe, Plan::sharedSeconds, comes on top
};

/// @throws InvalidArgument for a target out of range, an extension that cannot be written, or %s in the name of a map that is no cube
std::vector<ExportEstimate> estimateExports(const Plan& plan);

/// "1.4 MB", "312 kB", "96 bytes": powers of ten, as file managers count.
std::string byteText(std::int64_t bytes);

} // namespace mirrorball
