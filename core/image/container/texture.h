#pragma once

#include "core/image/image.h"

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// Textures as engines load them from one file: all faces of a cube and all levels, in the format of the graphics card.
namespace mirrorball {

/// How a container stores texels. Each is a row of texelFormatTraits().
enum class TexelFormat {
    Half,      ///< R16G16B16A16, alpha 1
    Float,     ///< R32G32B32A32, alpha 1
    R11G11B10, ///< packed_texel.h
    E5B9G9R9,  ///< packed_texel.h
};

struct TexelFormatTraits {
    std::string_view name{}; ///< "rgba16f", "rgba32f", "r11g11b10", "e5b9g9r9": the words of files and command line
    std::uint32_t bytes = 0; ///< a texel
    float largest = 0.0f;    ///< a channel
    bool negative = false;   ///< whether it holds negative values
    std::uint32_t glType = 0, glFormat = 0, glInternalFormat = 0, glBaseInternalFormat = 0, glTypeSize = 0; ///< KTX 1
    std::uint32_t vkFormat = 0;                                                                             ///< KTX 2
};

const TexelFormatTraits& traits(TexelFormat format);
std::span<const TexelFormat> allTexelFormats();

/// A texture as its file holds it: which direction a texel stands for is a matter of whoever reads it.
struct Texture {
    int faces = 6;  ///< 6: a cube, +X -X +Y -Y +Z -Z; 1: plain pictures
    int slices = 1; ///< of an array; with faces 1 only
    TexelFormat format = TexelFormat::Half;
    /// Largest first, each half of the one before, rounded down. The pictures of a level - faces or slices - stand one below the other.
    std::vector<Image> levels{};
    std::map<std::string, std::string> metadata{}; ///< what the container calls key and value; text

    int pictures() const { return faces * slices; }
    int width() const { return levels.front().width; }
    int height() const { return levels.front().height / pictures(); }
};

/// @throws InvalidArgument when the levels do not fit together, there are none, or one is not RGB
void validate(const Texture& texture);

/// Texels, row by row, as bytes in little-endian order. `texels` holds 3 floats each.
void appendTexels(std::string& bytes, std::span<const float> texels, TexelFormat format);
/// The inverse; `bytes` holds texels.size() / 3 texels.
void readTexels(std::string_view bytes, std::span<float> texels, TexelFormat format);

} // namespace mirrorball
