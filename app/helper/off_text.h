#pragma once

#include <cstdint>
#include <string>

namespace mirrorball::helper {

struct OffText {
    std::string text{};
    std::uint64_t dropped = 0; ///< faces left out
};

/// The text of an .off file (Geomview's object file formats) as assimp reads it right. assimp takes an index beyond the last vertex for the
/// last one, passes over faces of more than nine corners, counts comments as vertices, and takes memory for what a header claims. So faces
/// with such an index are left out, those with many corners become fans of triangles about their first one, comments go, and the counts
/// are those of the lines that are there.
/// @throws InvalidArgument for a binary file, and for one that has fewer lines than it claims
OffText cleanedOff(const std::string& text);

} // namespace mirrorball::helper
