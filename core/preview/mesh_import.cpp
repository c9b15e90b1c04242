#include "mesh_import.h"

#include "core/base/error.h"

#include <assimp/DefaultIOSystem.h>
#include <assimp/Importer.hpp>
#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace mirrorball::preview {

namespace {

// Opens regular files in one folder or below it: a mesh file can name any path of the machine as its material or its buffer.
class FolderFiles final : public Assimp::DefaultIOSystem {
public:
    FolderFiles(std::filesystem::path folder, std::uintmax_t largest) : m_folder(std::move(folder)), m_largest(largest) {}

    bool Exists(const char* file) const override { return allows(file); }
    Assimp::IOStream* Open(const char* file, const char* mode) override
    {
        return mode[0] == 'r' && allows(file) ? DefaultIOSystem::Open(file, mode) : nullptr;
    }

private:
    bool allows(const char* file) const
    {
        std::error_code error;
        const std::filesystem::path path = std::filesystem::weakly_canonical(file, error);
        if (error || !std::filesystem::is_regular_file(path, error) || std::filesystem::file_size(path, error) > m_largest)
            return false;
        const auto below = std::mismatch(m_folder.begin(), m_folder.end(), path.begin(), path.end());
        return below.first == m_folder.end();
    }

    std::filesystem::path m_folder;
    std::uintmax_t m_largest;
};

glm::vec3 vec3(const aiVector3D& v) { return {v.x, v.y, v.z}; }

bool isFinite(const glm::vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

void append(Mesh& mesh, const aiMesh& part)
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
    for (unsigned i = 0; i < part.mNumFaces; ++i) {
        const aiFace& face = part.mFaces[i];
        if (face.mNumIndices != 3 || std::any_of(face.mIndices, face.mIndices + 3, [&](unsigned v) { return v >= part.mNumVertices; }))
            continue;
        std::uint32_t corners[3] = {face.mIndices[0] + first, face.mIndices[1] + first, face.mIndices[2] + first};
        const glm::vec3 a = mesh.positions[corners[0]], b = mesh.positions[corners[1]], c = mesh.positions[corners[2]];
        if (!isFinite(a) || !isFinite(b) || !isFinite(c))
            continue;
        // Counterclockwise seen from the side of the normals; a normal that was no direction becomes the face's.
        const glm::vec3 across = glm::cross(b - a, c - a);
        if (glm::dot(across, mesh.normals[corners[0]] + mesh.normals[corners[1]] + mesh.normals[corners[2]]) < 0.0f)
            std::swap(corners[1], corners[2]);
        const float area = glm::length(across);
        for (const std::uint32_t corner : corners)
            if (mesh.normals[corner] == glm::vec3(0.0f))
                mesh.normals[corner] = area > 0.0f ? across / area : glm::vec3(0.0f, 1.0f, 0.0f);
        mesh.indices.insert(mesh.indices.end(), corners, corners + 3);
    }
}

std::string reasonOf(const Assimp::Importer& importer)
{
    std::string reason = importer.GetErrorString();
    std::replace_if(
        reason.begin(), reason.end(), [](unsigned char c) { return c < 32 || c == 127; }, ' ');
    return reason.empty() ? "it holds no mesh" : reason.substr(0, 160);
}

} // namespace

Mesh importMesh(const std::filesystem::path& path, const MeshLimits& limits)
{
    Assimp::Importer importer;
    importer.SetIOHandler(new FolderFiles(std::filesystem::canonical(path).parent_path(), limits.fileBytes)); // owned by the importer
    importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE, aiPrimitiveType_POINT | aiPrimitiveType_LINE);
    importer.SetPropertyBool(AI_CONFIG_PP_FD_REMOVE, true);
    importer.SetPropertyFloat(AI_CONFIG_PP_GSN_MAX_SMOOTHING_ANGLE, 80.0f);
    importer.SetPropertyInteger(AI_CONFIG_PP_RVC_FLAGS, aiComponent_COLORS | aiComponent_TANGENTS_AND_BITANGENTS | aiComponent_BONEWEIGHTS |
                                                            aiComponent_ANIMATIONS | aiComponent_TEXTURES | aiComponent_LIGHTS |
                                                            aiComponent_CAMERAS | aiComponent_MATERIALS);
    const aiScene* scene =
        importer.ReadFile(std::filesystem::canonical(path).string(),
                          aiProcess_ValidateDataStructure | aiProcess_RemoveComponent | aiProcess_FindInvalidData | aiProcess_Triangulate |
                              aiProcess_FindDegenerates | aiProcess_SortByPType | aiProcess_PreTransformVertices |
                              aiProcess_GenSmoothNormals | aiProcess_JoinIdenticalVertices | aiProcess_ImproveCacheLocality);
    if (!scene)
        throw InvalidArgument("the mesh cannot be read (" + reasonOf(importer) + "); export it again, for example as .obj or .glb");

    std::size_t triangles = 0;
    for (unsigned i = 0; i < scene->mNumMeshes; ++i)
        triangles += scene->mMeshes[i]->mNumFaces;
    if (triangles > limits.triangles)
        throw InvalidArgument("the mesh has " + std::to_string(triangles) + " triangles and at most " + std::to_string(limits.triangles) +
                              " can be shown; reduce it in a modeller");
    Mesh mesh;
    for (unsigned i = 0; i < scene->mNumMeshes; ++i)
        append(mesh, *scene->mMeshes[i]);
    if (mesh.indices.empty())
        throw InvalidArgument("the file holds no triangle; export the surfaces, not curves or points");
    return mesh;
}

} // namespace mirrorball::preview
