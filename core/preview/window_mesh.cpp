#include "window_mesh.h"

namespace mirrorball::preview {

namespace {

using window::Part;

void addQuad(Mesh& mesh, Part part, const glm::vec3& origin, const glm::vec3& right, const glm::vec3& up)
{
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (const glm::vec3& corner : {origin, origin + right, origin + right + up, origin + up}) {
        mesh.positions.push_back(corner);
        mesh.normals.push_back(glm::normalize(glm::cross(right, up)));
        mesh.texCoords.emplace_back(static_cast<float>(part), 0.0f);
    }
    for (const std::uint32_t index : {0u, 1u, 2u, 0u, 2u, 3u})
        mesh.indices.push_back(first + index);
}

void addBox(Mesh& mesh, Part part, const glm::vec3& low, const glm::vec3& high)
{
    const glm::vec3 x(high.x - low.x, 0, 0), y(0, high.y - low.y, 0), z(0, 0, high.z - low.z);
    addQuad(mesh, part, low + z, x, y);
    addQuad(mesh, part, high - y - z, -x, y);
    addQuad(mesh, part, low + x + z, -z, y);
    addQuad(mesh, part, low, z, y);
    addQuad(mesh, part, low + y + z, x, -z);
    addQuad(mesh, part, low, x, z);
}

} // namespace

Mesh windowMesh()
{
    Mesh mesh;
    const glm::vec2 low = window::paneCenter - window::paneHalf, high = window::paneCenter + window::paneHalf;
    const float left = -2.2f, right = 2.2f, floor = -1.05f, ceiling = 1.35f, depth = 5.0f;
    // The wall with its hole.
    addQuad(mesh, Part::Plaster, {left, floor, 0}, {low.x - left, 0, 0}, {0, ceiling - floor, 0});
    addQuad(mesh, Part::Plaster, {high.x, floor, 0}, {right - high.x, 0, 0}, {0, ceiling - floor, 0});
    addQuad(mesh, Part::Plaster, {low.x, floor, 0}, {high.x - low.x, 0, 0}, {0, low.y - floor, 0});
    addQuad(mesh, Part::Plaster, {low.x, high.y, 0}, {high.x - low.x, 0, 0}, {0, ceiling - high.y, 0});
    // The room.
    addQuad(mesh, Part::Floor, {left, floor, depth}, {right - left, 0, 0}, {0, 0, -depth});
    addQuad(mesh, Part::Plaster, {left, ceiling, 0}, {right - left, 0, 0}, {0, 0, depth});
    addQuad(mesh, Part::Plaster, {left, floor, depth}, {0, 0, -depth}, {0, ceiling - floor, 0});
    addQuad(mesh, Part::Plaster, {right, floor, 0}, {0, 0, depth}, {0, ceiling - floor, 0});
    // The pane, and the bars before it.
    addQuad(mesh, Part::Pane, {low.x, low.y, 0}, {high.x - low.x, 0, 0}, {0, high.y - low.y, 0});
    const float bar = 0.045f, thin = 0.016f, out = 0.05f;
    addBox(mesh, Part::Frame, {low.x - bar, low.y - bar, 0}, {low.x + 0.01f, high.y + bar, out});
    addBox(mesh, Part::Frame, {high.x - 0.01f, low.y - bar, 0}, {high.x + bar, high.y + bar, out});
    addBox(mesh, Part::Frame, {low.x, high.y - 0.01f, 0}, {high.x, high.y + bar, out});
    addBox(mesh, Part::Frame, {low.x - 0.12f, low.y - bar, 0}, {high.x + 0.12f, low.y, 3.0f * out});
    addBox(mesh, Part::Frame, {-thin, low.y, 0}, {thin, high.y, 0.5f * out});
    const float rail = window::paneCenter.y + 0.3f * window::paneHalf.y;
    addBox(mesh, Part::Frame, {low.x, rail - thin, 0}, {high.x, rail + thin, 0.5f * out});
    return mesh; // openFrom 0: it is seen from inside
}

} // namespace mirrorball::preview
