#pragma once

#include "core/batch/jobs_file.h"

#include <filesystem>
#include <string>
#include <vector>

namespace mirrorball::cli {

/// A command of a jobs file that the command line understands.
struct PlannedCommand {
    std::string where{};               ///< in the file, for messages
    std::vector<std::string> words{};  ///< as the file has them
    std::vector<std::string> recipe{}; ///< as a recipe keeps them (recipeWords)
    std::string output{};              ///< what -o names, as the file has it
    bool takesThreads = false, statesThreads = false;
};

/// The commands of a jobs file, each parsed as the command line would parse it; nothing runs.
struct BatchPlan {
    BatchFile file{};
    std::vector<PlannedCommand> commands{}; ///< one for each of file.commands
};

/// @throws FileError naming the field: a command that does not parse, writes no file, writes what another one writes, or reads what another
/// one makes (tasks run in any order)
BatchPlan planBatch(const std::filesystem::path& jobsFile);

} // namespace mirrorball::cli
