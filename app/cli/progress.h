#pragma once

#include "core/base/job.h"

#include <CLI/CLI.hpp>

#include <functional>
#include <string>

namespace mirrorball::cli {

/// Adds `--progress plain|openjd|none` to every command that works on threads. Without it a bar shows on a terminal.
void addProgressOptions(CLI::App& program);

/// Shows how far work is, as `--progress` says: a bar over one line of stderr once the work has taken a second, when stderr is a terminal;
/// plain: lines `label: 42%` on stderr, at most one a second and the last; openjd: lines `openjd_progress: 42` on stdout, for schedulers
/// that follow the Open Job Description. Fractions that go back are not shown; 100 comes when the last copy of the function goes, unless an
/// exception takes it. Empty where nothing is to be shown.
std::function<void(float)> progressReport(const std::string& label);

/// What a line of `--progress openjd` begins with.
inline constexpr std::string_view openjdProgress = "openjd_progress: ";

/// A job on `threads` threads (0: all cores) that reports its progress.
JobControl jobWithProgress(const std::string& label, int threads);

} // namespace mirrorball::cli
