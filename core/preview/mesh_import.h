#pragma once

#include "mesh_file.h"

namespace mirrorball::preview {

/// What assimp makes of a file, as it stands in the file: not centred, not scaled. Runs in this process; readMesh() is the safe way.
/// @throws InvalidArgument saying what is wrong with the file, without its name
Mesh importMesh(const std::filesystem::path& path, const MeshLimits& limits);

} // namespace mirrorball::preview
