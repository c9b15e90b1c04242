#pragma once

#include "core/image/probe_reading.h"
#include "core/shading/brdf.h"

#include <string>
#include <vector>

/// `brdf --errors`: what lookups miss of a material in a probe's light, by angle of view.
namespace mirrorball::cli {

struct BrdfErrorsRequest {
    std::string probe{}, views{}, lookups{}; ///< the last two comma-separated; empty: the usual ones
    std::vector<std::string> out{};          ///< .csv, .json or .png
    ProbeReading reading{};
    int height = 128, threads = 0;
};

/// What is wrong with the request is said before the BRDF is read. @throws InvalidArgument
void checkBrdfErrors(const BrdfErrorsRequest& request);
/// Prints the table and writes the files. @throws InvalidArgument, FileError, WorkError
void printBrdfErrors(const BrdfErrorsRequest& request, const Brdf& brdf);

} // namespace mirrorball::cli
