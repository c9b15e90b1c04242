#pragma once

#include <glm/glm.hpp>

#include <array>
#include <vector>

/// The control points of Martin Newell's teapot (1975).
namespace mirrorball::preview {

/// A bicubic Bezier patch: point [4 v + u]. The outward normal is dS/dv x dS/du.
using BezierPatch = std::array<glm::dvec3, 16>;

/// The 32 patches: rim, body and bottom (16), lid (8), handle (4), spout (4). Newell's units, bottom at y = 0, Y up, spout towards +X.
std::vector<BezierPatch> teapotPatches();

} // namespace mirrorball::preview
