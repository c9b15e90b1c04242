#pragma once

#include "byte_source.h"
#include "texture.h"

#include "core/image/input_checks.h"

#include <algorithm>
#include <bit>

/// What every reader of textures checks before it takes memory.
namespace mirrorball {

/// The sizes that a header claims.
struct TextureSize {
    std::uint64_t width = 0, height = 0, faces = 1, slices = 1, levels = 1;
};

/// An empty texture of these sizes. The file must be long enough for them, so a lying header takes no memory.
/// @throws FileError for a size that no texture has
inline Texture checkedTexture(const std::string& name, const ByteSource& source, const TextureSize& size, TexelFormat format)
{
    if (size.faces != 1 && size.faces != 6)
        source.damaged("its header claims " + std::to_string(size.faces) + " faces");
    const std::uint64_t pictures = size.faces * std::max<std::uint64_t>(size.slices, 1);
    if (size.slices > 1 && size.faces == 6)
        source.unsupported("is an array of cubes; save them one by one");
    if (size.width > maxTexels || size.height > maxTexels || pictures > 4096)
        source.damaged("its header claims " + std::to_string(size.width) + " x " + std::to_string(size.height) + " texels and " +
                       std::to_string(pictures) + " pictures");
    checkImageSize(name, static_cast<long long>(size.width), static_cast<long long>(size.height * pictures));
    if (size.faces == 6 && size.width != size.height)
        source.damaged("its cube's faces are " + std::to_string(size.width) + " x " + std::to_string(size.height));
    const auto most = static_cast<std::uint64_t>(std::bit_width(std::max(size.width, size.height)));
    if (size.levels < 1 || size.levels > most)
        source.damaged("its header claims " + std::to_string(size.levels) + " levels; " + std::to_string(most) + " fit");
    Texture texture;
    texture.faces = static_cast<int>(size.faces);
    texture.slices = static_cast<int>(std::max<std::uint64_t>(size.slices, 1));
    texture.format = format;
    return texture;
}

/// Bytes of one picture of a level.
inline std::uint64_t pictureBytes(const TextureSize& size, std::uint64_t level, TexelFormat format)
{
    return std::max<std::uint64_t>(1, size.width >> level) * std::max<std::uint64_t>(1, size.height >> level) * traits(format).bytes;
}

/// A level of a texture, all pictures of it, black.
inline Image emptyLevel(const TextureSize& size, std::uint64_t level)
{
    const std::uint64_t pictures = size.faces * std::max<std::uint64_t>(size.slices, 1);
    return {static_cast<int>(std::max<std::uint64_t>(1, size.width >> level)),
            static_cast<int>(pictures * std::max<std::uint64_t>(1, size.height >> level)), 3};
}

/// The texels of one picture of a level.
inline std::span<float> pictureOf(Image& level, int pictures, int index)
{
    const size_t floats = level.texels.size() / static_cast<size_t>(pictures);
    return {level.texels.data() + floats * static_cast<size_t>(index), floats};
}
inline std::span<const float> pictureOf(const Image& level, int pictures, int index)
{
    const size_t floats = level.texels.size() / static_cast<size_t>(pictures);
    return {level.texels.data() + floats * static_cast<size_t>(index), floats};
}

} // namespace mirrorball
