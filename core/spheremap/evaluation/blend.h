#pragma once

#include "core/spheremap/math/span.h"

#include <span>
#include <string_view>

/// How a layer meets what lies below it.
namespace mirrorball {

enum class BlendMode { Normal, Multiply, Screen, Add, Overlay, SoftLight, Darken, Lighten };

/// The words of files and forms, in the order of the values: normal multiply screen add overlay soft-light darken lighten.
std::span<const std::string_view> words(BlendMode);

/// B(b, s), each channel by itself, for a backdrop b and a source s that are linear light of any size:
///   normal      s
///   multiply    b s
///   screen      b + s - min(b, 1) min(s, 1)               so that light never takes light away: it is at least max(b, s)
///   add         b + s
///   overlay     with x = sqrt(b), y = sqrt(s), squared:   2 x y for x < 1/2, else screen(2x - 1, y)
///   soft-light  with x = sqrt(min(b, 1)), y = sqrt(min(s, 1)), squared, plus max(b - 1, 0):
///               x - (1 - 2y) x (1 - x) for y <= 1/2, else x + (2y - 1)(d(x) - x), d(x) = ((16x - 12) x + 4) x for x <= 1/4, else sqrt(x)
///   darken      min(b, s)
///   lighten     max(b, s)
/// Overlay and soft light turn about a middle gray, which in linear light is not 1/2: the square root puts it at 1/4. Where b and s are in
/// [0, 1] these are the W3C's definitions (the last two on square roots); above, all stay continuous and never fall as b or s rise.
/// Negative colors count as 0 except in normal and add.
/// Source: W3C Compositing and Blending Level 1, section 10.
float blended(BlendMode mode, float backdrop, float source);

/// Lays a source over a backdrop:
///   C = (1 - as) Cb + as (1 - ab) s + as ab B(Cb / ab, s),  a = as + ab - as ab
/// @param source    colors not multiplied by their opacity as
/// @param backdrop  colors Cb multiplied by their opacity ab; becomes the result
/// Source: the same, section 5.
void blend(BlendMode mode, int count, const ColorSpan& source, ColorSpan& backdrop);

} // namespace mirrorball
