#include "core/preview/mesh_file.h"

#include "core/base/error.h"
#include "tests/support/temporary_folder.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

using namespace mirrorball;
using namespace mirrorball::preview;
using namespace mirrorball::test;

// glTF meshes whose attributes are integers: KHR_mesh_quantization, and texture coordinates in glTF itself.
namespace {

/// An attribute of four vertices as it lies in a buffer, each vertex at a multiple of four bytes as glTF wants it.
struct Attribute {
    const char* name;
    int components;
    int type; ///< 5120 .. 5126
    bool normalized;
    std::string bytes{};
    int stride = 0;
};

template <class Number>
Attribute attribute(const char* name, int components, int type, bool normalized, const std::vector<Number>& numbers)
{
    Attribute made{name, components, type, normalized};
    const auto size = static_cast<int>(sizeof(Number)) * components;
    made.stride = (size + 3) / 4 * 4;
    for (size_t i = 0; i < numbers.size(); ++i) {
        made.bytes.append(reinterpret_cast<const char*>(&numbers[i]), sizeof(Number));
        if ((i + 1) % static_cast<size_t>(components) == 0)
            made.bytes.append(static_cast<size_t>(made.stride - size), '\x7f'); // padding that must not be read
    }
    return made;
}

struct Document {
    std::string json, buffer;
};

/// A tetrahedron's four vertices without indices would be no mesh; six bytes of indices per face make it one.
Document document(const std::vector<Attribute>& attributes, const std::string& uri)
{
    const std::uint16_t faces[] = {0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3};
    Document made;
    made.buffer.assign(reinterpret_cast<const char*>(faces), sizeof faces);
    std::string views = R"({"buffer":0,"byteOffset":0,"byteLength":24})", named;
    std::string accessors = R"({"bufferView":0,"componentType":5123,"count":12,"type":"SCALAR"})";
    for (size_t i = 0; i < attributes.size(); ++i) {
        const Attribute& a = attributes[i];
        const std::string number = std::to_string(i + 1);
        views += R"(,{"buffer":0,"byteOffset":)" + std::to_string(made.buffer.size()) + R"(,"byteLength":)" +
                 std::to_string(a.bytes.size()) + R"(,"byteStride":)" + std::to_string(a.stride) + "}";
        accessors += R"(,{"bufferView":)" + number + R"(,"componentType":)" + std::to_string(a.type) + R"(,"normalized":)" +
                     (a.normalized ? "true" : "false") + R"(,"count":4,"type":"VEC)" + std::to_string(a.components) + R"("})";
        named += (i == 0 ? R"(")" : R"(,")") + std::string(a.name) + R"(":)" + number;
        made.buffer += a.bytes;
    }
    made.json = R"({"asset":{"version":"2.0"},"extensionsRequired":["KHR_mesh_quantization"],"extensionsUsed":["KHR_mesh_quantization"],)"
                R"("buffers":[{)" +
                (uri.empty() ? "" : R"("uri":")" + uri + R"(",)") + R"("byteLength":)" + std::to_string(made.buffer.size()) +
                R"(}],"bufferViews":[)" + views + R"(],"accessors":[)" + accessors + R"(],"meshes":[{"primitives":[{"attributes":{)" +
                named + R"(},"indices":0}]}],"nodes":[{"mesh":0,"scale":[0.5,0.25,2]}],"scenes":[{"nodes":[0]}],"scene":0})";
    return made;
}

std::string little(size_t number)
{
    std::string bytes;
    for (int i = 0; i < 4; ++i)
        bytes.push_back(static_cast<char>(number >> (8 * i)));
    return bytes;
}

std::string glb(Document from)
{
    from.json.resize((from.json.size() + 3) / 4 * 4, ' ');
    return "glTF" + little(2) + little(28 + from.json.size() + from.buffer.size()) + little(from.json.size()) + "JSON" + from.json +
           little(from.buffer.size()) + std::string("BIN\0", 4) + from.buffer;
}

void expectSame(const Mesh& found, const Mesh& wanted, const std::string& what)
{
    ASSERT_EQ(found.indices.size(), wanted.indices.size()) << what;
    for (size_t i = 0; i < found.indices.size(); ++i) {
        const auto a = found.indices[i], b = wanted.indices[i];
        EXPECT_LT(glm::distance(found.positions[a], wanted.positions[b]), 1e-5f) << what << " corner " << i;
        EXPECT_LT(glm::distance(found.normals[a], wanted.normals[b]), 1e-5f) << what << " corner " << i;
        EXPECT_LT(glm::distance(found.texCoords[a], wanted.texCoords[b]), 1e-5f) << what << " corner " << i;
    }
}

