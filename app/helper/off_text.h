#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace mirrorball::helper {

/// A face of which importers take only pieces: consecutive faces that hold its corners in their order.
struct SplitFace {
    std::uint64_t first = 0; ///< of the pieces, among the faces of the only mesh
    std::uint64_t pieces = 0;
};

struct OffText {
    std::string text{};
    std::uint64_t dropped = 0; ///< faces left out
    std::vector<SplitFace> split{};
};

/// The text of an .off file (Geomview's object file formats) as assimp reads it right. assimp takes an index beyond the last vertex for the
/// last one, passes over faces of more than nine corners, counts comments as vertices, and takes memory for what a header claims. So faces
/// with such an index are left out, those with many corners come in pieces, which joinFaces() (polygon_cutting.h) makes one again, comments
/// go, and the counts are those of the lines that are there.
/// @throws InvalidArgument for a binary file, and for one that has fewer lines than it claims
OffText cleanedOff(const std::string& text);

} // namespace mirrorball::helper
