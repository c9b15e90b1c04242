#pragma once

#include "mesh.h"

#include "core/base/wire.h"

#include <algorithm>
#include <cmath>
#include <string>

/// What the helper makes of a mesh file.
namespace mirrorball::preview {

/// A mesh as its file has it: not centered, not scaled.
struct ImportedMesh {
    Mesh mesh{};
    std::uint64_t dropped = 0; ///< faces left out, because a vertex of theirs does not exist or is no finite number
    std::string files{};       ///< absolute paths of the files that were opened, each ended by a zero byte
};

inline std::string toWire(const ImportedMesh& imported)
{
    WireWriter writer;
    writer << imported.dropped << std::string_view(imported.files) << imported.mesh.positions << imported.mesh.normals
           << imported.mesh.texCoords << imported.mesh.indices;
    return std::move(writer).bytes();
}

inline bool isFinite(const glm::vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

/// @return false for bytes that are no mesh's: what a failing importer may have sent is not trusted. Numbers that are none have no order,
///         and what sorts a mesh's corners by their places would run off its list.
inline bool fromWire(std::string_view bytes, ImportedMesh& imported)
{
    WireReader reader(bytes);
    Mesh& mesh = imported.mesh;
    reader >> imported.dropped >> imported.files >> mesh.positions >> mesh.normals >> mesh.texCoords >> mesh.indices;
    return reader.isDone() && mesh.normals.size() == mesh.positions.size() &&
           (mesh.texCoords.empty() || mesh.texCoords.size() == mesh.positions.size()) && mesh.indices.size() % 3 == 0 &&
           std::all_of(mesh.indices.begin(), mesh.indices.end(),
                       [&](std::uint32_t i) { return i < mesh.positions.size() && isFinite(mesh.positions[i]); });
}

} // namespace mirrorball::preview
