#include "mesh_file.h"

#include "mesh_import.h"

#include "core/base/error.h"
#include "core/base/isolated.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstring>
#include <numeric>
#include <optional>
#include <tuple>

namespace mirrorball::preview {

namespace {

constexpr std::array<std::string_view, 9> extensions{".obj", ".ply", ".stl", ".off", ".gltf", ".glb", ".fbx", ".dae", ".3ds"};

template <class Element>
void put(std::string& bytes, const std::vector<Element>& elements)
{
    const std::uint64_t count = elements.size();
    bytes.append(reinterpret_cast<const char*>(&count), sizeof count);
    bytes.append(reinterpret_cast<const char*>(elements.data()), count * sizeof(Element));
}

template <class Element>
bool take(std::string_view& bytes, std::vector<Element>& elements)
{
    std::uint64_t count = 0;
    if (bytes.size() < sizeof count)
        return false;
    std::memcpy(&count, bytes.data(), sizeof count);
    bytes.remove_prefix(sizeof count);
    if (count > bytes.size() / sizeof(Element))
        return false;
    elements.resize(count);
    std::memcpy(elements.data(), bytes.data(), count * sizeof(Element));
    bytes.remove_prefix(count * sizeof(Element));
    return true;
}

std::string packed(const Mesh& mesh)
{
    std::string bytes;
    put(bytes, mesh.positions);
    put(bytes, mesh.normals);
    put(bytes, mesh.texCoords);
    put(bytes, mesh.indices);
    return bytes;
}

// What a crashing importer may have written is not trusted.
bool unpack(std::string_view bytes, Mesh& mesh)
{
    return take(bytes, mesh.positions) && take(bytes, mesh.normals) && take(bytes, mesh.texCoords) && take(bytes, mesh.indices) &&
           mesh.normals.size() == mesh.positions.size() && mesh.texCoords.size() == mesh.positions.size() && mesh.indices.size() % 3 == 0 &&
           std::all_of(mesh.indices.begin(), mesh.indices.end(), [&](std::uint32_t i) { return i < mesh.positions.size(); });
}

// Vertices that no triangle uses would widen the bounds: a damaged one may lie anywhere.
void dropUnused(Mesh& mesh)
{
    std::vector<std::uint32_t> moved(mesh.positions.size(), ~0u);
    std::uint32_t count = 0;
    for (std::uint32_t& index : mesh.indices) {
        if (moved[index] == ~0u)
            moved[index] = count++;
        index = moved[index];
    }
    Mesh kept;
    kept.positions.resize(count);
    kept.normals.resize(count);
    kept.texCoords.resize(count);
    for (size_t i = 0; i < moved.size(); ++i)
        if (moved[i] != ~0u) {
            kept.positions[moved[i]] = mesh.positions[i];
            kept.normals[moved[i]] = mesh.normals[i];
            kept.texCoords[moved[i]] = mesh.texCoords[i];
        }
    kept.indices = std::move(mesh.indices);
    mesh = std::move(kept);
}

// In double: a model may stand far from its origin.
bool fitUnitSphere(Mesh& mesh)
{
    glm::dvec3 low(mesh.positions.front()), high = low;
    for (const glm::vec3& p : mesh.positions) {
        low = glm::min(low, glm::dvec3(p));
        high = glm::max(high, glm::dvec3(p));
    }
    const glm::dvec3 centre = 0.5 * (low + high);
    double radius = 0.0;
    for (const glm::vec3& p : mesh.positions)
        radius = std::max(radius, glm::distance(glm::dvec3(p), centre));
    if (!(radius > 0.0) || !std::isfinite(radius))
        return false;
    for (glm::vec3& p : mesh.positions)
        p = glm::vec3((glm::dvec3(p) - centre) / radius);
    return true;
}

// Every edge runs once each way, vertices at one place counting as one. Then no inside can be seen.
bool isClosed(const Mesh& mesh)
{
    const auto at = [&](std::uint32_t i) { return std::tie(mesh.positions[i].x, mesh.positions[i].y, mesh.positions[i].z); };
    std::vector<std::uint32_t> order(mesh.positions.size()), place(mesh.positions.size());
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return at(a) < at(b); });
    for (size_t i = 0; i < order.size(); ++i)
        place[order[i]] = i > 0 && at(order[i]) == at(order[i - 1]) ? place[order[i - 1]] : static_cast<std::uint32_t>(i);
    std::vector<std::pair<std::uint32_t, std::uint32_t>> forth, back;
    for (size_t i = 0; i < mesh.indices.size(); i += 3)
        for (size_t k = 0; k < 3; ++k) {
            const std::uint32_t a = place[mesh.indices[i + k]], b = place[mesh.indices[i + (k + 1) % 3]];
            if (a == b)
                continue;
            forth.emplace_back(a, b);
            back.emplace_back(b, a);
        }
    std::sort(forth.begin(), forth.end());
    std::sort(back.begin(), back.end());
    return forth == back;
}

} // namespace

std::span<const std::string_view> meshExtensions() { return extensions; }

bool isMeshFile(const std::filesystem::path& path)
{
    std::string extension = path.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return std::find(extensions.begin(), extensions.end(), extension) != extensions.end();
}

Mesh readMesh(const std::filesystem::path& path, const JobControl& job, const MeshLimits& limits)
{
    std::error_code error;
    const auto refuse = [&](const std::string& message) { throw FileError(path.string(), message); };
    if (!std::filesystem::exists(path, error))
        refuse("does not exist; check the path");
    if (!std::filesystem::is_regular_file(path, error))
        refuse("is no file; give a mesh file");
    if (!isMeshFile(path)) {
        std::string known;
        for (const std::string_view extension : extensions)
            known += ' ' + std::string(extension);
        refuse("is no mesh file that can be read; export it as one of" + known);
    }
    if (std::filesystem::file_size(path, error) > limits.fileBytes)
        refuse("holds more than " + std::to_string(limits.fileBytes >> 20) + " MiB; reduce the mesh in a modeller");

    std::optional<std::string> bytes;
    try {
        bytes = runIsolated({.memoryBytes = limits.memoryBytes, .seconds = limits.seconds}, job,
                            [&] { return packed(importMesh(path, limits)); });
    } catch (const InvalidArgument& refusal) {
        refuse(refusal.what());
    }
    Mesh mesh;
    if (!bytes || !unpack(*bytes, mesh))
        refuse("the mesh is damaged or takes too much memory or time to read; export it again or reduce it");
    if (mesh.indices.empty())
        refuse("the file holds no triangle; export the surfaces, not curves or points");
    dropUnused(mesh);
    if (!fitUnitSphere(mesh))
        refuse("the mesh has no extent; export it again");
    mesh.openFrom = isClosed(mesh) ? mesh.indices.size() : 0;
    return mesh;
}

} // namespace mirrorball::preview
