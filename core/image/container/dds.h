#pragma once

#include "texture.h"

#include <string>
#include <string_view>

/// DirectDraw surfaces (.dds): cubes with levels, and arrays. Source: Microsoft, DDS_HEADER and DDS_HEADER_DXT10.
namespace mirrorball::dds {

bool hasSignature(std::string_view firstBytes);

/// How the header names the format of the texels.
enum class Header {
    Direct3D9, ///< fourCC 113 or 116, half or float: what Babylon.js *and* PlayCanvas read
    Dx10       ///< every format, and arrays
};

/// The bytes of the file: picture by picture, each with all its levels.
/// @throws InvalidArgument for levels that do not fit together, and for what Direct3D 9 has no number of
std::string write(const Texture& texture, Header header = Header::Direct3D9);

/// Whether the texels are block-compressed or otherwise not among those that read() takes; OpenImageIO decodes them.
/// @throws FileError for a damaged header
bool isForeign(std::string_view bytes, const std::string& name);

/// Reads half, float, R11G11B10 and E5B9G9R9 texels with either header.
/// @param name  stands in messages
/// @throws FileError for damaged or foreign data
Texture read(std::string_view bytes, const std::string& name);

} // namespace mirrorball::dds
