#include "core/preview/mesh_file.h"

#include "core/base/error.h"
#include "core/preview/mesh_wire.h"
#include "tests/support/temporary_folder.h"

#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <numbers>
#include <sstream>

using namespace mirrorball;
using namespace mirrorball::preview;
using namespace mirrorball::test;

namespace {

/// A ball of quads between rings, with triangles at the poles: 2 * around * (rings - 1) triangles in all.
std::string ballObj(double radius, int around, int rings)
{
    std::ostringstream text;
    text.precision(9);
    text << "v 0 " << radius << " 0\nv 0 " << -radius << " 0\n";
    for (int r = 1; r < rings; ++r)
        for (int a = 0; a < around; ++a) {
            const double polar = std::numbers::pi * r / rings, azimuth = 2.0 * std::numbers::pi * a / around;
            text << "v " << radius * std::sin(polar) * std::cos(azimuth) << ' ' << radius * std::cos(polar) << ' '
                 << radius * std::sin(polar) * std::sin(azimuth) << '\n';
        }
    const auto at = [&](int r, int a) { return 3 + (r - 1) * around + a % around; };
    for (int a = 0; a < around; ++a) {
        text << "f 1 " << at(1, a + 1) << ' ' << at(1, a) << '\n';
        text << "f 2 " << at(rings - 1, a) << ' ' << at(rings - 1, a + 1) << '\n';
        for (int r = 1; r + 1 < rings; ++r)
            text << "f " << at(r, a) << ' ' << at(r, a + 1) << ' ' << at(r + 1, a + 1) << ' ' << at(r + 1, a) << '\n';
    }
    return text.str();
}

constexpr const char* corners = "0 0 0\n2 0 0\n2 2 0\n0 2 0\n0 0 2\n2 0 2\n2 2 2\n0 2 2\n";

} // namespace

// assimp takes faces of less than 1e-6 square units for degenerate: in metres that is most of a ring, and light years have none.
TEST(MeshDamage, NoTriangleIsTooSmallInWhateverUnit)
{
    const TemporaryFolder folder;
    for (const double radius : {1e-6, 0.02, 1.0, 1e6}) {
        writeBytes(folder / "ball.obj", ballObj(radius, 48, 24));
        const MeshFile file = readMeshFile(folder / "ball.obj");
        EXPECT_EQ(file.facts.triangles, 2u * 48 * 23) << radius;
        EXPECT_EQ(file.mesh.openFrom, file.mesh.indices.size()) << "the whole ball is closed; radius " << radius;
        EXPECT_NEAR(file.facts.extent, 2.0 * radius, 1e-3 * radius);
        for (size_t i = 0; i < file.mesh.positions.size(); ++i) // a ball's normals are its places
            EXPECT_LT(glm::distance(file.mesh.positions[i], file.mesh.normals[i]), 0.07f) << radius;
    }
}

// Formats that share vertices by index and have no normals: a corner of a cube has three.
TEST(MeshDamage, IndexedMeshesWithoutNormalsGetThoseOfTheirFaces)
{
    const TemporaryFolder folder;
    const std::string faces = "4 3 2 1 0\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n";
    writeBytes(folder / "cube.off", std::string("OFF\n8 6 0\n") + corners + faces);
    writeBytes(folder / "cube.ply",
               std::string("ply\nformat ascii 1.0\nelement vertex 8\nproperty float x\nproperty float y\nproperty float "
                           "z\nelement face 6\nproperty list uchar int vertex_indices\nend_header\n") +
                   corners + faces);
    for (const char* name : {"cube.off", "cube.ply"}) {
        const Mesh mesh = readMesh(folder / name);
        ASSERT_EQ(mesh.indices.size(), 36u) << name;
        for (size_t i = 0; i < mesh.indices.size(); i += 3) {
            const glm::vec3 a = mesh.positions[mesh.indices[i]], b = mesh.positions[mesh.indices[i + 1]],
                            c = mesh.positions[mesh.indices[i + 2]];
            const glm::vec3 across = glm::normalize(glm::cross(b - a, c - a));
            EXPECT_GT(glm::dot(across, a + b + c), 0.0f) << name;
            for (size_t k = 0; k < 3; ++k)
                EXPECT_LT(glm::distance(mesh.normals[mesh.indices[i + k]], across), 1e-5f) << name;
        }
    }
}

