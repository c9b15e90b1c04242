#pragma once

#include "off_text.h"

#include <assimp/DefaultIOSystem.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

namespace mirrorball::helper {

/// The files that an importer may open: regular files in the folder of the mesh or below it. A mesh file can name any path of the machine
/// as its material or its buffer. Names are also found as URIs write them (`%20` for a space), and a byte order mark at the beginning of a
/// file is passed over, which several importers stumble on. The mesh itself is handed out as importers read it right (obj_text.h,
/// off_text.h, gltf_text.h).
class MeshFiles final : public Assimp::DefaultIOSystem {
public:
    /// @param mesh  canonical
    /// @throws InvalidArgument for a mesh that is packed in a way which is not read
    MeshFiles(const std::filesystem::path& mesh, std::uintmax_t largest);

    bool Exists(const char* file) const override { return isUnpacked(file) || !found(file).empty(); }
    Assimp::IOStream* Open(const char* file, const char* mode) override;
    std::uint64_t dropped() const { return m_dropped; } ///< faces
    std::span<const SplitFace> split() const { return m_split; }
    const std::set<std::string>& opened() const { return m_opened; } ///< absolute

private:
    /// Whether the name is that of the buffer of unpacked attributes, which is no file.
    bool isUnpacked(const std::filesystem::path& name) const;
    /// The bytes of a file that a buffer's URI names.
    std::optional<std::string> bytesBeside(const std::string& uri);
    /// The file that the name means; empty for none that may be opened.
    std::filesystem::path found(const char* name) const;
    bool allows(const std::filesystem::path& file) const;

    std::filesystem::path m_mesh, m_folder;
    std::uintmax_t m_largest;
    std::optional<std::string> m_text{}; ///< of the mesh, where it is not handed out as it is
    std::string m_floats{};              ///< of the buffer of unpacked attributes
    std::uint64_t m_dropped = 0;
    std::vector<SplitFace> m_split{};
    std::set<std::string> m_opened{};
};

} // namespace mirrorball::helper
