#pragma once

#include <glm/glm.hpp>

#include <array>
#include <cstddef>

/// The control points of Martin Newell's teapot (1975).
namespace mirrorball::preview {

/// A bicubic Bezier patch: point [4 v + u]. The outward normal is dS/dv x dS/du.
using BezierPatch = std::array<glm::dvec3, 16>;

/// A patch and how finely it wants to be cut in proportion to the pot: a small or nearly flat one needs fewer quads for the same
/// smoothness. Patches that share an edge have the same share along it.
struct TeapotPatch {
    BezierPatch points{};
    double uShare = 1.0; ///< of the quads along a quarter of the belly
    double vShare = 1.0;
};

/// Bottom (4), lid (8), handle (4), body (12), spout (4).
using TeapotPatches = std::array<TeapotPatch, 32>;
/// The inside of the patches from here on, body and spout, can be seen: through the spout and beside the lid.
inline constexpr std::size_t firstOpenPatch = 16;

/// Newell's units, bottom at y = 0, Y up, spout towards +X.
TeapotPatches teapotPatches();

} // namespace mirrorball::preview
