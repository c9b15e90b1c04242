#include "mesh_import.h"

#include "mesh_cleaning.h"
#include "mesh_files.h"
#include "polygon_cutting.h"

#include "core/base/error.h"

#include <assimp/Importer.hpp>
#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <algorithm>
#include <cmath>

namespace mirrorball::helper {

using preview::ImportedMesh;
using preview::Mesh;
using preview::MeshLimits;

namespace {

glm::vec3 vec3(const aiVector3D& v) { return {v.x, v.y, v.z}; }

/// @return the faces left out because a place of theirs is no finite number: clean() has looked at those of the file, but a node's matrix
///         of large numbers makes infinities of them, and of infinities what is no number at all.
std::uint64_t append(Mesh& mesh, const aiMesh& part)
{
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (unsigned i = 0; i < part.mNumVertices; ++i) {
        const glm::vec3 normal = part.HasNormals() ? vec3(part.mNormals[i]) : glm::vec3(0.0f);
        const float length = glm::length(normal);
        const glm::vec2 texCoord = part.HasTextureCoords(0) ? glm::vec2(vec3(part.mTextureCoords[0][i])) : glm::vec2(0.0f);
        mesh.positions.push_back(vec3(part.mVertices[i]));
        mesh.normals.push_back(std::isfinite(length) && length > 0.0f ? normal / length : glm::vec3(0.0f));
        mesh.texCoords.push_back(std::isfinite(texCoord.x) && std::isfinite(texCoord.y) ? texCoord : glm::vec2(0.0f));
    }
    std::uint64_t dropped = 0;
    for (unsigned i = 0; i < part.mNumFaces; ++i) {
        const aiFace& face = part.mFaces[i];
        if (face.mNumIndices != 3 || std::any_of(face.mIndices, face.mIndices + 3, [&](unsigned v) { return v >= part.mNumVertices; }))
            continue;
        std::uint32_t corners[3] = {face.mIndices[0] + first, face.mIndices[1] + first, face.mIndices[2] + first};
        if (!std::all_of(corners, corners + 3, [&](std::uint32_t v) { return preview::isFinite(mesh.positions[v]); })) {
            ++dropped;
            continue;
        }
        // In double: the area of a face of a ring in metres is 1e-8, of one in light years anything.
        const glm::dvec3 a(mesh.positions[corners[0]]), b(mesh.positions[corners[1]]), c(mesh.positions[corners[2]]);
        const glm::dvec3 area = glm::cross(b - a, c - a);
        if (area == glm::dvec3(0.0)) // covers nothing
            continue;
        // Counterclockwise seen from the side of the normals; a normal that was no direction becomes the face's.
        const glm::vec3 across(glm::normalize(area));
        if (glm::dot(across, mesh.normals[corners[0]] + mesh.normals[corners[1]] + mesh.normals[corners[2]]) < 0.0f)
            std::swap(corners[1], corners[2]);
        for (const std::uint32_t corner : corners)
            if (mesh.normals[corner] == glm::vec3(0.0f))
                mesh.normals[corner] = across;
        mesh.indices.insert(mesh.indices.end(), corners, corners + 3);
    }
    return dropped;
}

std::string reasonOf(const Assimp::Importer& importer)
{
    std::string reason = importer.GetErrorString();
    std::replace_if(
        reason.begin(), reason.end(), [](unsigned char c) { return c < 32 || c == 127; }, ' ');
    return reason.empty() ? "it holds no mesh" : reason.substr(0, 160);
}

} // namespace

ImportedMesh importMesh(const std::filesystem::path& path, const MeshLimits& limits)
{
    Assimp::Importer importer;
    auto* files = new MeshFiles(std::filesystem::canonical(path), limits.fileBytes); // owned by the importer
    importer.SetIOHandler(files);
    importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE, aiPrimitiveType_POINT | aiPrimitiveType_LINE);
    importer.SetPropertyFloat(AI_CONFIG_PP_GSN_MAX_SMOOTHING_ANGLE, 80.0f);
    importer.SetPropertyInteger(AI_CONFIG_PP_RVC_FLAGS, aiComponent_ANIMATIONS | aiComponent_TEXTURES | aiComponent_LIGHTS |
                                                            aiComponent_CAMERAS | aiComponent_MATERIALS);
    const auto refuse = [&] {
        throw InvalidArgument("the mesh cannot be read (" + reasonOf(importer) + "); export it again, for example as .obj or .glb");
    };
    if (!importer.ReadFile(std::filesystem::canonical(path).string(), 0))
        refuse();
    ImportedMesh imported;
    for (const std::string& file : files->opened())
        imported.files += file + '\0';
    auto& read = const_cast<aiScene&>(*importer.GetScene()); // the importer's, which gives it out to be looked at
    joinFaces(read, files->split());
    imported.dropped = files->dropped() + clean(read);
    cutPolygons(read);
    // Neither aiProcess_FindDegenerates, which takes faces of less than 1e-6 square units for nothing, nor aiProcess_FindInvalidData, which
    // refuses a mesh for one vertex: both are done here, face by face.
    const aiScene* scene = importer.ApplyPostProcessing(
        aiProcess_ValidateDataStructure | aiProcess_RemoveComponent | aiProcess_Triangulate | aiProcess_SortByPType |
        aiProcess_PreTransformVertices | aiProcess_GenSmoothNormals | aiProcess_JoinIdenticalVertices | aiProcess_ImproveCacheLocality);
    if (!scene)
        refuse();

    std::size_t triangles = 0;
    for (unsigned i = 0; i < scene->mNumMeshes; ++i)
        triangles += scene->mMeshes[i]->mNumFaces;
    if (triangles > limits.triangles)
        throw InvalidArgument("the mesh has " + std::to_string(triangles) + " triangles and at most " + std::to_string(limits.triangles) +
                              " can be shown; reduce it in a modeller");
    for (unsigned i = 0; i < scene->mNumMeshes; ++i)
        imported.dropped += append(imported.mesh, *scene->mMeshes[i]);
    if (std::none_of(scene->mMeshes, scene->mMeshes + scene->mNumMeshes, [](const aiMesh* part) { return part->HasTextureCoords(0); }))
        imported.mesh.texCoords.clear();
    if (imported.mesh.indices.empty())
        throw InvalidArgument("the file holds no triangle; export the surfaces, not curves or points");
    return imported;
}

void serveMesh(const Received& request, Connection& connection)
{
    std::string path;
    MeshLimits limits;
    std::uint64_t fileBytes = 0, triangles = 0;
    WireReader(request.bytes) >> path >> fileBytes >> triangles;
    limits.fileBytes = fileBytes;
    limits.triangles = triangles;
    connection.send(Answer::Result, preview::toWire(importMesh(path, limits)));
}

} // namespace mirrorball::helper
