#include "gltf_text.h"

#include "core/base/error.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <map>
#include <set>
#include <string_view>

namespace mirrorball::helper {
namespace {

using nlohmann::json;

/// glTF 2.0, section 3.6.2.2.
enum class Component : std::uint64_t { Byte = 5120, UnsignedByte = 5121, Short = 5122, UnsignedShort = 5123, Float = 5126 };

[[noreturn]] void refuse(const std::string& what) { throw InvalidArgument("the mesh cannot be read (" + what + "); export it again"); }

const json& memberOf(const json& object, const char* key)
{
    static const json nothing;
    const auto found = object.is_object() ? object.find(key) : object.end();
    return object.is_object() && found != object.end() ? *found : nothing;
}

std::uint64_t numberOf(const json& object, const char* key, std::uint64_t otherwise)
{
    const json& value = memberOf(object, key);
    return value.is_number_unsigned() ? value.get<std::uint64_t>() : otherwise;
}

/// RFC 4648; what is none of its letters is passed over.
std::string base64Decoded(std::string_view text)
{
    constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::array<int, 256> value{};
    value.fill(-1);
    for (std::size_t i = 0; i < letters.size(); ++i)
        value[static_cast<unsigned char>(letters[i])] = static_cast<int>(i);
    std::string bytes;
    std::uint32_t bits = 0;
    int count = 0;
    for (const char c : text) {
        const int six = value[static_cast<unsigned char>(c)];
        if (six < 0)
            continue;
        bits = bits << 6 | static_cast<std::uint32_t>(six);
        if ((count += 6) >= 8)
            bytes.push_back(static_cast<char>(bits >> (count -= 8)));
    }
    return bytes;
}

/// The two chunks of a .glb file (glTF 2.0, section 4), or the whole of a .gltf file.
struct Chunks {
    bool isBinary = false;
    std::string_view json{}, buffer{};
};

std::uint32_t littleAt(std::string_view bytes, std::size_t at)
{
    std::uint32_t number = 0;
    for (std::size_t i = 0; i < 4; ++i)
        number |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[at + i])) << (8 * i);
    return number;
}

Chunks chunksOf(std::string_view bytes)
{
    constexpr std::size_t head = 12, chunkHead = 8;
    if (!bytes.starts_with("glTF") || bytes.size() < head + chunkHead)
        return {.json = bytes};
    Chunks chunks{.isBinary = true};
    std::string_view rest = bytes.substr(head);
    for (std::string_view* chunk : {&chunks.json, &chunks.buffer}) {
        if (rest.size() < chunkHead)
            break;
        const std::uint32_t size = littleAt(rest, 0);
        rest.remove_prefix(chunkHead);
        *chunk = rest.substr(0, size);
        rest.remove_prefix(chunk->size());
    }
    return chunks;
}

void appendLittle(std::string& bytes, std::size_t number)
{
    for (int i = 0; i < 4; ++i)
        bytes.push_back(static_cast<char>(number >> (8 * i)));
}

std::string assembled(const Chunks& chunks, std::string text)
{
    if (!chunks.isBinary)
        return text;
    text.resize((text.size() + 3) / 4 * 4, ' ');
    std::string bytes = "glTF";
    appendLittle(bytes, 2);
    appendLittle(bytes, 12 + 8 + text.size() + (chunks.buffer.empty() ? 0 : 8 + chunks.buffer.size()));
    appendLittle(bytes, text.size());
    (bytes += "JSON") += text;
    if (!chunks.buffer.empty()) {
        appendLittle(bytes, chunks.buffer.size());
        bytes.append("BIN\0", 4) += chunks.buffer;
    }
    return bytes;
}

/// A component as the extension's table of conversions has it.
float floatOf(const char* at, Component type, bool normalized)
{
    const auto integer = [&](auto number, float largest) {
        std::memcpy(&number, at, sizeof number);
        const auto value = static_cast<float>(number);
        return normalized ? std::max(value / largest, -1.0f) : value;
    };
    switch (type) {
    case Component::Byte:
        return integer(std::int8_t{}, 127.0f);
    case Component::UnsignedByte:
        return integer(std::uint8_t{}, 255.0f);
    case Component::Short:
        return integer(std::int16_t{}, 32767.0f);
    case Component::UnsignedShort:
        return integer(std::uint16_t{}, 65535.0f);
    case Component::Float:
        break;
    }
    return 0.0f;
}

class Unpacking {
public:
    Unpacking(json& document, const Chunks& chunks, const std::function<std::optional<std::string>(const std::string&)>& beside)
        : m_document(document), m_chunks(chunks), m_beside(beside)
    {
    }

