#pragma once

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

/// How radiance is packed into few bits: floats with few bits, floats that share an exponent, and 8-bit colors with a multiplier in
/// alpha. Every encoder takes any number: NaN and negative values become 0, values out of range the largest one.
namespace mirrorball {

/// IEEE 754 half, to nearest even; clamped to +-65504.
std::uint16_t packHalf(float value);
float unpackHalf(std::uint16_t bits);

/// Three unsigned floats of 5 exponent bits: red in bits 0-10 and green in 11-21 with 6 bits of mantissa, blue in 22-31 with 5. To nearest.
/// Largest 65024, 65024, 64512. Source: Khronos Data Format 1.3, sections 10.3 and 10.4
std::uint32_t packR11G11B10(const glm::vec3& rgb);
glm::vec3 unpackR11G11B10(std::uint32_t bits);

/// Three mantissas of 9 bits and one exponent of 5, in bits 27-31. Largest 65408. Source: EXT_texture_shared_exponent
std::uint32_t packE5B9G9R9(const glm::vec3& rgb);
glm::vec3 unpackE5B9G9R9(std::uint32_t bits);

using Rgba8 = std::array<std::uint8_t, 4>; ///< straight alpha

/// Which multiplier an 8-bit texel carries, and what becomes of its colors. With m the byte a / 255:
///   Rgbe  rgb8 2^(a - 136), Ward's
///   Rgbm  (8 m rgb)^2                      PlayCanvas; range 64
///   Rgbd  (rgb^2.2) / m                    Babylon.js; range 255, at most 255 / 1
///   Rgbp  ((8 - 7 m) rgb)^2                PlayCanvas; range 64
enum class PackedColor { Rgbe, Rgbm, Rgbd, Rgbp };
std::span<const std::string_view> words(PackedColor); // rgbe rgbm rgbd rgbp

Rgba8 packColor(PackedColor form, const glm::vec3& rgb);
glm::vec3 unpackColor(PackedColor form, const Rgba8& texel);
/// The largest value of a channel that the form holds.
float largestValue(PackedColor form);

} // namespace mirrorball
