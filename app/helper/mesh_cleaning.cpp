#include "mesh_cleaning.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

namespace mirrorball::helper {
namespace {

bool isFinite(const aiVector3D& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

template <class Element>
void remove(Element*& list)
{
    delete[] list;
    list = nullptr;
}

/// Everything but positions, normals and the first texture coordinates.
void removeTheRest(aiMesh& mesh)
{
    remove(mesh.mTangents);
    remove(mesh.mBitangents);
    for (aiColor4D*& colors : mesh.mColors)
        remove(colors);
    for (unsigned i = 1; i < AI_MAX_NUMBER_OF_TEXTURECOORDS; ++i)
        remove(mesh.mTextureCoords[i]);
    for (unsigned i = 0; i < mesh.mNumBones; ++i)
        delete mesh.mBones[i];
    remove(mesh.mBones);
    mesh.mNumBones = 0;
    for (unsigned i = 0; i < mesh.mNumAnimMeshes; ++i)
        delete mesh.mAnimMeshes[i];
    remove(mesh.mAnimMeshes);
    mesh.mNumAnimMeshes = 0;
}

std::uint64_t dropBadFaces(aiMesh& mesh)
{
    const auto isGood = [&](const aiFace& face) {
        return face.mNumIndices > 0 && face.mIndices && std::all_of(face.mIndices, face.mIndices + face.mNumIndices, [&](unsigned i) {
                   return i < mesh.mNumVertices && isFinite(mesh.mVertices[i]);
               });
    };
    unsigned kept = 0;
    for (unsigned i = 0; i < mesh.mNumFaces; ++i)
        if (isGood(mesh.mFaces[i])) {
            std::swap(mesh.mFaces[kept].mNumIndices, mesh.mFaces[i].mNumIndices);
            std::swap(mesh.mFaces[kept].mIndices, mesh.mFaces[i].mIndices);
            ++kept;
        }
    const std::uint64_t dropped = mesh.mNumFaces - kept; // those beyond `kept` are freed with the list
    mesh.mNumFaces = kept;
    return dropped;
}

/// No face uses them any more, but steps that sort places would.
void hideBadNumbers(aiMesh& mesh)
{
    for (aiVector3D* list : {mesh.mVertices, mesh.mNormals, mesh.mTextureCoords[0]})
        for (unsigned i = 0; list && i < mesh.mNumVertices; ++i)
            if (!isFinite(list[i]))
                list[i] = aiVector3D(0.0f, 0.0f, 0.0f);
}

void giveCornersTheirOwnVertices(aiMesh& mesh)
{
    std::vector<unsigned> corners;
    for (unsigned i = 0; i < mesh.mNumFaces; ++i)
        corners.insert(corners.end(), mesh.mFaces[i].mIndices, mesh.mFaces[i].mIndices + mesh.mFaces[i].mNumIndices);
    for (aiVector3D** list : {&mesh.mVertices, &mesh.mTextureCoords[0]})
        if (*list) {
            auto spread = std::make_unique<aiVector3D[]>(corners.size());
            for (size_t i = 0; i < corners.size(); ++i)
                spread[i] = (*list)[corners[i]];
            delete[] * list;
            *list = spread.release();
        }
    unsigned next = 0;
    for (unsigned i = 0; i < mesh.mNumFaces; ++i)
        for (unsigned k = 0; k < mesh.mFaces[i].mNumIndices; ++k)
            mesh.mFaces[i].mIndices[k] = next++;
    mesh.mNumVertices = next;
}

} // namespace

std::uint64_t clean(aiScene& scene)
{
    std::uint64_t dropped = 0;
    for (unsigned i = 0; i < scene.mNumMeshes; ++i) {
        aiMesh& mesh = *scene.mMeshes[i];
        removeTheRest(mesh);
        dropped += dropBadFaces(mesh);
        hideBadNumbers(mesh);
        if (!mesh.mNormals)
            giveCornersTheirOwnVertices(mesh);
    }
    return dropped;
}

} // namespace mirrorball::helper
