#pragma once

#include <assimp/scene.h>

#include <cstdint>

namespace mirrorball::helper {

/// Makes an imported scene safe and right for assimp's own steps, which take indices on trust and refuse a whole mesh for one bad number.
/// Faces with vertices that do not exist or are not finite go; so do colors, tangents, bones and morph targets. The corners of a mesh
/// without normals get a vertex each: assimp's smoothing would else give a shared vertex the normal of its last face.
/// @return the faces that went
std::uint64_t clean(aiScene& scene);

} // namespace mirrorball::helper
