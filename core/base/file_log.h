#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

namespace mirrorball {

/// What tells a file that was changed from one that was not, without reading it.
struct FileStamp {
    std::uint64_t device = 0, inode = 0, bytes = 0;
    std::int64_t changedNs = 0; ///< the time of its last change, in nanoseconds since 1970

    bool operator==(const FileStamp&) const = default;
};
/// @throws std::system_error where there is no such file
FileStamp fileStamp(const std::filesystem::path& path);

/// An input, as it was when it was opened.
struct FileRead {
    std::filesystem::path path; ///< absolute
    FileStamp stamp{};
};

/// Which files this process reads as input and which it writes as output while one of these lives: what a recipe must name. Readers and
/// writers tell it (noteRead, noteWritten), so that what a scene, a mesh or a manifest names is found as surely as what an option does.
/// One at a time; any thread may read and write meanwhile.
class FileLog {
public:
    FileLog();
    FileLog(const FileLog&) = delete;
    FileLog& operator=(const FileLog&) = delete;
    ~FileLog();

    /// Every file once, in the order in which they were opened first.
    std::vector<FileRead> read() const;
    /// Absolute; those that are still there, once each, in the order in which they appeared.
    std::vector<std::filesystem::path> written() const;
};

/// Told by whatever opens a file whose content the result depends on. Costs nothing where no FileLog lives.
void noteRead(const std::filesystem::path& path);
/// Told when a file has got its last name.
void noteWritten(const std::filesystem::path& path);

} // namespace mirrorball
