/// Meshes that users of other programs reported, in ../shared/reports beside the checkout. The same kinds are made by mesh_damage_test;
/// these are of other hands.

#include "core/base/error.h"
#include "core/preview/mesh_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

namespace mirrorball::preview {
namespace {

struct MeshReports : testing::Test {
    const std::filesystem::path folder = std::filesystem::path(MIRRORBALL_SHARED_DATA) / "../reports";

    void SetUp() override
    {
        if (!std::filesystem::exists(folder))
            GTEST_SKIP() << folder << " is not there";
    }
    MeshFile read(const std::string& name) const { return readMeshFile(folder / name); }

    /// The triangles' corners - place and normal - in an order that does not depend on the file's.
    static std::vector<std::array<float, 18>> triangles(const Mesh& mesh)
    {
        std::vector<std::array<float, 18>> list;
        for (size_t i = 0; i < mesh.indices.size(); i += 3) {
            std::array<std::array<float, 6>, 3> corners{};
            for (size_t k = 0; k < 3; ++k) {
                const glm::vec3 p = mesh.positions[mesh.indices[i + k]], n = mesh.normals[mesh.indices[i + k]];
                for (int c = 0; c < 3; ++c) { // rounded, so that orders agree
                    corners[k][static_cast<size_t>(c)] = std::round(p[c] * 1e4f) / 1e4f + 0.0f;
                    corners[k][static_cast<size_t>(3 + c)] = std::round(n[c] * 1e4f) / 1e4f + 0.0f;
                }
            }
            std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
            std::array<float, 18> triangle{};
            for (size_t k = 0; k < 3; ++k)
                std::copy(corners[k].begin(), corners[k].end(), triangle.begin() + static_cast<std::ptrdiff_t>(6 * k));
            list.push_back(triangle);
        }
        std::sort(list.begin(), list.end());
        return list;
    }
};

TEST_F(MeshReports, ABallOfFourCentimetresInMetresIsWhole)
{
    const MeshFile ball = read("m-ball-4cm-in-metres.obj"); // 80 x 40 quads, of which the two rings at the poles are triangles
    EXPECT_NEAR(ball.facts.extent, 0.04, 1e-6);
    EXPECT_EQ(ball.facts.dropped, 0u);
    EXPECT_EQ(ball.facts.triangles, 6316u) << "6240, and slivers at the pole whose sine is not quite 0";
    for (size_t i = 0; i < ball.mesh.positions.size(); ++i)
        ASSERT_LT(glm::distance(ball.mesh.positions[i], ball.mesh.normals[i]), 0.05f) << "a ball's normals are its places";
}

TEST_F(MeshReports, MeshesWithoutNormalsAreTheSameInEveryFormat)
{
    EXPECT_EQ(triangles(read("m-cube-no-normals.ply").mesh), triangles(read("m-cube.obj").mesh));
    EXPECT_EQ(triangles(read("m-plain.gltf").mesh), triangles(read("m-plain.obj").mesh));
}

TEST_F(MeshReports, ABufferWhoseNameIsPercentEncodedIsFound)
{
    const std::string name = "m-buffer with space \u00fc.gltf";
    EXPECT_EQ(triangles(read(name).mesh), triangles(read("m-plain.obj").mesh));
}

TEST_F(MeshReports, BadElementsAreLeftOutAndCounted)
{
    const auto whole = triangles(read("m-plain.obj").mesh);
    const MeshFile zero = read("m-zero-normal-index.obj"), nan = read("m-nan-vertex.obj");
    EXPECT_EQ(triangles(zero.mesh), whole);
    EXPECT_EQ(zero.facts.dropped, 0u) << "only their normals are not there";
    EXPECT_EQ(triangles(nan.mesh), whole);
    EXPECT_EQ(nan.facts.dropped, 2u);
}

TEST_F(MeshReports, AMeshThatNeverEndsIsRefused)
{
    try {
        read("spin_1.ply");
        ADD_FAILURE() << "it was read";
    } catch (const FileError& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr("spin_1.ply"));
    }
}

} // namespace
} // namespace mirrorball::preview