/// Places, normals and texture coordinates in integers of one kind, against the floats that the extension's table makes of them.
template <class Number>
void expectFloatsOf(int type, bool normalized)
{
    const TemporaryFolder folder;
    constexpr Number most = std::numeric_limits<Number>::max(), least = std::numeric_limits<Number>::min(), half = most / 2;
    const std::vector<Number> places{least, 0, 0, most, 0, 0, 0, most, 0, 0, half, most};
    const std::vector<Number> normals{0, 0, most, most, 0, 0, 0, most, 0, 0, 0, most};
    const std::vector<Number> coordinates{0, 0, half, most, most, half, 10, 20};
    const auto floats = [&](const std::vector<Number>& numbers, bool isNormalized) {
        std::vector<float> values;
        for (const Number number : numbers)
            values.push_back(isNormalized ? std::max(static_cast<float>(number) / static_cast<float>(most), -1.0f)
                                          : static_cast<float>(number));
        return values;
    };
    const std::vector<Attribute> packed{attribute("POSITION", 3, type, normalized, places), attribute("NORMAL", 3, type, true, normals),
                                        attribute("TEXCOORD_0", 2, type, normalized, coordinates)};
    const std::vector<Attribute> plain{attribute("POSITION", 3, 5126, false, floats(places, normalized)),
                                       attribute("NORMAL", 3, 5126, false, floats(normals, true)),
                                       attribute("TEXCOORD_0", 2, 5126, false, floats(coordinates, normalized))};
    const Document beside = document(packed, "two%20words.bin"), inside = document(packed, ""), wanted = document(plain, "plain.bin");
    writeBytes(folder / "packed.gltf", beside.json);
    writeBytes(folder / "two words.bin", beside.buffer);
    writeBytes(folder / "packed.glb", glb(inside));
    writeBytes(folder / "plain.gltf", wanted.json);
    writeBytes(folder / "plain.bin", wanted.buffer);
    const MeshFile truth = readMeshFile(folder / "plain.gltf");
    for (const char* name : {"packed.gltf", "packed.glb"}) {
        const MeshFile found = readMeshFile(folder / name);
        EXPECT_EQ(describe(found.facts), describe(truth.facts)) << name;
        expectSame(found.mesh, truth.mesh, name + std::string(", type ") + std::to_string(type) + (normalized ? ", normalized" : ""));
    }
}

std::string messageOf(const std::filesystem::path& path)
{
    try {
        readMesh(path);
    } catch (const FileError& error) {
        return error.what();
    }
    return "";
}

} // namespace

TEST(PackedMesh, IntegersOfEveryKindAreTheFloatsThatTheyStandFor)
{
    for (const bool normalized : {true, false}) {
        expectFloatsOf<std::int8_t>(5120, normalized);
        expectFloatsOf<std::uint8_t>(5121, normalized);
        expectFloatsOf<std::int16_t>(5122, normalized);
        expectFloatsOf<std::uint16_t>(5123, normalized);
    }
}

TEST(PackedMesh, ABufferInTheTextItselfIsUnpacked)
{
    const TemporaryFolder folder;
    const std::vector<std::int16_t> places{0, 0, 0, 300, 0, 0, 0, 400, 0, 0, 0, 500};
    const std::vector<Attribute> attributes{attribute("POSITION", 3, 5122, false, places)};
    constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    const std::string bytes = document(attributes, "").buffer; // padded with one "="
    std::string text;
    for (size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t bits = 0;
        for (size_t k = 0; k < 3; ++k)
            bits = bits << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
        for (size_t k = 0; k < 4; ++k)
            text += i + k > bytes.size() ? '=' : letters[bits >> (18 - 6 * k) & 63];
    }
    writeBytes(folder / "a.gltf", document(attributes, "data:application/octet-stream;base64," + text).json);
    const MeshFacts facts = readMeshFile(folder / "a.gltf").facts;
    EXPECT_EQ(facts.triangles, 4u);
    EXPECT_NEAR(facts.extent, 1000.0, 1e-3) << "500 along z, which the node scales by 2";
}

TEST(PackedMesh, AttributesBeyondTheirBufferAreRefusedInOneLine)
{
    const TemporaryFolder folder;
    const std::vector<std::int16_t> places{0, 0, 0, 300, 0, 0, 0, 400, 0, 0, 0, 500};
    const Document good = document({attribute("POSITION", 3, 5122, false, places)}, "a.bin");
    writeBytes(folder / "a.bin", good.buffer);
    writeBytes(folder / "a.gltf", good.json);
    ASSERT_EQ(messageOf(folder / "a.gltf"), "");
    const auto altered = [&](const std::string& from, const std::string& to) {
        std::string json = good.json;
        json.replace(json.find(from), from.size(), to);
        writeBytes(folder / "a.gltf", json);
        return messageOf(folder / "a.gltf");
    };
    using testing::HasSubstr;
    EXPECT_THAT(altered(R"("count":4)", R"("count":5)"), HasSubstr("beyond its buffer"));
    EXPECT_THAT(altered(R"("count":4)", R"("count":18446744073709551615)"), HasSubstr("beyond its buffer"));
    EXPECT_THAT(altered(R"("byteOffset":24)", R"("byteOffset":18446744073709551608)"), HasSubstr("beyond its buffer"));
    EXPECT_THAT(altered(R"("byteStride":8)", R"("byteStride":9223372036854775807)"), HasSubstr("beyond its buffer"));
    EXPECT_THAT(altered("a.bin", "b.bin"), HasSubstr("missing"));
    EXPECT_THAT(altered(R"("count":4)", R"("sparse":{},"count":4)"), HasSubstr("sparse"));
    EXPECT_THAT(altered("KHR_mesh_quantization", "EXT_meshopt_compression"), HasSubstr("EXT_meshopt_compression"));
}
