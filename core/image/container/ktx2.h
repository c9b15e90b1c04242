#pragma once

#include "texture.h"

#include <string>
#include <string_view>

/// KTX 2 (.ktx2): what Bevy and WebGPU applications take. Source: Khronos, KTX File Format Specification 2.0; the descriptor of the
/// texels after the Khronos Data Format Specification 1.3.
namespace mirrorball::ktx2 {

bool hasSignature(std::string_view firstBytes);

enum class Compression { None, Zstandard };

/// The bytes of the file; smallest level first, as the format has them. KTXorientation and KTXwriter are added to the metadata.
/// @throws InvalidArgument for levels that do not fit together
std::string write(const Texture& texture, Compression compression = Compression::None);

/// Reads VkFormats 97, 109, 122 and 123, plain or Zstandard-compressed.
/// @param name  stands in messages
/// @throws FileError for damaged or foreign data
Texture read(std::string_view bytes, const std::string& name);

} // namespace mirrorball::ktx2
