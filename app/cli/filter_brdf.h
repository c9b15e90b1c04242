#pragma once

#include "core/image/probe_reading.h"

#include <filesystem>
#include <optional>
#include <string>

/// `filter --brdf`: a probe as a BRDF reflects it to one angle of view.
namespace mirrorball::cli {

struct BrdfFilterOptions {
    std::string probe{}, out{}, brdf{}, to{}, stats{};
    ProbeReading reading{};
    std::string method = "stack"; ///< sum, stack, stack:ORDERS, round, or lookup_choice.h
    std::optional<double> viewDeg{}, tolerance{};
    double azimuthDeg = 0.0, yawDeg = 0.0;
    int size = 0, border = 0, threads = 0;
    bool half = false, explain = false;
};

/// @throws InvalidArgument, FileError, WorkError
void filterByBrdf(const BrdfFilterOptions& options);

} // namespace mirrorball::cli
