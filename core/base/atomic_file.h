#pragma once

#include "temporary_path.h"

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <optional>

namespace mirrorball {

/// When a file that was committed survives a loss of power: soon (what can be made again) or at once (documents that people save).
enum class Durability { Buffered, Synced };

/// `target` with symbolic links followed: what is to be replaced.
/// @throws WorkError naming `target` where that is a folder or a device
std::filesystem::path replaceableTarget(const std::filesystem::path& target);

/// Gives the open file `descriptor` the owner, group and permissions of `existing`, if there is such a file and as far as this process
/// may. What runs with its owner's rights (setuid, setgid) is never carried over, nor are permissions for a group that cannot be kept.
void takeOwnership(int descriptor, const std::filesystem::path& existing);

/// A file that appears whole or not at all: bytes go to a temporary name beside the target, commit() renames it into place, and an
/// object that goes without commit() leaves nothing behind. Every failure of the system is seen: a full disk shows up in write() or,
/// at the latest, in commit(), also when the code between swallowed the exception (OpenEXR's destructors do).
/// A target that is a symbolic link is written through; an existing target keeps its owner and permissions (takeOwnership).
class AtomicFile {
public:
    /// @throws WorkError when the folder is missing or not writable, or the target is a folder or a device
    explicit AtomicFile(const std::filesystem::path& target, Durability durability = Durability::Buffered);
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;
    ~AtomicFile();

    /// @throws WorkError
    void write(const void* bytes, size_t count);
    std::uint64_t position();
    void seek(std::uint64_t position);
    /// Where the bytes are until commit(), for a library that must open the file by itself; it writes all or nothing of them then.
    const std::filesystem::path& temporary() const { return m_temporary->path(); }
    /// Closes the file and gives it its name. @throws WorkError, also for a write that failed earlier
    void commit();

private:
    [[noreturn]] void fail(int error);

    std::filesystem::path m_named;  ///< as the caller wrote it, for messages
    std::filesystem::path m_target; ///< links followed
    Durability m_durability;
    std::optional<TemporaryPath> m_temporary{};
    std::FILE* m_file = nullptr;
    int m_error = 0; ///< errno of the first failure
};

/// Whether an AtomicFile could be made here now, asked before the work whose result it is to take; leaves nothing behind.
/// @throws WorkError as AtomicFile()
void checkTarget(const std::filesystem::path& target);

} // namespace mirrorball
