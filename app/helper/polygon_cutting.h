#pragma once

#include "off_text.h"

#include <assimp/scene.h>

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

/// Polygons as triangles, concave ones too. assimp's own step cuts off an ear though a corner of the polygon lies on the cut, as in a plain
/// L of six corners, and then covers places outside of it.
namespace mirrorball::helper {

/// Makes one face again of the pieces of each. @param split  in ascending order
/// @throws InvalidArgument where the importer has other faces than it was given
void joinFaces(aiScene& scene, std::span<const SplitFace> split);

/// The corners of a polygon, by number, as triangles that turn as it does. They cover what a simple polygon that is nearly plane encloses,
/// and nothing else: an ear is cut off only where no other corner lies in it or on its edges; a convex polygon becomes a fan about its
/// first corner. Polygons that cross themselves are covered somehow. Source: Meisters, "Polygons have ears" (1975).
std::vector<std::array<std::uint32_t, 3>> trianglesOf(std::span<const glm::dvec3> polygon);

/// Cuts every face of more than four corners, whose indices must be good ones; assimp finds the concave corner of four.
void cutPolygons(aiScene& scene);

} // namespace mirrorball::helper
