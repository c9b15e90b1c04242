#pragma once

#include <assimp/DefaultIOSystem.h>

#include <cstdint>
#include <filesystem>
#include <set>
#include <string>

namespace mirrorball::helper {

/// The files that an importer may open: regular files in the folder of the mesh or below it. A mesh file can name any path of the machine
/// as its material or its buffer. Names are also found as URIs write them (`%20` for a space), and a byte order mark at the beginning of a
/// file is passed over, which several importers stumble on; faces of an .obj file that name what is not there are left out (obj_text.h).
class MeshFiles final : public Assimp::DefaultIOSystem {
public:
    MeshFiles(std::filesystem::path folder, std::uintmax_t largest) : m_folder(std::move(folder)), m_largest(largest) {}

    bool Exists(const char* file) const override { return !found(file).empty(); }
    Assimp::IOStream* Open(const char* file, const char* mode) override;
    std::uint64_t dropped() const { return m_dropped; }              ///< faces
    const std::set<std::string>& opened() const { return m_opened; } ///< absolute

private:
    /// The file that the name means; empty for none that may be opened.
    std::filesystem::path found(const char* name) const;
    bool allows(const std::filesystem::path& file) const;

    std::filesystem::path m_folder;
    std::uintmax_t m_largest;
    std::uint64_t m_dropped = 0;
    std::set<std::string> m_opened{};
};

} // namespace mirrorball::helper
