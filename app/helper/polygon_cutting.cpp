#include "polygon_cutting.h"

#include "core/base/error.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace mirrorball::helper {
namespace {

/// Twice the area of a polygon, along its normal. Source: Newell, in Sutherland, Sproull and Schumacker (1974).
glm::dvec3 areaOf(std::span<const glm::dvec3> polygon)
{
    glm::dvec3 area(0.0);
    for (size_t i = 1; i + 1 < polygon.size(); ++i) // from the first corner: places far from the origin lose no digits
        area += glm::cross(polygon[i] - polygon[0], polygon[i + 1] - polygon[0]);
    return area;
}

/// The polygon seen along the axis that it faces most, counterclockwise.
std::vector<glm::dvec2> flattened(std::span<const glm::dvec3> polygon)
{
    const glm::dvec3 area = areaOf(polygon), size = glm::abs(area);
    const int axis = size.x > size.y && size.x > size.z ? 0 : size.y > size.z ? 1 : 2;
    int u = (axis + 1) % 3, v = (axis + 2) % 3;
    if (area[axis] < 0.0)
        std::swap(u, v);
    std::vector<glm::dvec2> places;
    places.reserve(polygon.size());
    for (const glm::dvec3& corner : polygon)
        places.emplace_back(corner[u], corner[v]);
    return places;
}

/// Twice the area of a triangle; positive where it turns counterclockwise.
double turn(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) { return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x); }

/// A polygon from which ears are cut. Only corners that are not convex need to be looked for in an ear: where any corner lies in it, one of
/// those does.
class Ears {
public:
    explicit Ears(std::vector<glm::dvec2> places) : m_places(std::move(places)), m_before(m_places.size()), m_after(m_places.size())
    {
        const auto count = static_cast<std::uint32_t>(m_places.size());
        for (std::uint32_t i = 0; i < count; ++i) {
            m_before[i] = (i + count - 1) % count;
            m_after[i] = (i + 1) % count;
        }
        for (std::uint32_t i = 0; i < count; ++i)
            if (turnAt(i) <= 0.0)
                m_notConvex.push_back(i);
    }

    std::vector<std::array<std::uint32_t, 3>> triangles()
    {
        std::vector<std::array<std::uint32_t, 3>> cut;
        std::uint32_t corner = 1;
        for (size_t rest = m_places.size(); rest >= 3; --rest) {
            corner = nextEar(corner, rest);
            cut.push_back({m_before[corner], corner, m_after[corner]});
            corner = remove(corner);
        }
        return cut;
    }

private:
    double turnAt(std::uint32_t i) const { return turn(m_places[m_before[i]], m_places[i], m_places[m_after[i]]); }

    bool isEar(std::uint32_t i) const
    {
        const glm::dvec2 &a = m_places[m_before[i]], &b = m_places[i], &c = m_places[m_after[i]];
        return turn(a, b, c) > 0.0 && std::none_of(m_notConvex.begin(), m_notConvex.end(), [&](std::uint32_t other) {
                   const glm::dvec2& p = m_places[other]; // at the place of a corner where the polygon touches itself
                   return p != a && p != b && p != c && turn(a, b, p) >= 0.0 && turn(b, c, p) >= 0.0 && turn(c, a, p) >= 0.0;
               });
    }

    /// An ear; where there is none, a corner that covers nothing; in a polygon that crosses itself, any that is convex.
    std::uint32_t nextEar(std::uint32_t first, size_t rest) const
    {
        std::uint32_t flat = first, convex = first;
        bool hasFlat = false, hasConvex = false;
        for (std::uint32_t i = first; rest > 0; --rest, i = m_after[i]) {
            if (isEar(i))
                return i;
            const double turned = turnAt(i);
            if (turned == 0.0 && !hasFlat)
                flat = i, hasFlat = true;
            if (turned > 0.0 && !hasConvex)
                convex = i, hasConvex = true;
        }
        return hasFlat ? flat : convex;
    }

    /// @return the corner after it
    std::uint32_t remove(std::uint32_t i)
    {
        const std::uint32_t before = m_before[i], after = m_after[i];
        m_after[before] = after;
        m_before[after] = before;
        std::erase_if(m_notConvex,
                      [&](std::uint32_t other) { return other == i || ((other == before || other == after) && turnAt(other) > 0.0); });
        return after;
    }

