#pragma once

#include "texture.h"

#include <string>
#include <string_view>

/// KTX 1 (.ktx), as Filament loads its lights. Source: Khronos, KTX File Format Specification 1.0.
namespace mirrorball::ktx1 {

bool hasSignature(std::string_view firstBytes);

/// What stands in the header as glType of R11F_G11F_B10F.
enum class SmallFloatType {
    Khronos, ///< 0x8C3B, UNSIGNED_INT_10F_11F_11F_REV, as the specification says
    Filament ///< 0x8C3A, the internal format's own number, without which Filament's reader aborts
};

/// The bytes of the file: level by level, largest first, faces in order; metadata as key and value.
/// @throws InvalidArgument for levels that do not fit together
std::string write(const Texture& texture, SmallFloatType smallFloats = SmallFloatType::Khronos);

/// Reads R16F, R32F (three or four channels) and R11F_G11F_B10F; both glTypes of the latter.
/// @param name  stands in messages
/// @throws FileError for damaged or foreign data
Texture read(std::string_view bytes, const std::string& name);

} // namespace mirrorball::ktx1
