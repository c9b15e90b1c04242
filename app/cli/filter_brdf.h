#pragma once

#include <filesystem>
#include <optional>
#include <string>

/// `filter --brdf`: a probe as a BRDF reflects it to one angle of view.
namespace mirrorball::cli {

struct BrdfFilterOptions {
    std::string probe{}, out{}, brdf{}, to{}, from{}, stats{};
    std::string method = "stack"; ///< sum, stack, stack:ORDERS, lookups:K, split-sum, round
    std::optional<double> viewDeg{}, tolerance{};
    double azimuthDeg = 0.0, yawDeg = 0.0;
    int size = 0, border = 0, threads = 0;
    bool half = false, explain = false;
};

/// @throws InvalidArgument, FileError, WorkError
void filterByBrdf(const BrdfFilterOptions& options);

} // namespace mirrorball::cli
