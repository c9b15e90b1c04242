#pragma once

#include "job.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

namespace mirrorball {

/// What the process of runIsolated may use.
struct IsolationLimits {
    std::uintmax_t memoryBytes = std::uintmax_t{4} << 30; ///< more than this process has now
    unsigned seconds = 60;                                ///< of processor time
};

/// Runs `work` in a child process and returns the bytes that it returned: for code of others that reads files of others. A crash, a
/// runaway loop or memory without end is over with the child. An exception of `work` is thrown here as an InvalidArgument with the same
/// message. `work` must not touch threads, windows, or OpenGL.
/// @return nothing when the child crashed or passed a limit
/// @throws InvalidArgument as said; WorkError when no process can be made; Cancelled, which ends the child
std::optional<std::string> runIsolated(const IsolationLimits& limits, const JobControl& job, const std::function<std::string()>& work);

} // namespace mirrorball
