#include "core/preview/mesh_file.h"

#include "core/base/error.h"
#include "tests/support/shared_data.h"
#include "tests/support/temporary_folder.h"

#include <gmock/gmock.h>

#include <random>

using namespace mirrorball;
using namespace mirrorball::preview;
using namespace mirrorball::test;

namespace {

// A cube from 10 to 12 each way, without normals, its faces counterclockwise from outside.
const char* cubeObj = "v 10 10 10\nv 12 10 10\nv 12 12 10\nv 10 12 10\nv 10 10 12\nv 12 10 12\nv 12 12 12\nv 10 12 12\n"
                      "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";

std::string messageOf(const std::filesystem::path& path, const MeshLimits& limits = {})
{
    try {
        readMesh(path, {}, limits);
    } catch (const FileError& error) {
        return error.what();
    }
    return "";
}

void expectOneLineAbout(const std::string& message, const std::filesystem::path& path)
{
    EXPECT_TRUE(message.starts_with(path.string() + ": ")) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    EXPECT_LT(message.size(), path.string().size() + 300);
}

} // namespace

TEST(MeshFile, ACubeFarAwayBecomesTheOneInTheUnitSphereWithFlatFaces)
{
    const TemporaryFolder folder;
    writeBytes(folder / "cube.obj", cubeObj);
    const Mesh mesh = readMesh(folder / "cube.obj");
    EXPECT_EQ(mesh.indices.size(), 36u);
    EXPECT_EQ(mesh.openFrom, mesh.indices.size()) << "closed: its inside is never seen";
    const float edge = 1.0f / std::sqrt(3.0f);
    for (const glm::vec3& p : mesh.positions)
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(std::abs(p[c]), edge, 1e-6f);
    for (size_t i = 0; i < mesh.indices.size(); i += 3) {
        const glm::vec3 a = mesh.positions[mesh.indices[i]], b = mesh.positions[mesh.indices[i + 1]],
                        c = mesh.positions[mesh.indices[i + 2]];
        const glm::vec3 across = glm::normalize(glm::cross(b - a, c - a));
        EXPECT_GT(glm::dot(across, a + b + c), 0.0f) << "counterclockwise from outside";
        for (size_t k = 0; k < 3; ++k) // edges of 90 degrees stay edges
            EXPECT_LT(glm::distance(mesh.normals[mesh.indices[i + k]], across), 1e-5f);
    }
}

TEST(MeshFile, NormalsOfTheFileStayAndSayWhichWayFacesWind)
{
    const TemporaryFolder folder;
    writeBytes(folder / "clockwise.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 -1\nf 1//1 2//1 3//1\n");
    const Mesh mesh = readMesh(folder / "clockwise.obj");
    const auto corner = [&](size_t i) { return mesh.positions[mesh.indices[i]]; };
    EXPECT_LT(glm::cross(corner(1) - corner(0), corner(2) - corner(0)).z, 0.0f);
    EXPECT_EQ(mesh.openFrom, 0u) << "one triangle can be seen from behind";
    for (const glm::vec3& n : mesh.normals)
        EXPECT_LT(glm::distance(n, glm::vec3(0, 0, -1)), 1e-6f);
}

TEST(MeshFile, EveryFormatOfTextGivesTheSameTriangle)
{
    const TemporaryFolder folder;
    writeBytes(folder / "a.obj", "v 0 0 0\nv 3 0 0\nv 0 4 0\nf 1 2 3\n");
    writeBytes(folder / "b.OFF", "OFF\n3 1 0\n0 0 0\n3 0 0\n0 4 0\n3 0 1 2\n");
    writeBytes(folder / "c.stl",
               "solid t\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 3 0 0\nvertex 0 4 0\nendloop\nendfacet\nendsolid t\n");
    writeBytes(folder / "d.ply", "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
                                 "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n3 0 0\n0 4 0\n3 0 1 2\n");
    for (const char* name : {"a.obj", "b.OFF", "c.stl", "d.ply"}) {
        const Mesh mesh = readMesh(folder / name);
        ASSERT_EQ(mesh.indices.size(), 3u) << name;
        for (size_t k = 0; k < 3; ++k)
            EXPECT_NEAR(glm::length(mesh.positions[mesh.indices[k]]), 1.0f, 1e-6f) << name; // the corners of a right triangle on its circle
    }
}

TEST(MeshFile, ReadsTheMeshesBesideTheProject)
{
    SHARED_DATA_OR_SKIP(teapot, "meshes/mcguire_teapot.obj");
    SHARED_DATA_OR_SKIP(spot, "meshes/spot_control_mesh.obj");
    for (const auto& [path, faces] : {std::pair{teapot, 8028u}, std::pair{spot, 180u}}) {
        const Mesh mesh = readMesh(path);
        EXPECT_GE(mesh.indices.size() / 3, faces); // quads became two
        EXPECT_NEAR(boundingSphere(mesh).radius, 1.0f, 1e-5f);
        for (const glm::vec3& n : mesh.normals)
            ASSERT_NEAR(glm::length(n), 1.0f, 1e-5f);
    }
    EXPECT_EQ(readMesh(spot).indices.size() / 3, 372u); // a face of n corners is n - 2 triangles
}

