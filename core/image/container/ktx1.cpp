#include "ktx1.h"

#include "byte_source.h"
#include "texture_size.h"

#include <array>
#include <optional>

namespace mirrorball::ktx1 {

namespace {

using namespace std::string_view_literals;

constexpr std::string_view signature = "\xABKTX 11\xBB\r\n\x1A\n"sv;
constexpr std::uint32_t littleEndian = 0x04030201, bigEndian = 0x01020304;
constexpr std::uint64_t largestMetadata = 1 << 20; ///< bytes; what is beyond is no text about a texture

size_t padding(size_t size) { return (4 - size % 4) % 4; }

std::string metadataBytes(const Texture& texture)
{
    std::string bytes;
    for (const auto& [key, value] : texture.metadata) {
        const size_t size = key.size() + 1 + value.size() + 1;
        appendLittle(bytes, static_cast<std::uint32_t>(size));
        bytes.append(key).push_back('\0');
        bytes.append(value).push_back('\0');
        bytes.append(padding(size), '\0');
    }
    return bytes;
}

void readMetadata(std::string_view bytes, const std::string& name, Texture& texture)
{
    ByteSource source(bytes, name);
    while (source.left() > 0) {
        const std::uint32_t size = source.u32();
        std::string_view pair = source.take(size);
        const size_t end = pair.find('\0');
        if (end == std::string_view::npos)
            source.damaged("a key of its metadata has no end");
        std::string_view value = pair.substr(end + 1);
        if (!value.empty() && value.back() == '\0')
            value.remove_suffix(1);
        texture.metadata.emplace(std::string(pair.substr(0, end)), std::string(value));
        source.take(std::min<size_t>(padding(size), source.left()));
    }
}

/// The format by the number that says how texels are stored. Three halves or floats without alpha are no format that is written.
std::optional<TexelFormat> formatOf(std::uint32_t glInternalFormat)
{
    for (const TexelFormat format : allTexelFormats())
        if (traits(format).glInternalFormat == glInternalFormat)
            return format;
    return {};
}

} // namespace

bool hasSignature(std::string_view firstBytes) { return firstBytes.starts_with(signature); }

std::string write(const Texture& texture, SmallFloatType smallFloats)
{
    validate(texture);
    const TexelFormatTraits& format = traits(texture.format);
    const bool filament = smallFloats == SmallFloatType::Filament && texture.format == TexelFormat::R11G11B10;
    const std::string metadata = metadataBytes(texture);
    std::string bytes(signature);
    for (const std::uint32_t value :
         {littleEndian, filament ? format.glInternalFormat : format.glType, format.glTypeSize, format.glFormat, format.glInternalFormat,
          format.glBaseInternalFormat, static_cast<std::uint32_t>(texture.width()), static_cast<std::uint32_t>(texture.height()), 0u,
          static_cast<std::uint32_t>(texture.slices > 1 ? texture.slices : 0), static_cast<std::uint32_t>(texture.faces),
          static_cast<std::uint32_t>(texture.levels.size()), static_cast<std::uint32_t>(metadata.size())})
        appendLittle(bytes, value);
    bytes += metadata;
    for (const Image& level : texture.levels) {
        // "imageSize" counts one face of a plain cube, but everything of an array.
        const size_t size = level.texels.size() / 3 * format.bytes;
        appendLittle(bytes, static_cast<std::uint32_t>(size / static_cast<size_t>(texture.faces)));
        appendTexels(bytes, level.texels, texture.format);
    }
    return bytes;
}

Texture read(std::string_view bytes, const std::string& name)
{
    ByteSource source(bytes, name);
    source.take(signature.size());
    const std::uint32_t endianness = source.u32();
    if (endianness == bigEndian)
        source.unsupported("is a big-endian KTX file; save it in little-endian order");
    if (endianness != littleEndian)
        source.damaged("its byte order cannot be told");
    source.take(12); // glType, glTypeSize, glFormat: the internal format says it all
    const std::uint32_t internalFormat = source.u32();
    source.u32();
    TextureSize size;
    size.width = source.u32();
    size.height = source.u32();
    const std::uint32_t depth = source.u32();
    size.slices = std::max(1u, source.u32());
    size.faces = source.u32();
    size.levels = std::max(1u, source.u32());
    const std::uint32_t metadata = source.u32();
    const std::optional<TexelFormat> format = formatOf(internalFormat);
    if (!format)
        source.unsupported("its texels are in OpenGL's format " + std::to_string(internalFormat) +
                           ", which is not read; save it as RGBA16F, RGBA32F or R11F_G11F_B10F");
    if (depth > 1)
        source.unsupported("is a volume texture; save its slices as pictures");
    Texture texture = checkedTexture(name, source, size, *format);
    if (metadata > largestMetadata)
        source.damaged("its header claims " + std::to_string(metadata) + " bytes of metadata");
    readMetadata(source.take(metadata), name, texture);
    for (std::uint64_t i = 0; i < size.levels; ++i) {
        const std::uint64_t picture = pictureBytes(size, i, *format);
        const std::uint64_t expected = size.faces == 6 ? picture : picture * size.slices, claimed = source.u32();
        if (claimed != expected)
            source.damaged("level " + std::to_string(i) + " claims " + std::to_string(claimed) + " bytes instead of " +
                           std::to_string(expected));
        const std::string_view texels = source.take(picture * size.faces * size.slices);
        texture.levels.push_back(emptyLevel(size, i));
        readTexels(texels, texture.levels.back().texels, *format);
    }
    return texture;
}

} // namespace mirrorball::ktx1
