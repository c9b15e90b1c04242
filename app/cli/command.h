#pragma once

#include "progress.h"

#include "core/base/stage.h"
#include "core/scene/scene_maps.h"
#include "core/sphere/parameterization.h"

#include <CLI/CLI.hpp>

#include <filesystem>
#include <string>
#include <vector>

/// What the commands of the command line share. Each command has a file of its own with one function that adds it to the program;
/// its callback parses, calls core, and prints. Errors are thrown and become one line in main.
namespace mirrorball::cli {

void addInfoCommand(CLI::App& program);
void addBrdfCommand(CLI::App& program);
void addDoctorCommand(CLI::App& program);
void addConvertCommand(CLI::App& program);
void addFilterCommand(CLI::App& program);
void addRenderCommand(CLI::App& program);
void addExportCommand(CLI::App& program);
void addPaintCommand(CLI::App& program);
void addPresetsCommand(CLI::App& program);
void addBatchCommand(CLI::App& program);
void addRecipeCommand(CLI::App& program);
/// Takes the program's words too, which the report records.
void addReportCommand(CLI::App& program, int argc, const char* const* argv);

/// Adds every command. @param argc, argv  the program's words, which a report records
void addCommands(CLI::App& program, int argc, const char* const* argv);

/// Parses a KIND word. @throws InvalidArgument naming the option and the known words
Parameterization parseKind(const std::string& option, const std::string& word);
inline double radians(double degrees) { return degrees * pi / 180.0; }

/// The numbers that an option takes; NaN is in no range. For `->check(...)` where the option is declared. (CLI::Range lets NaN pass.)
CLI::Validator within(double low, double high);
/// The same without `low` itself.
CLI::Validator above(double low, double high);
/// An angle in degrees: a thousand turns are nobody's wish.
CLI::Validator anAngle();
/// Threads to work on; 0: one per core.
CLI::Validator aThreadCount();
/// A map's edge in texels.
CLI::Validator anEdge();

/// Refuses numbers that are not finite, in every option of every command: a last line behind the ranges of the options themselves.
void refuseInfinities(CLI::App& program);

/// An output that an option names, and the option, for messages.
struct NamedOutput {
    std::string option;
    std::vector<std::filesystem::path> files;
};
/// The file of an option that may be left out.
inline std::vector<std::filesystem::path> filesOf(const std::string& file)
{
    return file.empty() ? std::vector<std::filesystem::path>{} : std::vector<std::filesystem::path>{file};
}
/// Before any work. @throws InvalidArgument when two outputs are one file, naming both options
void checkOutputsDiffer(const std::vector<NamedOutput>& outputs);

/// Writes what `--stats FILE` asks for as JSON, whole or not at all: {"stages":[{"name","seconds","left_out","why"}], "method",
/// "band_limit", "predicted_error", "predicted_rel_rms", "predicted_median_rel", "predicted_p99_rel", "promised", "threads", "peak_bytes"}.
/// The stages are those that were done, with their times, and those that the plan left out.
void writeStats(const std::filesystem::path& path, const std::vector<Stage>& plan, const WorkRecord& record, int threads);

/// A line on stderr for each map whose tolerance is not promised, with what is predicted of it.
void sayUnpromised(const std::string& command, const WorkRecord& record);

/// Prints stages as a table for `--explain`: name, needed or left out, what it is expected to cost where the plan knows, why.
void printStages(const std::vector<Stage>& stages);

} // namespace mirrorball::cli
