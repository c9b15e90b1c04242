#pragma once

#include <cstdint>
#include <string>

namespace mirrorball::helper {

struct ObjText {
    std::string text{};
    std::uint64_t dropped = 0; ///< faces left out
};

/// The text of an .obj file without the faces that name a vertex, texture coordinate or normal that does not exist: assimp refuses the
/// whole file for one of them. Indices count from 1, negative ones from the last (Wavefront's object files, appendix B1).
ObjText withoutBadFaces(const std::string& text);

} // namespace mirrorball::helper
