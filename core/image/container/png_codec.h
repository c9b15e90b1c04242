#pragma once

#include "packed_texel.h"

#include "core/image/image.h"

#include <string>
#include <string_view>
#include <vector>

/// PNG pictures in memory, by libpng itself: encoded radiance goes through without a color space, and alpha stays straight.
/// (OpenImageIO would do, but loading it costs more time than a whole environment takes.) Pictures of others are decoded in the helper
/// (core/base/helper_process.h), which starts in milliseconds where it needs no OpenImageIO.
namespace mirrorball::png {

/// 8-bit RGBA texels, top row first.
struct Picture {
    int width = 0;
    int height = 0;
    std::vector<Rgba8> texels{};
};

/// Radiance packed into a picture; a fourth channel is left out, one channel is gray.
Picture packed(const Image& image, PackedColor form);

/// The bytes of a PNG file without ancillary chunks. @throws WorkError
std::string encode(const Picture& picture);

/// Decodes any PNG to 8-bit RGBA, in the helper; its gamma and color profile are not looked at. Memory is taken only for a size that
/// `largestTexels` allows.
/// @param name  stands in messages
/// @throws FileError for damaged data; WorkError where there is no helper
Picture decode(std::string_view bytes, const std::string& name, long long largestTexels);

} // namespace mirrorball::png