    /// @return the floats of all attributes that had to be unpacked, one after the other
    std::string run()
    {
        for (const std::uint64_t index : attributes())
            unpack(m_document["accessors"][index]);
        if (!m_floats.empty())
            m_document["buffers"].push_back({{"uri", gltfFloats}, {"byteLength", m_floats.size()}});
        return std::move(m_floats);
    }

private:
    /// The accessors of attributes that are looked at and packed.
    std::set<std::uint64_t> attributes() const
    {
        std::set<std::uint64_t> found;
        const json& accessors = memberOf(m_document, "accessors");
        const auto isPacked = [&](const json& index) {
            if (!index.is_number_unsigned() || !accessors.is_array() || index.get<std::uint64_t>() >= accessors.size())
                return false;
            const std::uint64_t type = numberOf(accessors[index.get<std::uint64_t>()], "componentType", 0);
            return type >= static_cast<std::uint64_t>(Component::Byte) && type <= static_cast<std::uint64_t>(Component::UnsignedShort);
        };
        const json& meshes = memberOf(m_document, "meshes");
        for (std::size_t m = 0; meshes.is_array() && m < meshes.size(); ++m) {
            const json& primitives = memberOf(meshes[m], "primitives");
            for (std::size_t p = 0; primitives.is_array() && p < primitives.size(); ++p) {
                const json& named = memberOf(primitives[p], "attributes");
                for (const char* name : {"POSITION", "NORMAL", "TANGENT", "TEXCOORD_0"})
                    if (const json& index = memberOf(named, name); isPacked(index))
                        found.insert(index.get<std::uint64_t>());
            }
        }
        return found;
    }

    void unpack(json& accessor)
    {
        const auto type = static_cast<Component>(numberOf(accessor, "componentType", 0));
        const std::size_t size = type == Component::Byte || type == Component::UnsignedByte ? 1 : 2;
        const json& shape = memberOf(accessor, "type");
        const std::size_t components = shape == "VEC2" ? 2 : shape == "VEC3" ? 3 : shape == "VEC4" ? 4 : 0;
        if (components == 0)
            refuse("a packed attribute is no vector");
        if (accessor.contains("sparse"))
            refuse("a packed attribute is sparse, which is not read");
        const std::uint64_t count = numberOf(accessor, "count", 0), element = components * size;
        const json& view = viewOf(accessor);
        const std::uint64_t stride = std::max(numberOf(view, "byteStride", element), element);
        std::string_view bytes = bufferOf(numberOf(view, "buffer", 0));
        for (const std::uint64_t skipped : {numberOf(view, "byteOffset", 0), numberOf(accessor, "byteOffset", 0)})
            bytes.remove_prefix(std::min<std::uint64_t>(skipped, bytes.size()));
        if (count == 0 || bytes.size() < element || (bytes.size() - element) / stride < count - 1)
            refuse("a packed attribute lies beyond its buffer");

        const json& flag = memberOf(accessor, "normalized");
        const bool normalized = flag.is_boolean() && flag.get<bool>();
        const std::size_t start = m_floats.size();
        for (std::uint64_t i = 0; i < count; ++i)
            for (std::size_t c = 0; c < components; ++c) {
                const float value = floatOf(bytes.data() + i * stride + c * size, type, normalized);
                m_floats.append(reinterpret_cast<const char*>(&value), sizeof value);
            }
        json& views = m_document["bufferViews"];
        accessor["bufferView"] = views.size();
        views.push_back(
            {{"buffer", memberOf(m_document, "buffers").size()}, {"byteOffset", start}, {"byteLength", m_floats.size() - start}});
        accessor["componentType"] = static_cast<std::uint64_t>(Component::Float);
        for (const char* stale : {"byteOffset", "normalized", "min", "max"})
            accessor.erase(stale);
    }

    const json& viewOf(const json& accessor) const
    {
        const json& views = memberOf(m_document, "bufferViews");
        const json& index = memberOf(accessor, "bufferView");
        if (!views.is_array() || !index.is_number_unsigned() || index.get<std::uint64_t>() >= views.size())
            refuse("a packed attribute has no buffer");
        return views[index.get<std::uint64_t>()];
    }

    std::string_view bufferOf(std::uint64_t index)
    {
        const json& buffers = memberOf(m_document, "buffers");
        if (!buffers.is_array() || index >= buffers.size())
            refuse("a packed attribute has no buffer");
        const json& uri = memberOf(buffers[index], "uri");
        if (!uri.is_string())
            return index == 0 ? m_chunks.buffer : std::string_view();
        if (const auto known = m_buffers.find(index); known != m_buffers.end())
            return known->second;
        const auto& name = uri.get_ref<const std::string&>();
        std::optional<std::string> bytes;
        if (name.starts_with("data:"))
            bytes = base64Decoded(std::string_view(name).substr(std::min(name.find(',') + 1, name.size())));
        else
            bytes = m_beside(name);
        if (!bytes)
            refuse("a buffer beside it is missing");
        return m_buffers.emplace(index, std::move(*bytes)).first->second;
    }

    json& m_document;
    const Chunks& m_chunks;
    const std::function<std::optional<std::string>(const std::string&)>& m_beside;
    std::map<std::uint64_t, std::string> m_buffers{};
    std::string m_floats{};
};

} // namespace

GltfText withFloatAttributes(const std::string& bytes, const std::function<std::optional<std::string>(const std::string& uri)>& beside)
{
    const Chunks chunks = chunksOf(bytes);
    json document = json::parse(chunks.json, nullptr, false);
    if (!document.is_object())
        return {bytes, {}};
    for (const json& name : memberOf(document, "extensionsRequired"))
        if (name == "EXT_meshopt_compression") // which assimp does not know: it would read noise
            throw InvalidArgument("the mesh is packed as EXT_meshopt_compression has it, which is not read; export it without");
    std::string floats = Unpacking(document, chunks, beside).run();
    if (floats.empty())
        return {bytes, {}};
    return {assembled(chunks, document.dump(-1, ' ', false, json::error_handler_t::replace)), std::move(floats)};
}

} // namespace mirrorball::helper
