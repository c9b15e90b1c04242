#pragma once

#include <cstdint>

/// What this process may do, and what one file may cost.
namespace mirrorball::helper {

/// Before anything of others is loaded: no core files, no files written, no rights gained by starting programs.
void limitProcess();

/// For the rest of its life this process can open files for reading, take memory, and write to one descriptor; it cannot reach the
/// network, start programs, write or remove files, or signal others. Call it once all libraries are loaded.
/// @throws WorkError where the system has no seccomp
void confine(int descriptor);

/// From now on so much more memory and processor time; at the end of either the process ends.
void allow(std::uint32_t milliseconds, std::uint64_t memoryBytes);

} // namespace mirrorball::helper