TEST(MeshDamage, OneBadElementIsLeftOutAndCounted)
{
    const TemporaryFolder folder;
    const std::string good = ballObj(1.0, 8, 4);
    const std::uint64_t whole = 2u * 8 * 3;
    struct Case {
        const char* added;
        std::uint64_t dropped;
    };
    for (const Case& bad : {Case{"f 1 2 99999\n", 1}, Case{"f 1 2 -99999\n", 1}, Case{"f 0 1 2\n", 1},
                            Case{"v nan 0 0\nf 1 2 -1\nf -1 2 3\n", 2}, Case{"v inf 0 0\n", 0}, Case{"f 1 2 2\n", 0}}) {
        writeBytes(folder / "bad.obj", good + bad.added);
        const MeshFacts facts = readMeshFile(folder / "bad.obj").facts;
        EXPECT_EQ(facts.triangles, whole) << bad.added;
        EXPECT_EQ(facts.dropped, bad.dropped) << bad.added;
        EXPECT_NEAR(facts.extent, 2.0, 1e-6) << bad.added;
    }
    writeBytes(folder / "careless.obj", good + "f 1//0 2//0 3//0\nf 1/7/1 2/8/1 4/9/1\n"); // no such normals: made, as for the others
    EXPECT_EQ(describe(readMeshFile(folder / "careless.obj").facts), "50 triangles, 2.0 m if its unit is the metre");
}

// assimp takes an index beyond the last vertex for the last one, and passes over faces of more than nine corners, both in silence.
TEST(MeshDamage, AnOffFileKeepsItsGoodFacesAndCountsTheBad)
{
    const TemporaryFolder folder;
    const std::string faces = "4 3 2 1 0\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n";
    for (const char* bad : {"4 0 1 2 8", "3 0 1 4000000000", "3 0 1 99999999999999999999", "3 0 1 -1", "3 0 1", "0", "x"}) {
        writeBytes(folder / "bad.off", std::string("OFF\n8 7 12\n") + corners + bad + "\n" + faces);
        const MeshFacts facts = readMeshFile(folder / "bad.off").facts;
        EXPECT_EQ(facts.triangles, 12u) << bad;
        EXPECT_EQ(facts.dropped, 1u) << bad;
    }
    writeBytes(folder / "words.off", std::string("# made by hand\nOFF # text\n8\n6 0 # edges unknown\n\n# corners\n") + corners +
                                         "# faces\n" + "4 3 2 1 0 255 0 0 # red\n" + faces.substr(faces.find('\n') + 1));
    EXPECT_EQ(describe(readMeshFile(folder / "words.off").facts), "12 triangles, 2.0 m if its unit is the metre");

    std::ostringstream disc; // a dodecagon
    disc << "OFF\n12 1 0\n";
    for (int i = 0; i < 12; ++i)
        disc << std::cos(i * std::numbers::pi / 6) << ' ' << std::sin(i * std::numbers::pi / 6) << " 0\n";
    disc << "12 0 1 2 3 4 5 6 7 8 9 10 11\n";
    writeBytes(folder / "disc.off", disc.str());
    EXPECT_EQ(readMeshFile(folder / "disc.off").facts.triangles, 10u);

    for (const char* cut : {"OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", "OFF\n4 1 0\n0 0 0\n1 0 0\n0 1 0\n"}) {
        writeBytes(folder / "cut.off", cut);
        EXPECT_THROW(readMeshFile(folder / "cut.off"), FileError) << cut;
    }
}

TEST(MeshDamage, AByteOrderMarkIsPassedOver)
{
    const TemporaryFolder folder;
    const std::string mark = "\xef\xbb\xbf";
    writeBytes(folder / "a.obj", mark + ballObj(1.0, 8, 4));
    writeBytes(folder / "a.off", mark + "OFF\n3 1 0\n0 0 0\n3 0 0\n0 4 0\n3 0 1 2\n");
    EXPECT_EQ(readMeshFile(folder / "a.obj").facts.triangles, 48u);
    EXPECT_EQ(readMeshFile(folder / "a.off").facts.triangles, 1u);
}

