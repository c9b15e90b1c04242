#pragma once

#include <glm/glm.hpp>

#include <cstdint>

/// Flecks: the surface in cells, some of which look a sphere map up elsewhere, as facets that are turned at random. Space is cut into cubes
/// with a point in each; a place belongs to the cell of its nearest point. All that a cell is follows from its hash, so that it stays what
/// it is however the camera moves. Twin: resources/shaders/lib/flecks.glsl. Source: 003 section 6.2
namespace mirrorball::preview {

struct Flecks {
    float density = 0.0f; ///< share of the cells that are flecks, [0, 1], times that of a pattern; 0: no shader code is built
    float size = 0.02f;   ///< edge of a cell
    float spread = 0.4f;  ///< radius of the disc that offsets are spread over evenly, in radii of the sphere map's disc
    int seed = 0;

    bool operator==(const Flecks&) const = default;
};

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
