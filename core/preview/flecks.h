#pragma once

#include "core/scene/flecks.h"

#include <glm/glm.hpp>

#include <cstdint>

/// Flecks: the surface in cells, some of which look a sphere map up elsewhere, as facets that are turned at random. Space is cut into cubes
/// with a point in each; a place belongs to the cell of its nearest point. All that a cell is follows from its hash, so that it stays what
/// it is however the camera moves. Twin: resources/shaders/lib/flecks.glsl. Source: 003 section 6.2
namespace mirrorball::preview {

/// A cell that a place may lie in.
struct FleckCell {
    glm::vec2 offset{0.0f}; ///< of the lookup; 0 where the cell is no fleck
    bool isFleck = false;
};

/// The two cells nearest to a place, and how far the border between them is.
struct FleckPlace {
    FleckCell own{}, neighbor{};
    float border = 0.0f; ///< in cells
};

/// Three dependable random numbers from three. Source: Jarzynski and Olano, Hash Functions for GPU Rendering, JCGT 9(3), 2020 (pcg3d)
glm::uvec3 pcg3d(glm::uvec3 v);

/// @param position on the object, its radius 1 @param flecks their density as it is there, times a pattern's share
FleckPlace fleckPlace(const glm::vec3& position, const Flecks& flecks);

} // namespace mirrorball::preview
