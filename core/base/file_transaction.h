#pragma once

#include "temporary_path.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace mirrorball {

/// Files that come into a folder together. They are made in a folder beside their places, synced once, and then given their names at a
/// stroke, one rename after the other; what ends before that leaves the folder as it was. Two transactions on one folder take turns with
/// their renames, so that the files of one of them stay together. A file system has no more to offer: whoever must know after a power cut
/// in the middle of the renames reads the manifest, which comes last and has size and checksum of each file.
class FileTransaction {
public:
    /// @throws WorkError where nothing can be written in the folder
    explicit FileTransaction(const std::filesystem::path& folder);

    /// Where the files are to be made, under their last names.
    const std::filesystem::path& staging() const { return m_staging.path(); }
    /// A message about a file of the staging folder, about its last place.
    std::string aboutTheFolder(std::string message) const;
    /// Adds a manifest that names the files of this transaction, and those that an older one names and this one does not replace:
    /// {"version": 1, "files": [{"file", "bytes", "crc32"}]}. @throws WorkError
    void addManifest();
    /// Gives all files their names, the manifest's last. @throws WorkError, before the first rename where it can be foreseen
    void commit();

    static constexpr std::string_view manifestName = "export-manifest.json";

private:
    std::vector<std::filesystem::path> names() const;

    std::filesystem::path m_folder;
    TemporaryPath m_staging;
};

} // namespace mirrorball
