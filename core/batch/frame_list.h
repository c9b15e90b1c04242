#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace mirrorball {

/// Frames in the words of render farms: "1-24", "1-100x5" (every fifth), "1-9,20,31-40".
/// @return ascending as written, each once. @throws InvalidArgument that says what is wrong, without naming a field
std::vector<int> parseFrames(const std::string& text);

/// `text` with every run of `#` as the frame's number, with zeros in front up to the length of the run, and `{frame}` as the bare number.
std::string withFrame(std::string_view text, int frame);
/// Whether withFrame() would change anything.
bool namesFrame(std::string_view text);

/// Every `mark` in `text` replaced by `word`.
std::string replacedAll(std::string text, std::string_view mark, std::string_view word);

} // namespace mirrorball
