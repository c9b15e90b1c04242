#pragma once

#include "image.h"

#include <string_view>

/// Words inside of pictures, where there is no window system that would draw them.
namespace mirrorball {

inline constexpr int textHeight = 9;  ///< dots of a line: one above, seven of a capital, one of a descender
inline constexpr int letterWidth = 6; ///< dots from one letter to the next

/// A line of text, 5 x 7 dots a letter, each dot `scale` x `scale` pixels: one channel, 1 where there is ink.
/// @param text   printable ASCII; every other byte becomes a box
/// @param scale  at least 1
/// @return letterWidth * scale * letters by textHeight * scale; one pixel wide without a letter
Image textPicture(std::string_view text, int scale);

} // namespace mirrorball
