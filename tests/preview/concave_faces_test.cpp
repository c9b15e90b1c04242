#include "core/preview/mesh_file.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>

using namespace mirrorball;
using namespace mirrorball::preview;
using namespace mirrorball::test;

namespace {

/// A polygon of which every corner lies on a lattice, and the squares of the lattice that it consists of.
struct Shape {
    const char* name;
    std::vector<glm::ivec2> corners;
    std::vector<glm::ivec2> squares; ///< by their lower left corners
};

std::vector<Shape> shapes()
{
    Shape comb{"comb", {{0, 0}}, {}}; // a row of seven squares, and a tooth on every other
    for (int x = 0; x < 7; ++x) {
        comb.corners.emplace_back(x + 1, 0); // corners in the middle of an edge, too
        comb.squares.emplace_back(x, 0);
        if (x % 2 == 0)
            comb.squares.emplace_back(x, 1);
    }
    for (int x = 7; x > 0; --x) {
        comb.corners.emplace_back(x, x % 2 == 0 ? 1 : 2);
        comb.corners.emplace_back(x - 1, x % 2 == 0 ? 1 : 2);
    }
    return {{"L", {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}, {{0, 0}, {1, 0}, {0, 1}}},
            {"dented",
             {{0, 0}, {3, 0}, {3, 3}, {2, 3}, {2, 2}, {1, 2}, {1, 3}, {0, 3}},
             {{0, 0}, {1, 0}, {2, 0}, {0, 1}, {1, 1}, {2, 1}, {0, 2}, {2, 2}}},
            comb};
}

/// In one of three planes.
glm::ivec3 standing(const glm::ivec2& place, int axis)
{
    glm::ivec3 corner(5);
    corner[axis] = place.x;
    corner[(axis + 1) % 3] = place.y;
    return corner;
}

std::string meshText(const std::string& extension, const std::vector<glm::ivec3>& corners)
{
    std::ostringstream text;
    const std::string count = std::to_string(corners.size());
    if (extension == ".off")
        text << "OFF\n" << count << " 1 0\n";
    if (extension == ".ply")
        text << "ply\nformat ascii 1.0\nelement vertex " << count
             << "\nproperty float x\nproperty float y\nproperty float z\nelement face 1\nproperty list uchar int "
                "vertex_indices\nend_header\n";
    for (const glm::ivec3& c : corners)
        text << (extension == ".obj" ? "v " : "") << c.x << ' ' << c.y << ' ' << c.z << '\n';
    text << (extension == ".obj" ? "f" : count);
    for (size_t i = 0; i < corners.size(); ++i)
        text << ' ' << i + (extension == ".obj" ? 1 : 0);
    text << '\n';
    return text.str();
}

/// A mesh's triangles in the plane of the lattice: readMesh() has moved and scaled it into the unit sphere.
std::vector<std::array<glm::dvec2, 3>> trianglesOf(const Mesh& mesh, const Shape& shape, int axis)
{
    glm::dvec2 low(shape.corners.front()), high = low;
    for (const glm::ivec2& c : shape.corners)
        low = glm::min(low, glm::dvec2(c)), high = glm::max(high, glm::dvec2(c));
    const glm::dvec2 center = 0.5 * (low + high);
    double radius = 0.0;
    for (const glm::ivec2& c : shape.corners)
        radius = std::max(radius, glm::distance(center, glm::dvec2(c)));
    std::vector<std::array<glm::dvec2, 3>> triangles(mesh.indices.size() / 3);
    for (size_t i = 0; i < mesh.indices.size(); ++i) {
        const glm::vec3 p = mesh.positions[mesh.indices[i]];
        triangles[i / 3][i % 3] = center + radius * glm::dvec2(p[axis], p[(axis + 1) % 3]);
    }
    return triangles;
}

} // namespace

// assimp cuts an ear off an L though its inner corner lies on the cut.
TEST(ConcaveFaces, AreCoveredAndNothingElseIs)
{
    const TemporaryFolder folder;
    for (const Shape& shape : shapes())
        for (const std::string extension : {".off", ".obj", ".ply"})
            for (int axis = 0; axis < 3; ++axis)
                for (size_t first = 0; first < 2 * shape.corners.size(); ++first) {
                    std::vector<glm::ivec3> corners;
                    for (const glm::ivec2& c : shape.corners)
                        corners.push_back(standing(c, axis));
                    std::rotate(corners.begin(), corners.begin() + static_cast<long>(first / 2), corners.end());
                    if (first % 2 == 1)
                        std::reverse(corners.begin(), corners.end());
                    writeBytes(folder / ("face" + extension), meshText(extension, corners));
                    const Mesh mesh = readMesh(folder / ("face" + extension));
                    double area = 0.0;
                    for (const auto& [a, b, c] : trianglesOf(mesh, shape, axis)) {
                        area += 0.5 * std::abs((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
                        for (const glm::dvec3& weight : {glm::dvec3(0.8, 0.1, 0.1), glm::dvec3(0.1, 0.8, 0.1), glm::dvec3(0.1, 0.1, 0.8),
                                                         glm::dvec3(0.4, 0.4, 0.2), glm::dvec3(0.2, 0.4, 0.4), glm::dvec3(0.4, 0.2, 0.4)}) {
                            const glm::dvec2 p = weight.x * a + weight.y * b + weight.z * c;
                            EXPECT_TRUE(std::any_of(shape.squares.begin(), shape.squares.end(),
                                                    [&](const glm::ivec2& s) { // to the rounding of floats
                                                        const glm::dvec2 inside = glm::abs(p - glm::dvec2(s) - 0.5);
                                                        return std::max(inside.x, inside.y) < 0.5 + 1e-5;
                                                    }))
                                << shape.name << extension << ' ' << p.x << ' ' << p.y;
                        }
                    }
                    EXPECT_NEAR(area, static_cast<double>(shape.squares.size()), 1e-4) << shape.name << extension << ", plane " << axis;
                    if (HasFailure())
                        return;
                }
}

// Faces of any number of corners: an importer that takes nine gets them in pieces.
TEST(ConcaveFaces, OfAnOffFileBesideOthersKeepTheirCorners)
{
    const TemporaryFolder folder;
    std::ostringstream text; // two polygons of 30 corners between triangles, each about a center of its own
    constexpr int corners = 30;
    text << "OFF\n" << 2 * corners << " 5 0\n";
    for (int k = 0; k < 2; ++k)
        for (int i = 0; i < corners; ++i) {
            const double radius = i % 2 == 0 ? 1.0 : 0.5, angle = 2.0 * 3.14159265358979 * i / corners;
            text << 4 * k + radius * std::cos(angle) << ' ' << radius * std::sin(angle) << " 0\n";
        }
    const auto polygon = [&](int k) {
        text << corners;
        for (int i = 0; i < corners; ++i)
            text << ' ' << k * corners + i;
        text << '\n';
    };
    text << "3 0 1 2\n";
    polygon(0);
    text << "3 0 1 99\n3 0 1 2\n";
    polygon(1);
    writeBytes(folder / "stars.off", text.str());
    const MeshFile file = readMeshFile(folder / "stars.off");
    EXPECT_EQ(file.facts.triangles, 2u * (corners - 2) + 2);
    EXPECT_EQ(file.facts.dropped, 1u);
}
