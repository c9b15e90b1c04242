#include "ktx2.h"

#include "byte_source.h"
#include "texture_size.h"
#include "zstd_codec.h"

#include <array>
#include <optional>
#include <vector>

namespace mirrorball::ktx2 {

namespace {

using namespace std::string_view_literals;

constexpr std::string_view signature = "\xABKTX 20\xBB\r\n\x1A\n"sv;
constexpr std::uint32_t noCompression = 0, zstandard = 2;
constexpr size_t headerBytes = 80, levelIndexBytes = 24;
constexpr std::uint64_t largestMetadata = 1 << 20; ///< bytes

size_t aligned(size_t size, size_t to) { return (size + to - 1) / to * to; }

/// A channel in the data format descriptor.
struct Sample {
    std::uint32_t bitOffset = 0, bitLength = 0, channel = 0, qualifiers = 0, lower = 0, upper = 0;
};

constexpr std::uint32_t isFloat = 0x80, isSigned = 0x40, isExponent = 0x20; // Data Format 1.3, table 5.10
constexpr std::uint32_t red = 0, green = 1, blue = 2, alpha = 15;
constexpr std::uint32_t one = 0x3f800000, minusOne = 0xbf800000; // as float bits

/// Channels of the formats, after the Data Format Specification's examples; a shared exponent counts once a channel.
std::vector<Sample> samplesOf(TexelFormat format)
{
    std::vector<Sample> samples;
    const auto add = [&](std::uint32_t offset, std::uint32_t length, std::uint32_t channel, std::uint32_t qualifiers, std::uint32_t lower,
                         std::uint32_t upper) {
        samples.push_back({offset, length, channel, qualifiers, lower, upper});
    };
    switch (format) {
    case TexelFormat::Half:
    case TexelFormat::Float: {
        const std::uint32_t bits = format == TexelFormat::Half ? 16 : 32;
        for (const std::uint32_t channel : {red, green, blue, alpha})
            add(bits * static_cast<std::uint32_t>(samples.size()), bits, channel, isFloat | isSigned, minusOne, one);
        break;
    }
    case TexelFormat::R11G11B10:
        add(0, 11, red, isFloat, 0, one);
        add(11, 11, green, isFloat, 0, one);
        add(22, 10, blue, isFloat, 0, one);
        break;
    case TexelFormat::E5B9G9R9:
        for (const std::uint32_t channel : {red, green, blue}) {
            add(9 * channel, 9, channel, 0, 0, 8448);
            add(27, 5, channel, isExponent, 15, 31);
        }
        break;
    }
    return samples;
}

std::string descriptor(TexelFormat format)
{
    constexpr std::uint32_t rgb = 1, rec709 = 1, linear = 1, version = 2;
    const std::vector<Sample> samples = samplesOf(format);
    const auto block = static_cast<std::uint32_t>(24 + 16 * samples.size());
    std::string bytes;
    for (const std::uint32_t word : {block + 4, 0u, version | block << 16, rgb | rec709 << 8 | linear << 16, 0u, traits(format).bytes, 0u})
        appendLittle(bytes, word);
    for (const Sample& s : samples)
        for (const std::uint32_t word : {s.bitOffset | (s.bitLength - 1) << 16 | (s.channel | s.qualifiers) << 24, 0u, s.lower, s.upper})
            appendLittle(bytes, word);
    return bytes;
}

/// std::map is in the order of the keys' bytes, as the specification asks.
std::string metadataBytes(const Texture& texture)
{
    std::map<std::string, std::string> metadata = texture.metadata;
    metadata["KTXorientation"] = "rd";
    metadata["KTXwriter"] = "Mirrorball";
    std::string bytes;
    for (const auto& [key, value] : metadata) {
        appendLittle(bytes, static_cast<std::uint32_t>(key.size() + value.size() + 2));
        bytes.append(key).push_back('\0');
        bytes.append(value).push_back('\0');
        bytes.append(aligned(bytes.size(), 4) - bytes.size(), '\0');
    }
    return bytes;
}

void readMetadata(std::string_view bytes, const std::string& name, Texture& texture)
{
    ByteSource source(bytes, name);
    while (source.left() > 0) {
        const std::uint32_t size = source.u32();
        const std::string_view pair = source.take(size);
        const size_t end = pair.find('\0');
        if (end == std::string_view::npos)
            source.damaged("a key of its metadata has no end");
        std::string_view value = pair.substr(end + 1);
        if (!value.empty() && value.back() == '\0')
            value.remove_suffix(1);
        texture.metadata.emplace(std::string(pair.substr(0, end)), std::string(value));
        source.take(std::min(aligned(size, 4) - size, source.left()));
    }
}

std::optional<TexelFormat> formatOf(std::uint32_t vkFormat)
{
    for (const TexelFormat format : allTexelFormats())
        if (traits(format).vkFormat == vkFormat)
            return format;
    return {};
}

} // namespace

bool hasSignature(std::string_view firstBytes) { return firstBytes.starts_with(signature); }

std::string write(const Texture& texture, Compression compression)
{
    validate(texture);
    const TexelFormatTraits& format = traits(texture.format);
    const bool zstd = compression == Compression::Zstandard;
    const std::string described = descriptor(texture.format), metadata = metadataBytes(texture);
    std::vector<std::string> levels(texture.levels.size());
    std::vector<size_t> lengths(levels.size()), offsets(levels.size());
    for (size_t i = 0; i < levels.size(); ++i) {
        appendTexels(levels[i], texture.levels[i].texels, texture.format);
        lengths[i] = levels[i].size();
        if (zstd)
            levels[i] = zstd::packed(levels[i]);
    }
    const size_t describedAt = headerBytes + levelIndexBytes * levels.size(), metadataAt = describedAt + described.size();
    size_t end = metadataAt + metadata.size();
    for (size_t i = levels.size(); i-- > 0;) { // uncompressed levels stand on multiples of their texels' size
        offsets[i] = zstd ? end : aligned(end, std::max<size_t>(4, format.bytes));
        end = offsets[i] + levels[i].size();
    }
    std::string bytes(signature);
    for (const size_t value :
         {size_t{format.vkFormat}, size_t{format.glTypeSize}, static_cast<size_t>(texture.width()), static_cast<size_t>(texture.height()),
          size_t{0}, static_cast<size_t>(texture.slices > 1 ? texture.slices : 0), static_cast<size_t>(texture.faces), levels.size(),
          size_t{zstd ? zstandard : noCompression}, describedAt, described.size(), metadataAt, metadata.size()})
        appendLittle(bytes, static_cast<std::uint32_t>(value));
    bytes.append(16, '\0'); // no supercompression global data
    for (size_t i = 0; i < levels.size(); ++i)
        for (const size_t value : {offsets[i], levels[i].size(), lengths[i]})
            appendLittle(bytes, std::uint64_t{value});
    bytes += described;
    bytes += metadata;
    for (size_t i = levels.size(); i-- > 0;) {
        bytes.append(offsets[i] - bytes.size(), '\0');
        bytes += levels[i];
    }
    return bytes;
}

Texture read(std::string_view bytes, const std::string& name)
{
    ByteSource source(bytes, name);
    source.take(signature.size());
    const std::uint32_t vkFormat = source.u32();
    source.u32(); // typeSize
    TextureSize size;
    size.width = source.u32();
    size.height = std::max(1u, source.u32());
    const std::uint32_t depth = source.u32();
    size.slices = std::max(1u, source.u32());
    size.faces = source.u32();
    size.levels = std::max(1u, source.u32());
    const std::uint32_t scheme = source.u32();
    source.take(8); // the descriptor says what vkFormat says already
    const std::uint32_t metadataAt = source.u32(), metadataSize = source.u32();
    source.take(16);
    const std::optional<TexelFormat> format = formatOf(vkFormat);
    if (!format)
        source.unsupported("its texels are in Vulkan's format " + std::to_string(vkFormat) +
                           ", which is not read; save it as RGBA16F, RGBA32F, B10G11R11 or E5B9G9R9");
    if (scheme != noCompression && scheme != zstandard)
        source.unsupported("is compressed by scheme " + std::to_string(scheme) + ", which is not read; save it plain or with Zstandard");
    if (depth > 1)
        source.unsupported("is a volume texture; save its slices as pictures");
    Texture texture = checkedTexture(name, source, size, *format);
    checkTexelsHeld(name, static_cast<long long>(size.width), static_cast<long long>(size.height * size.faces * size.slices), bytes.size(),
                    256);
    const auto part = [&](std::uint64_t offset, std::uint64_t length) {
        if (offset > bytes.size() || length > bytes.size() - offset)
            source.damaged("it ends early");
        return bytes.substr(static_cast<size_t>(offset), static_cast<size_t>(length));
    };
    if (metadataSize > largestMetadata)
        source.damaged("its header claims " + std::to_string(metadataSize) + " bytes of metadata");
    readMetadata(part(metadataAt, metadataSize), name, texture);
    const auto levelBytes = [&](std::uint64_t level) { return pictureBytes(size, level, *format) * size.faces * size.slices; };
    std::optional<zstd::Unpacker> frames;
    if (scheme == zstandard) {
        std::uint64_t allBytes = 0;
        for (std::uint64_t i = 0; i < size.levels; ++i)
            allBytes += levelBytes(i);
        frames.emplace(source, allBytes);
    }
    for (std::uint64_t i = 0; i < size.levels; ++i) {
        const std::uint64_t offset = source.u64(), length = source.u64();
        source.u64();
        const std::uint64_t expected = levelBytes(i);
        std::string_view stored = part(offset, length);
        if (scheme == noCompression && length != expected)
            source.damaged("level " + std::to_string(i) + " has " + std::to_string(length) + " bytes instead of " +
                           std::to_string(expected));
        const std::string plain = frames ? frames->unpacked(stored, expected) : std::string();
        texture.levels.push_back(emptyLevel(size, i));
        readTexels(frames ? std::string_view(plain) : stored, texture.levels.back().texels, *format);
    }
    return texture;
}

} // namespace mirrorball::ktx2
