#include "texture.h"

#include "byte_source.h"
#include "packed_texel.h"

#include "core/base/error.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cstring>

namespace mirrorball {

namespace {

constexpr std::array formats{TexelFormat::Half, TexelFormat::Float, TexelFormat::R11G11B10, TexelFormat::E5B9G9R9};

// GL enums: OpenGL 4.5 table 8.12; VkFormat: Vulkan 1.0.
constexpr std::array<TexelFormatTraits, formats.size()> rows{{
    {"rgba16f", 8, 65504.0f, true, 0x140b, 0x1908, 0x881a, 0x1908, 2, 97},
    {"rgba32f", 16, 3.4028235e38f, true, 0x1406, 0x1908, 0x8814, 0x1908, 4, 109},
    {"r11g11b10", 4, 64512.0f, false, 0x8c3b, 0x1907, 0x8c3a, 0x1907, 4, 122},
    {"e5b9g9r9", 4, 65408.0f, false, 0x8c3e, 0x1907, 0x8c3d, 0x1907, 4, 123},
}};

} // namespace

const TexelFormatTraits& traits(TexelFormat format) { return rows[static_cast<size_t>(format)]; }

std::span<const TexelFormat> allTexelFormats() { return formats; }

void validate(const Texture& texture)
{
    if (texture.levels.empty() || (texture.faces != 1 && texture.faces != 6) || texture.slices < 1 ||
        (texture.faces == 6 && texture.slices != 1))
        throw InvalidArgument("a texture of " + std::to_string(texture.levels.size()) + " levels, " + std::to_string(texture.faces) +
                              " faces and " + std::to_string(texture.slices) + " slices cannot be written");
    const int width = texture.width(), height = texture.height();
    for (size_t i = 0; i < texture.levels.size(); ++i) {
        const Image& level = texture.levels[i];
        if (level.channels != 3 || level.width != std::max(1, width >> i) ||
            level.height != texture.pictures() * std::max(1, height >> i) || (i > 0 && (std::max(width, height) >> i) == 0))
            throw InvalidArgument("level " + std::to_string(i) + " of a texture is " + std::to_string(level.width) + " x " +
                                  std::to_string(level.height) + " with " + std::to_string(level.channels) +
                                  " channels; it must be RGB and half of the level before");
    }
    if (texture.faces == 6 && width != height)
        throw InvalidArgument("the faces of a cube must be square; these are " + std::to_string(width) + " x " + std::to_string(height));
}

void appendTexels(std::string& bytes, std::span<const float> texels, TexelFormat format)
{
    bytes.reserve(bytes.size() + texels.size() / 3 * traits(format).bytes);
    for (size_t i = 0; i + 2 < texels.size(); i += 3) {
        const glm::vec3 rgb(texels[i], texels[i + 1], texels[i + 2]);
        switch (format) {
        case TexelFormat::Half:
            for (int c = 0; c < 3; ++c)
                appendLittle(bytes, packHalf(rgb[c]));
            appendLittle(bytes, std::uint16_t{0x3c00});
            break;
        case TexelFormat::Float:
            for (int c = 0; c < 3; ++c)
                appendLittle(bytes, std::bit_cast<std::uint32_t>(rgb[c]));
            appendLittle(bytes, std::bit_cast<std::uint32_t>(1.0f));
            break;
        case TexelFormat::R11G11B10:
            appendLittle(bytes, packR11G11B10(rgb));
            break;
        case TexelFormat::E5B9G9R9:
            appendLittle(bytes, packE5B9G9R9(rgb));
            break;
        }
    }
}

void readTexels(std::string_view bytes, std::span<float> texels, TexelFormat format)
{
    const size_t size = traits(format).bytes;
    assert(bytes.size() >= texels.size() / 3 * size);
    for (size_t i = 0, at = 0; i + 2 < texels.size(); i += 3, at += size) {
        glm::vec3 rgb;
        switch (format) {
        case TexelFormat::Half:
            for (size_t c = 0; c < 3; ++c)
                rgb[static_cast<int>(c)] = unpackHalf(littleAt<std::uint16_t>(bytes, at + 2 * c));
            break;
        case TexelFormat::Float:
            for (size_t c = 0; c < 3; ++c)
                rgb[static_cast<int>(c)] = std::bit_cast<float>(littleAt<std::uint32_t>(bytes, at + 4 * c));
            break;
        case TexelFormat::R11G11B10:
            rgb = unpackR11G11B10(littleAt<std::uint32_t>(bytes, at));
            break;
        case TexelFormat::E5B9G9R9:
            rgb = unpackE5B9G9R9(littleAt<std::uint32_t>(bytes, at));
            break;
        }
        std::copy_n(&rgb.x, 3, texels.data() + i);
    }
}

} // namespace mirrorball
