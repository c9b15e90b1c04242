#pragma once

#include <filesystem>

namespace mirrorball {

/// A file or folder that is there only while something is being made: beside its target, under a name that nobody else uses, and gone with
/// this object, with the process when a signal ends it (removeTemporariesOnSignals), or else with the next process that makes one in the
/// same folder on the same machine, or a week later on any other. An open file lock tells which are still in use: it is gone with a
/// process, whatever ended it; but a share need not show one machine the locks of another.
class TemporaryPath {
public:
    enum class Kind { File, Folder };

    /// Makes an empty one in the folder of `target`. @throws std::system_error
    TemporaryPath(const std::filesystem::path& target, Kind kind);
    TemporaryPath(const TemporaryPath&) = delete;
    TemporaryPath& operator=(const TemporaryPath&) = delete;
    ~TemporaryPath();

    const std::filesystem::path& path() const { return m_path; }
    /// Open for reading and writing (a folder: for reading). It belongs to this object and holds the lock.
    int descriptor() const { return m_descriptor; }
    /// The path has another name now: nothing is left to remove.
    void release();

private:
    std::filesystem::path m_path;
    int m_descriptor = -1;
    int m_slot = -1; ///< in the list of what a signal removes
};

/// Removes every temporary path of this process. Safe in a signal handler.
void removeTemporaries() noexcept;

/// From now on SIGINT, SIGTERM and SIGHUP remove the temporary paths and then end the process as they would have. A signal that is ignored
/// (`nohup`) stays so. Call it once, in main.
void removeTemporariesOnSignals();

} // namespace mirrorball
