#pragma once

#include "packed_texel.h"

#include "core/base/helper_process.h"
#include "core/image/image.h"

#include <cstdint>
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

/// What the pictures of one file may cost.
struct Extent {
    long long allTexels = 0;     ///< of all pictures together
    long long largestTexels = 0; ///< of one
    std::uintmax_t bytes = 0;    ///< of the largest one as it is stored
};

/// Decodes the PNG pictures of one file. They go through one helper, and what it may spend counts for all of them.
class Decoder {
public:
    /// @param name  stands in messages
    /// @throws WorkError where there is no helper
    Decoder(std::string name, const Extent& extent);

    /// Any PNG as 8-bit RGBA; its gamma and color profile are not looked at. Memory is taken only for a size that `largestTexels` allows.
    /// @throws FileError for damaged data; WorkError where the helper cannot work
    Picture decode(std::string_view bytes, long long largestTexels);

private:
    std::string m_name;
    HelperLimits m_limits{};
    bool m_isFirst = true; ///< nothing was asked for yet
    Helper m_helper;
};

/// The same for a picture that is a file of its own.
Picture decode(std::string_view bytes, const std::string& name, long long largestTexels);

} // namespace mirrorball::png
