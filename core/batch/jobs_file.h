#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

/// What `mirrorball batch` makes: a list of commands in a JSON file.
///
///   {"version": 1, "per_task": 25, "jobs": [
///     {"command": ["filter", "probes/{stem}.hdr", "-o", "maps/{stem}.exr", ...], "each": ["probes/*.hdr"]},
///     {"scene": "car.mirrorball", "frames": "1-24", "picture": "frames/car.####.png", "options": ["--set", "probe.yaw={frame}"]},
///     {"scene": "car.mirrorball", "exports": "game/car"}]}
namespace mirrorball {

/// One command, and where the file says so.
struct BatchCommand {
    std::string where{};              ///< "jobs[3].command", with the frame or file it is made for
    std::vector<std::string> words{}; ///< of the command line, without the program's name

    bool operator==(const BatchCommand&) const = default;
};

/// A jobs file, read: commands in the order of the file, and tasks of so many of them one after the other.
struct BatchFile {
    std::filesystem::path folder{}; ///< the file's own, absolute: relative paths in it start there
    std::vector<BatchCommand> commands{};
    int perTask = 1;

    size_t taskCount() const { return (commands.size() + static_cast<size_t>(perTask) - 1) / static_cast<size_t>(perTask); }
    /// The commands of a task, which is below taskCount().
    std::span<const BatchCommand> task(size_t number) const;
    /// The task of a command.
    size_t taskOf(size_t command) const { return command / static_cast<size_t>(perTask); }
};

/// Reads a jobs file and writes out what `frames` and `each` stand for. A pattern of `each` is answered with the files that are there now,
/// by name.
/// @throws FileError naming the field: an unknown key, a missing file, nothing to do, more than a million commands
BatchFile loadJobs(const std::filesystem::path& path);

} // namespace mirrorball
