#include "mesh_file.h"

#include "mesh_wire.h"

#include "core/base/error.h"
#include "core/base/file_log.h"
#include "core/base/helper_process.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <numeric>
#include <sstream>
#include <string>
#include <tuple>

namespace mirrorball::preview {

namespace {

constexpr std::array<std::string_view, 9> extensions{".obj", ".ply", ".stl", ".off", ".gltf", ".glb", ".fbx", ".dae", ".3ds"};

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
    if (!mesh.texCoords.empty())
        kept.texCoords.resize(count);
    for (size_t i = 0; i < moved.size(); ++i)
        if (moved[i] != ~0u) {
            kept.positions[moved[i]] = mesh.positions[i];
            kept.normals[moved[i]] = mesh.normals[i];
            if (!mesh.texCoords.empty())
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
    const glm::dvec3 center = 0.5 * (low + high);
    double radius = 0.0;
    for (const glm::vec3& p : mesh.positions)
        radius = std::max(radius, glm::distance(glm::dvec3(p), center));
    if (!(radius > 0.0) || !std::isfinite(radius))
        return false;
    for (glm::vec3& p : mesh.positions)
        p = glm::vec3((glm::dvec3(p) - center) / radius);
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

namespace {

/// Reads a file of some 100 kB in a moment or not at all: what takes longer is made to.
HelperLimits helperLimits(std::uintmax_t fileBytes, const MeshLimits& limits)
{
    constexpr std::uintmax_t mib = std::uintmax_t{1} << 20;
    return {.seconds =
                helperSlowdown * std::min<double>(limits.seconds, 1.4 + 5.0 * static_cast<double>(fileBytes) / static_cast<double>(mib)),
            .memoryBytes = std::min(limits.memoryBytes, 512 * mib + 64 * fileBytes)};
}

ImportedMesh importedBy(const std::filesystem::path& path, std::uintmax_t fileBytes, const JobControl& job, const MeshLimits& limits)
{
    WireWriter request;
    request << std::string_view(path.native()) << std::uint64_t{limits.fileBytes} << std::uint64_t{limits.triangles};
    const HelperLimits allowed = helperLimits(fileBytes, limits);
    ImportedMesh imported;
    try {
        Helper helper(HelperWork::Meshes);
        if (fromWire(helper.ask(helper::Request::ReadMesh, std::move(request).bytes(), &allowed, job), imported))
            return imported;
        throw HelperEnded("it breaks the reader");
    } catch (const HelperEnded& ended) {
        throw FileError(path.string(), std::string("the mesh is damaged or does harm, because ") + ended.what() +
                                           "; export it again or reduce it in a modeller");
    } catch (const InvalidArgument& refusal) {
        throw FileError(path.string(), refusal.what());
    }
}

/// "68 644": thousands apart.
std::string grouped(std::uint64_t number)
{
    std::string text = std::to_string(number);
    for (size_t at = text.size(); at > 3; at -= 3)
        text.insert(at - 3, " ");
    return text;
}

/// A length in metres in the unit that suits it, two digits.
std::string lengthText(double metres)
{
    struct Unit {
        double metres;
        const char* name;
    };
    constexpr std::array<Unit, 5> units{{{1e3, "km"}, {1.0, "m"}, {1e-2, "cm"}, {1e-3, "mm"}, {1e-6, "um"}}};
    const Unit* unit = &units.back();
    for (const Unit& candidate : units)
        if (metres >= candidate.metres) {
            unit = &candidate;
            break;
        }
    std::array<char, 32> text{};
    const double number = metres / unit->metres;
    std::snprintf(text.data(), text.size(), number < 9.95 ? "%.1f %s" : "%.0f %s", number, unit->name);
    return text.data();
}

} // namespace

std::string describe(const MeshFacts& facts)
{
    std::string text = grouped(facts.triangles) + (facts.triangles == 1 ? " triangle, " : " triangles, ") + lengthText(facts.extent) +
                       (facts.isMetric ? "" : " if its unit is the metre");
    if (facts.dropped > 0)
        text += "; " + grouped(facts.dropped) + (facts.dropped == 1 ? " bad face" : " bad faces") + " left out";
    return text;
}

namespace {

/// Buffers that a .gltf file keeps beside itself. What a failing importer may have named is not trusted: it lies below the mesh's folder.
void noteFilesBeside(const std::filesystem::path& mesh, const std::string& files)
{
    std::error_code error;
    const std::filesystem::path folder = std::filesystem::canonical(mesh, error).parent_path();
    std::istringstream names(files);
    for (std::string file; std::getline(names, file, '\0');)
        if (const auto inside = std::filesystem::path(file).lexically_relative(folder); !inside.empty() && *inside.begin() != "..")
            noteRead(mesh.parent_path() / inside);
}

} // namespace

MeshFile readMeshFile(const std::filesystem::path& path, const JobControl& job, const MeshLimits& limits)
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
    const std::uintmax_t bytes = std::filesystem::file_size(path, error);
    if (error || bytes > limits.fileBytes)
        refuse("holds more than " + std::to_string(limits.fileBytes >> 20) + " MiB; reduce the mesh in a modeller");

    noteRead(path);
    ImportedMesh imported = importedBy(path, bytes, job, limits);
    noteFilesBeside(path, imported.files);
    Mesh& mesh = imported.mesh;
    if (mesh.indices.empty())
        refuse("the file holds no triangle; export the surfaces, not curves or points");
    dropUnused(mesh);
    const BoundingBox box = boundingBox(mesh);
    const glm::dvec3 size = glm::dvec3(box.high) - glm::dvec3(box.low);
    if (!fitUnitSphere(mesh))
        refuse("the mesh has no extent; export it again");
    mesh.openFrom = isClosed(mesh) ? mesh.indices.size() : 0;
    const std::string extension = path.extension().string();
    const MeshFacts facts{.triangles = mesh.indices.size() / 3,
                          .dropped = imported.dropped,
                          .extent = std::max({size.x, size.y, size.z}),
                          .isMetric = extension == ".gltf" || extension == ".glb"};
    return {std::move(mesh), facts};
}

Mesh readMesh(const std::filesystem::path& path, const JobControl& job, const MeshLimits& limits)
{
    return readMeshFile(path, job, limits).mesh;
}

} // namespace mirrorball::preview
