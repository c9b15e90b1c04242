#pragma once

#include "mesh.h"

#include "core/base/job.h"

#include <filesystem>
#include <span>
#include <string_view>

namespace mirrorball::preview {

/// Extensions of the mesh files that can be read, with their dots: .obj .ply .stl .off .gltf .glb .fbx .dae .3ds
std::span<const std::string_view> meshExtensions();
bool isMeshFile(const std::filesystem::path& path);

/// What a mesh file may hold.
struct MeshLimits {
    std::uintmax_t fileBytes = std::uintmax_t{256} << 20; ///< of the file, and of each one beside it that it names
    std::size_t triangles = 8'000'000;
    std::uintmax_t memoryBytes = std::uintmax_t{6} << 30; ///< for reading it
    unsigned seconds = 60;                                ///< processor time for reading it
};

/// Reads a mesh file through assimp: all its bodies in one, where the file puts them, centred and scaled so that its bounding sphere is
/// the unit sphere about the origin. Faces are cut into triangles. Normals that are missing are made, smooth across edges of less than 80
/// degrees; triangles wind counterclockwise seen from the side that their normals are on. A closed body hides its inside (openFrom).
/// Texture coordinates that are missing are 0.
///
/// Files come from anywhere and the importers are large: one runs in a process of its own, whose memory and time are limited and whose
/// end is an error message. It opens regular files in the folder of the mesh or below it, and no others.
/// @throws FileError for a file that is missing, damaged, without a triangle or beyond the limits; Cancelled
Mesh readMesh(const std::filesystem::path& path, const JobControl& job = {}, const MeshLimits& limits = {});

} // namespace mirrorball::preview