TEST(MeshDamage, FilesBesideAMeshAreFoundAsUrisWriteThem)
{
    const TemporaryFolder folder;
    std::string buffer(36, '\0');
    buffer[14] = buffer[30] = '\x80';
    buffer[15] = buffer[31] = '\x3f';
    writeBytes(folder / "two words \xc3\xbc.bin", buffer);
    writeBytes(folder / "a.gltf",
               R"({"asset":{"version":"2.0"},"buffers":[{"uri":"two%20words%20%C3%BC.bin","byteLength":36}],)"
               R"("bufferViews":[{"buffer":0,"byteLength":36}],)"
               R"("accessors":[{"bufferView":0,"count":3,"componentType":5126,"type":"VEC3","min":[0,0,0],"max":[1,1,0]}],)"
               R"("meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],"nodes":[{"mesh":0}],"scenes":[{"nodes":[0]}],"scene":0})");
    const MeshFacts facts = readMeshFile(folder / "a.gltf").facts;
    EXPECT_EQ(describe(facts), "1 triangle, 1.0 m");
}

// The file's own numbers are finite; infinity less infinity, which has no place in any order, comes of multiplying them.
TEST(MeshDamage, AFaceThatANodesMatrixThrowsOutOfAllNumbersIsLeftOut)
{
    const TemporaryFolder folder;
    const std::array<float, 9> places{0.0f, 0.0f, 0.0f, 1e10f, 1e10f, 0.0f, 0.0f, 1.0f, 0.0f};
    std::string buffer(sizeof places, '\0');
    std::memcpy(buffer.data(), places.data(), sizeof places);
    writeBytes(folder / "a.bin", buffer);
    const auto gltf = [](const std::string& nodes) {
        return R"({"asset":{"version":"2.0"},"buffers":[{"uri":"a.bin","byteLength":36}],"bufferViews":[{"buffer":0,"byteLength":36}],)"
               R"("accessors":[{"bufferView":0,"count":3,"componentType":5126,"type":"VEC3","min":[0,0,0],"max":[1e10,1e10,0]}],)"
               R"("meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],"nodes":)" +
               nodes + R"(,"scenes":[{"nodes":[0]}],"scene":0})";
    };
    writeBytes(folder / "one.gltf", gltf(R"([{"mesh":0,"matrix":[1e38,0,0,0,-1e38,1,0,0,0,0,1,0,0,0,0,1]}])"));
    writeBytes(folder / "two.gltf", gltf(R"([{"mesh":0,"children":[1]},{"mesh":0,"matrix":[1e38,0,0,0,-1e38,1,0,0,0,0,1,0,0,0,0,1]}])"));
    EXPECT_THROW(readMeshFile(folder / "one.gltf"), FileError);
    const MeshFile kept = readMeshFile(folder / "two.gltf");
    EXPECT_EQ(kept.facts.triangles, 1u);
    EXPECT_EQ(kept.facts.dropped, 1u);
    for (const glm::vec3& position : kept.mesh.positions)
        EXPECT_LE(glm::length(position), 1.0001f);
}

TEST(MeshDamage, WhatAnImporterSaysOfPlacesThatAreNoNumbersIsNotTaken)
{
    ImportedMesh mesh;
    mesh.mesh = boxMesh();
    mesh.mesh.texCoords.clear();
    ImportedMesh read;
    ASSERT_TRUE(fromWire(toWire(mesh), read));
    mesh.mesh.positions[mesh.mesh.indices.back()].y = std::numeric_limits<float>::quiet_NaN();
    EXPECT_FALSE(fromWire(toWire(mesh), read));
}

TEST(MeshDamage, CountsAndSizesAreToldInWords)
{
    EXPECT_EQ(describe({.triangles = 68644, .extent = 0.13, .isMetric = true}), "68 644 triangles, 13 cm");
    EXPECT_EQ(describe({.triangles = 1234567, .dropped = 1, .extent = 0.0042}),
              "1 234 567 triangles, 4.2 mm if its unit is the metre; 1 bad face left out");
    EXPECT_EQ(describe({.triangles = 2, .dropped = 3000, .extent = 2500.0, .isMetric = true}),
              "2 triangles, 2.5 km; 3 000 bad faces left out");
}
