#pragma once

#include "core/base/job.h"
#include "core/base/stage.h"
#include "core/filter/promise.h"
#include "core/sphere/parameterization.h"

#include <CLI/CLI.hpp>

#include <filesystem>
#include <string>
#include <vector>

/// What the commands of the command line share. Each command has a file of its own with one function that adds it to the program;
/// its callback parses, calls core, and prints. Errors are thrown and become one line in main.
namespace mirrorball::cli {

void addInfoCommand(CLI::App& program);
void addConvertCommand(CLI::App& program);
void addFilterCommand(CLI::App& program);
void addRenderCommand(CLI::App& program);
void addExportCommand(CLI::App& program);
void addPaintCommand(CLI::App& program);
void addPresetsCommand(CLI::App& program);
/// Takes the program's words too, which the report records.
void addReportCommand(CLI::App& program, int argc, const char* const* argv);

/// Parses a KIND word. @throws InvalidArgument naming the option and the known words
Parameterization parseKind(const std::string& option, const std::string& word);
inline double radians(double degrees) { return degrees * pi / 180.0; }

/// The record that `--stats FILE` writes: {"stages":[{"name","seconds","left_out","why"}], "method", "band_limit", "predicted_error",
/// "predicted_rel_rms", "predicted_median_rel", "predicted_p99_rel", "promised", "threads", "peak_bytes"}, as in DESIGN 6.
struct Stats {
    std::vector<Stage> stages{};
    std::string method{};
    int bandLimit = 0;
    PredictedErrors predicted{}; ///< the largest of each over all maps that were filtered
    bool promised = true;        ///< all of them keep the tolerance
    int threads = 1;
};
/// Writes it as JSON, whole or not at all.
void writeStats(const std::filesystem::path& path, const Stats& stats);

/// Prints stages as a table for `--explain`: name, needed or left out, what it is expected to cost where the plan knows, why.
void printStages(const std::vector<Stage>& stages);

/// A job on `threads` threads (0: all cores) that draws a progress bar on stderr once the work has taken a second, when stderr is a
/// terminal; never in a pipe. `label` stands before the bar.
JobControl jobWithProgress(const std::string& label, int threads);

} // namespace mirrorball::cli
