#pragma once

#include "mesh.h"

#include "core/base/job.h"

#include <filesystem>
#include <span>
#include <string>
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

/// What is to be said of a mesh file.
struct MeshFacts {
    std::uint64_t triangles = 0; ///< shown
    std::uint64_t dropped = 0;   ///< bad faces left out
    double extent = 0.0;         ///< longest edge of its bounding box, in the file's units
    bool isMetric = false;       ///< the format says that its unit is the metre (glTF)
};
/// "68 644 triangles, 13 cm"
std::string describe(const MeshFacts& facts);

struct MeshFile {
    Mesh mesh{};
    MeshFacts facts{};
};

/// Reads a mesh file through assimp: all its bodies in one, where the file puts them, centered and scaled so that its bounding sphere is
/// the unit sphere about the origin. Faces are cut into triangles. Normals that are missing are made, smooth across edges of less than 80
/// degrees; triangles wind counterclockwise seen from the side that their normals are on. A closed body hides its inside (openFrom).
/// Texture coordinates that are missing are 0; of a file that has none at all, the mesh has none.
///
/// Faces with vertices that do not exist or are not finite are left out and counted; faces without area are left out.
///
/// Files come from anywhere and the importers are large: they run in the helper (core/base/helper_process.h), whose memory and time are
/// limited and whose end is an error message. It opens regular files in the folder of the mesh or below it, and no others.
/// @throws FileError for a file that is missing, damaged, without a triangle or beyond the limits; Cancelled
MeshFile readMeshFile(const std::filesystem::path& path, const JobControl& job = {}, const MeshLimits& limits = {});
/// The same, the mesh alone.
Mesh readMesh(const std::filesystem::path& path, const JobControl& job = {}, const MeshLimits& limits = {});

} // namespace mirrorball::preview
