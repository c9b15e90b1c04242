#pragma once

#include "connection.h"

#include "core/preview/mesh_file.h"
#include "core/preview/mesh_wire.h"

namespace mirrorball::helper {

/// What assimp makes of a file. @throws InvalidArgument saying what is wrong with the file, without its name
preview::ImportedMesh importMesh(const std::filesystem::path& path, const preview::MeshLimits& limits);

/// Answers a request for a mesh. @throws InvalidArgument
void serveMesh(const Received& request, Connection& connection);

} // namespace mirrorball::helper
