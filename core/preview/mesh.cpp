#include "mesh.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace mirrorball::preview {

namespace {

// The two triangles of a quad with corners a b c d, counterclockwise.
void addQuad(Mesh& mesh, size_t a, size_t b, size_t c, size_t d)
{
    for (const size_t index : {a, b, c, a, c, d})
        mesh.indices.push_back(static_cast<std::uint32_t>(index));
}

void addVertex(Mesh& mesh, const glm::dvec3& position, const glm::dvec3& normal, const glm::dvec2& texCoord)
{
    mesh.positions.emplace_back(position);
    mesh.normals.emplace_back(normal);
    mesh.texCoords.emplace_back(texCoord);
}

// A point of the cube [-1, 1]^3 carried onto the unit sphere. The squares are summed in order of size, so that the point gets the
// same rounding whichever face it is reached from.
glm::dvec3 ontoSphere(const glm::dvec3& p)
{
    double squares[3] = {p.x * p.x, p.y * p.y, p.z * p.z};
    std::sort(squares, squares + 3);
    return p / std::sqrt(squares[0] + squares[1] + squares[2]);
}

// Axes of a cube face: the outward axis, and two that span the face so that right x up = outward.
struct Face {
    glm::dvec3 outward, right, up;
};
constexpr double o = 0.0, p = 1.0, m = -1.0;
const Face faces[6] = {{{p, o, o}, {o, o, m}, {o, p, o}}, {{m, o, o}, {o, o, p}, {o, p, o}}, {{o, p, o}, {p, o, o}, {o, o, m}},
                       {{o, m, o}, {p, o, o}, {o, o, p}}, {{o, o, p}, {p, o, o}, {o, p, o}}, {{o, o, m}, {m, o, o}, {o, p, o}}};

} // namespace

BoundingBox boundingBox(const Mesh& mesh)
{
    if (mesh.positions.empty())
        return {};
    BoundingBox box{mesh.positions.front(), mesh.positions.front()};
    for (const glm::vec3& position : mesh.positions) {
        box.low = glm::min(box.low, position);
        box.high = glm::max(box.high, position);
    }
    return box;
}

BoundingSphere boundingSphere(const Mesh& mesh)
{
    const BoundingBox box = boundingBox(mesh);
    BoundingSphere sphere{0.5f * (box.low + box.high), 0.0f};
    for (const glm::vec3& position : mesh.positions)
        sphere.radius = std::max(sphere.radius, glm::distance(position, sphere.center));
    return sphere;
}

Mesh torusMesh(float ringRadius, float tubeRadius, int ringSegments, int tubeSegments)
{
    ringSegments = std::max(3, ringSegments);
    tubeSegments = std::max(3, tubeSegments);
    Mesh mesh;
    // The last row and column repeat the first ones' positions exactly, with texture coordinate 1 instead of 0.
    for (int i = 0; i <= ringSegments; ++i) {
        const double a = 2.0 * std::numbers::pi * (i % ringSegments) / ringSegments;
        const glm::dvec3 outward(std::cos(a), 0.0, -std::sin(a)); // counterclockwise seen from above
        for (int j = 0; j <= tubeSegments; ++j) {
            const double b = 2.0 * std::numbers::pi * (j % tubeSegments) / tubeSegments;
            const glm::dvec3 normal = std::cos(b) * outward + glm::dvec3(0.0, std::sin(b), 0.0);
            addVertex(mesh, double(ringRadius) * outward + double(tubeRadius) * normal, normal,
                      {double(i) / ringSegments, double(j) / tubeSegments});
        }
    }
    const size_t stride = static_cast<size_t>(tubeSegments) + 1;
    for (size_t i = 0; i < static_cast<size_t>(ringSegments); ++i)
        for (size_t j = 0; j < static_cast<size_t>(tubeSegments); ++j)
            addQuad(mesh, i * stride + j, (i + 1) * stride + j, (i + 1) * stride + j + 1, i * stride + j + 1);
    mesh.openFrom = mesh.indices.size();
    return mesh;
}

Mesh sphereMesh(float radius, int level)
{
    level = std::max(1, level);
    Mesh mesh;
    const size_t stride = static_cast<size_t>(level) + 1;
    for (const Face& face : faces) {
        const size_t first = mesh.positions.size();
        for (int j = 0; j <= level; ++j)
            for (int i = 0; i <= level; ++i) {
                // Equal angles instead of equal steps on the face: the quads come out nearly alike.
                const auto warp = [level](int k) {
                    return std::abs(2 * k - level) == level ? double((2 * k - level) / level)
                                                            : std::tan(0.25 * std::numbers::pi * (2 * k - level) / level);
                };
                const glm::dvec3 normal = ontoSphere(face.outward + warp(i) * face.right + warp(j) * face.up);
                addVertex(mesh, double(radius) * normal, normal, {double(i) / level, double(j) / level});
            }
        for (size_t j = 0; j < stride - 1; ++j)
            for (size_t i = 0; i < stride - 1; ++i)
                addQuad(mesh, first + j * stride + i, first + j * stride + i + 1, first + (j + 1) * stride + i + 1,
                        first + (j + 1) * stride + i);
    }
    mesh.openFrom = mesh.indices.size();
    return mesh;
}

Mesh boxMesh(const glm::vec3& halfSize)
{
    Mesh mesh;
    for (const Face& face : faces) {
        const size_t first = mesh.positions.size();
        for (const glm::dvec2 corner : {glm::dvec2(-1, -1), glm::dvec2(1, -1), glm::dvec2(1, 1), glm::dvec2(-1, 1)})
            addVertex(mesh, glm::dvec3(halfSize) * (face.outward + corner.x * face.right + corner.y * face.up), face.outward,
                      0.5 * (corner + 1.0));
        addQuad(mesh, first, first + 1, first + 2, first + 3);
    }
    mesh.openFrom = mesh.indices.size();
    return mesh;
}

} // namespace mirrorball::preview