TEST(MeshFile, BadFilesGiveOneLineThatNamesThem)
{
    const TemporaryFolder folder;
    writeBytes(folder / "empty.obj", "");
    writeBytes(folder / "text.ply", "this is no mesh\n");
    writeBytes(folder / "points.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\np 1 2 3\n");
    writeBytes(folder / "nowhere.obj", "v nan nan nan\nv inf 0 0\nv 0 1 0\nf 1 2 3\n");
    writeBytes(folder / "point.stl",
               "solid t\nfacet normal 0 0 1\nouter loop\nvertex 1 1 1\nvertex 1 1 1\nvertex 1 1 1\nendloop\nendfacet\nendsolid t\n");
    writeBytes(folder / "indices.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4000000000\n");
    writeBytes(folder / "many.ply", "ply\nformat binary_little_endian 1.0\nelement vertex 4000000000\nproperty float x\nproperty float y\n"
                                    "property float z\nelement face 4000000000\nproperty list uchar int vertex_indices\nend_header\n");
    writeBytes(folder / "many.gltf",
               R"({"asset":{"version":"2.0"},"accessors":[{"count":4000000000,"componentType":5126,"type":"VEC3"}],)"
               R"("meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],"nodes":[{"mesh":0}],"scenes":[{"nodes":[0]}],"scene":0})");
    for (const char* name : {"empty.obj", "text.ply", "points.obj", "nowhere.obj", "point.stl", "indices.obj", "many.ply", "many.gltf"})
        expectOneLineAbout(messageOf(folder / name), folder / name);
    expectOneLineAbout(messageOf(folder / "missing.obj"), folder / "missing.obj");
    writeBytes(folder / "mesh.txt", cubeObj);
    EXPECT_THAT(messageOf(folder / "mesh.txt"), testing::HasSubstr(".obj"));
    std::filesystem::create_directory(folder / "folder.obj");
    expectOneLineAbout(messageOf(folder / "folder.obj"), folder / "folder.obj");
    writeBytes(folder / "cube.obj", cubeObj);
    EXPECT_THAT(messageOf(folder / "cube.obj", {.fileBytes = 100}), testing::HasSubstr("reduce"));
    EXPECT_THAT(messageOf(folder / "cube.obj", {.triangles = 11}), testing::HasSubstr("12 triangles"));
}

TEST(MeshFile, DamageNeverEndsTheProgram)
{
    const TemporaryFolder folder;
    std::string stl(84, '\0');
    stl[80] = 40;
    std::mt19937 random(3);
    for (int i = 0; i < 40 * 50; ++i)
        stl += static_cast<char>(random());
    const std::string seeds[] = {cubeObj, stl, "OFF\n3 1 0\n0 0 0\n3 0 0\n0 4 0\n3 0 1 2\n"};
    const char* names[] = {"x.obj", "x.stl", "x.off"};
    for (int round = 0; round < 8; ++round)
        for (size_t k = 0; k < 3; ++k) {
            std::string bytes = seeds[k];
            for (int i = 0; i < 1 + round; ++i)
                bytes[random() % bytes.size()] = static_cast<char>(random());
            bytes.resize(bytes.size() - (round % 2 ? random() % bytes.size() : 0));
            writeBytes(folder / names[k], bytes);
            const std::string message = messageOf(folder / names[k]); // read or refused
            if (!message.empty())
                expectOneLineAbout(message, folder / names[k]);
        }
}

TEST(MeshFile, NamesNoFileOutsideItsFolder)
{
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder / "inside");
    std::string buffer(36, '\0');
    buffer[14] = buffer[30] = '\x80';
    buffer[15] = buffer[31] = '\x3f';
    writeBytes(folder / "outside.bin", buffer);
    writeBytes(folder / "inside/inside.bin", buffer);
    const auto gltf = [](const std::string& uri) {
        return R"({"asset":{"version":"2.0"},"buffers":[{"uri":")" + uri +
               R"(","byteLength":36}],"bufferViews":[{"buffer":0,"byteLength":36}],)"
               R"("accessors":[{"bufferView":0,"count":3,"componentType":5126,"type":"VEC3","min":[0,0,0],"max":[1,1,0]}],)"
               R"("meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],"nodes":[{"mesh":0}],"scenes":[{"nodes":[0]}],"scene":0})";
    };
    writeBytes(folder / "inside/good.gltf", gltf("inside.bin"));
    writeBytes(folder / "inside/bad.gltf", gltf("../outside.bin"));
    EXPECT_EQ(readMesh(folder / "inside/good.gltf").indices.size(), 3u);
    expectOneLineAbout(messageOf(folder / "inside/bad.gltf"), folder / "inside/bad.gltf");
}
