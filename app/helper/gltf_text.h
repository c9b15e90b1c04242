#pragma once

#include <functional>
#include <optional>
#include <string>

namespace mirrorball::helper {

/// A glTF file whose places, normals and texture coordinates are floats.
struct GltfText {
    std::string bytes{};  ///< of the .gltf or .glb file
    std::string floats{}; ///< of the buffer that it names `gltfFloats`; empty where nothing was unpacked
};

/// The name of the buffer of unpacked attributes, beside the file.
inline constexpr const char* gltfFloats = "mirrorball-unpacked-attributes.bin";

/// Unpacks what KHR_mesh_quantization, and for texture coordinates glTF itself, let be 8- or 16-bit integers: assimp takes their bytes for
/// floats. What is not understood stays as it is, for assimp to refuse.
/// @param beside  the bytes of a file that a buffer's URI names; none where there is no such file
/// @throws InvalidArgument for attributes that lie beyond their buffer, and for packings that are not read
GltfText withFloatAttributes(const std::string& bytes, const std::function<std::optional<std::string>(const std::string& uri)>& beside);

} // namespace mirrorball::helper
