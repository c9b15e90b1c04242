#include "dds.h"

#include "byte_source.h"
#include "texture_size.h"

#include <array>
#include <optional>

namespace mirrorball::dds {

namespace {

using namespace std::string_view_literals;

constexpr std::string_view signature = "DDS "sv;
constexpr std::uint32_t headerSize = 124, pixelFormatSize = 32, hasFourCc = 4;
constexpr std::uint32_t dx10 = 0x30315844; // "DX10"
constexpr std::uint32_t allFaces = 0xfe00, anyFace = 0x200, isVolume = 0x200000, dx10Cube = 4;
constexpr std::uint32_t flags = 0x2100f; // caps, height, width, pitch, pixel format, number of levels
constexpr std::uint32_t caps = 0x401008; // complex, texture, levels

struct Row {
    TexelFormat format = TexelFormat::Half;
    std::uint32_t d3d9 = 0; ///< fourCC; 0: none
    std::uint32_t dxgi = 0;
};
constexpr std::array rows{Row{TexelFormat::Half, 113, 10}, Row{TexelFormat::Float, 116, 2}, Row{TexelFormat::R11G11B10, 0, 26},
                          Row{TexelFormat::E5B9G9R9, 0, 67}};

struct Parsed {
    TextureSize size{};
    std::optional<TexelFormat> format{};
    std::uint32_t fourCc = 0, dxgi = 0;
};

/// Reads the headers; the source stands before the texels then.
Parsed parseHeader(ByteSource& source)
{
    source.take(signature.size());
    Parsed parsed;
    if (source.u32() != headerSize)
        source.damaged("its header has another size than 124");
    source.u32();
    parsed.size.height = source.u32();
    parsed.size.width = source.u32();
    source.take(8); // pitch, depth
    parsed.size.levels = std::max(1u, source.u32());
    source.take(44);
    if (source.u32() != pixelFormatSize)
        source.damaged("its pixel format has another size than 32");
    const std::uint32_t pixelFlags = source.u32();
    parsed.fourCc = (pixelFlags & hasFourCc) != 0 ? source.u32() : (source.u32(), 0u);
    source.take(24);
    const std::uint32_t caps2 = source.u32();
    source.take(12);
    if ((caps2 & isVolume) != 0)
        source.unsupported("is a volume texture; save its slices as pictures");
    bool cube = (caps2 & anyFace) != 0;
    if (cube && (caps2 & allFaces) != allFaces)
        source.unsupported("is a cube without some of its faces; save all six");
    if (parsed.fourCc == dx10) {
        parsed.dxgi = source.u32();
        if (source.u32() != 3)
            source.unsupported("is no two-dimensional texture; save it as one");
        const std::uint32_t miscellaneous = source.u32();
        cube = cube || (miscellaneous & dx10Cube) != 0;
        parsed.size.slices = source.u32();
        source.u32();
    }
    parsed.size.faces = cube ? 6 : 1;
    for (const Row& row : rows)
        if (parsed.fourCc == dx10 ? row.dxgi == parsed.dxgi : row.d3d9 != 0 && row.d3d9 == parsed.fourCc)
            parsed.format = row.format;
    return parsed;
}

} // namespace

bool hasSignature(std::string_view firstBytes) { return firstBytes.starts_with(signature); }

std::string write(const Texture& texture, Header header)
{
    validate(texture);
    const Row& row = rows[static_cast<size_t>(texture.format)];
    const bool cube = texture.faces == 6;
    if (header == Header::Direct3D9 && (row.d3d9 == 0 || texture.slices > 1))
        throw InvalidArgument("a .dds file with Direct3D 9's header holds half and float texels and no arrays; write the DX10 header");
    const std::uint32_t width = static_cast<std::uint32_t>(texture.width());
    std::string bytes(signature);
    const auto append = [&](std::initializer_list<std::uint32_t> values) {
        for (const std::uint32_t value : values)
            appendLittle(bytes, value);
    };
    append({headerSize, flags, static_cast<std::uint32_t>(texture.height()), width, width * traits(texture.format).bytes, 0,
            static_cast<std::uint32_t>(texture.levels.size())});
    bytes.append(44, '\0');
    append({pixelFormatSize, hasFourCc, header == Header::Dx10 ? dx10 : row.d3d9, 0, 0, 0, 0, 0, caps, cube ? allFaces : 0, 0, 0, 0});
    if (header == Header::Dx10)
        append({row.dxgi, 3, cube ? dx10Cube : 0, static_cast<std::uint32_t>(texture.slices), 0});
    for (int picture = 0; picture < texture.pictures(); ++picture)
        for (const Image& level : texture.levels)
            appendTexels(bytes, pictureOf(level, texture.pictures(), picture), texture.format);
    return bytes;
}

bool isForeign(std::string_view bytes, const std::string& name)
{
    ByteSource source(bytes, name);
    return !parseHeader(source).format;
}

Texture read(std::string_view bytes, const std::string& name)
{
    ByteSource source(bytes, name);
    const Parsed parsed = parseHeader(source);
    if (!parsed.format)
        source.unsupported("its texels are in a format that is not read; save it as RGBA16F or RGBA32F");
    const TextureSize& size = parsed.size;
    Texture texture = checkedTexture(name, source, size, *parsed.format);
    std::uint64_t needed = 0;
    for (std::uint64_t level = 0; level < size.levels; ++level)
        needed += pictureBytes(size, level, *parsed.format) * static_cast<std::uint64_t>(texture.pictures());
    if (source.left() < needed)
        source.damaged("it ends early");
    for (std::uint64_t level = 0; level < size.levels; ++level)
        texture.levels.push_back(emptyLevel(size, level));
    for (int picture = 0; picture < texture.pictures(); ++picture)
        for (std::uint64_t level = 0; level < size.levels; ++level)
            readTexels(source.take(pictureBytes(size, level, *parsed.format)),
                       pictureOf(texture.levels[static_cast<size_t>(level)], texture.pictures(), picture), *parsed.format);
    return texture;
}

} // namespace mirrorball::dds
