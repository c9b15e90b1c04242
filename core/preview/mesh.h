#pragma once

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

/// Geometry to look at a material on: the Utah teapot, a torus, a sphere and a box. No OpenGL here.
namespace mirrorball::preview {

/// Indexed triangles, counterclockwise seen from outside. A value. +Y is up.
struct Mesh {
    std::vector<glm::vec3> positions{};
    std::vector<glm::vec3> normals{};     ///< unit, outward; one per position
    std::vector<glm::vec2> texCoords{};   ///< one per position, (0, 0) at a picture's lower left; none: its file has none
    std::vector<std::uint32_t> indices{}; ///< three per triangle
    std::size_t openFrom = 0;             ///< triangles from this index on can be seen from behind, through a hole

    bool operator==(const Mesh&) const = default;
};

/// The smallest box along the axes that holds the mesh.
struct BoundingBox {
    glm::vec3 low{0.0f}, high{0.0f};
};
BoundingBox boundingBox(const Mesh& mesh);

/// A sphere that holds the mesh: centered on the bounding box, touching the farthest vertex.
struct BoundingSphere {
    glm::vec3 center{0.0f};
    float radius = 0.0f;
};
BoundingSphere boundingSphere(const Mesh& mesh);

/// The Utah teapot with lid, spout, handle and bottom, spout towards +X, scaled to the unit sphere about the origin.
/// @param level quads along a quarter of the belly's circumference, at least 2; along shorter and flatter curves there are fewer in
///              proportion, so that all look equally smooth
Mesh teapotMesh(int level = 12);

/// A ring about the Y axis. @param ringRadius R of the center circle; @param tubeRadius r < R
Mesh torusMesh(float ringRadius = 0.7f, float tubeRadius = 0.3f, int ringSegments = 96, int tubeSegments = 48);

/// A sphere about the origin: a cube whose faces of level x level quads are blown up, so that no vertex is a pole.
Mesh sphereMesh(float radius = 1.0f, int level = 32);

/// A box about the origin with flat faces. @param halfSize half the edge lengths
Mesh boxMesh(const glm::vec3& halfSize = glm::vec3(0.57735f));

} // namespace mirrorball::preview