    std::vector<glm::dvec2> m_places;
    std::vector<std::uint32_t> m_before, m_after;
    std::vector<std::uint32_t> m_notConvex{};
};

constexpr unsigned mostKept = 4; ///< corners of a face that assimp cuts right, by the angles in space

glm::dvec3 place(const aiVector3D& v) { return {v.x, v.y, v.z}; }

void setCorners(aiFace& face, std::span<const unsigned> corners)
{
    delete[] face.mIndices;
    face.mIndices = new unsigned[corners.size()];
    std::copy(corners.begin(), corners.end(), face.mIndices);
    face.mNumIndices = static_cast<unsigned>(corners.size());
}

void take(aiFace& face, aiFace& from)
{
    std::swap(face.mNumIndices, from.mNumIndices);
    std::swap(face.mIndices, from.mIndices);
}

void setFaces(aiMesh& mesh, std::unique_ptr<aiFace[]> faces, size_t count)
{
    delete[] mesh.mFaces;
    mesh.mFaces = faces.release();
    mesh.mNumFaces = static_cast<unsigned>(count);
}

void cutPolygons(aiMesh& mesh)
{
    size_t count = 0;
    for (unsigned i = 0; i < mesh.mNumFaces; ++i)
        count += mesh.mFaces[i].mNumIndices <= mostKept ? 1 : mesh.mFaces[i].mNumIndices - 2;
    if (count == mesh.mNumFaces)
        return;
    auto faces = std::make_unique<aiFace[]>(count);
    aiFace* next = faces.get();
    std::vector<glm::dvec3> polygon;
    for (unsigned i = 0; i < mesh.mNumFaces; ++i) {
        aiFace& face = mesh.mFaces[i];
        if (face.mNumIndices <= mostKept) {
            take(*next++, face);
            continue;
        }
        polygon.clear();
        for (unsigned k = 0; k < face.mNumIndices; ++k)
            polygon.push_back(place(mesh.mVertices[face.mIndices[k]]));
        for (const auto& [a, b, c] : trianglesOf(polygon))
            setCorners(*next++, std::array{face.mIndices[a], face.mIndices[b], face.mIndices[c]});
    }
    setFaces(mesh, std::move(faces), count);
    mesh.mPrimitiveTypes = 0;
    for (unsigned i = 0; i < mesh.mNumFaces; ++i)
        mesh.mPrimitiveTypes |= AI_PRIMITIVE_TYPE_FOR_N_INDICES(mesh.mFaces[i].mNumIndices);
}

} // namespace

void joinFaces(aiScene& scene, std::span<const SplitFace> split)
{
    if (split.empty())
        return;
    const std::uint64_t given = scene.mNumMeshes == 1 ? scene.mMeshes[0]->mNumFaces : 0;
    if (split.back().first + split.back().pieces > given)
        throw InvalidArgument("the mesh cannot be read (some of its faces are missing); export it again");
    aiMesh& mesh = *scene.mMeshes[0];
    unsigned kept = 0;
    std::vector<unsigned> corners;
    for (std::uint64_t i = 0; i < given; ++kept) {
        const bool isSplit = !split.empty() && split.front().first == i;
        const std::uint64_t end = i + (isSplit ? split.front().pieces : 1);
        if (isSplit) {
            split = split.subspan(1);
            corners.clear();
            for (std::uint64_t piece = i; piece < end; ++piece)
                corners.insert(corners.end(), mesh.mFaces[piece].mIndices, mesh.mFaces[piece].mIndices + mesh.mFaces[piece].mNumIndices);
            setCorners(mesh.mFaces[i], corners);
        }
        if (kept != i)
            take(mesh.mFaces[kept], mesh.mFaces[i]);
        i = end;
    }
    mesh.mNumFaces = kept; // those beyond are freed with the list
}

std::vector<std::array<std::uint32_t, 3>> trianglesOf(std::span<const glm::dvec3> polygon) { return Ears(flattened(polygon)).triangles(); }

void cutPolygons(aiScene& scene)
{
    for (unsigned i = 0; i < scene.mNumMeshes; ++i)
        cutPolygons(*scene.mMeshes[i]);
}

} // namespace mirrorball::helper
