#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace mirrorball {

/// A scheduler that can run the tasks of a jobs file.
enum class Scheduler { Slurm, OpenJobDescription, GnuParallel };

/// "slurm", "openjd", "parallel": what `batch --template` takes.
std::vector<std::string_view> words(Scheduler);

/// What hands the tasks of a jobs file to a scheduler: a Slurm array script (for sbatch), a job template of the Open Job Description
/// 2023-09 (JSON; no program that checks it has seen it), or a line for GNU parallel. Tasks count from 0. Each is one call of `mirrorball
/// batch FILE --task N`, so that a task that ended too soon can be run again anywhere.
/// @param jobsFile  absolute. @param tasks  at least 1
std::string schedulerTemplate(Scheduler scheduler, const std::filesystem::path& jobsFile, size_t tasks);

} // namespace mirrorball
