#pragma once

#include <string>
#include <string_view>

namespace mirrorball {

/// A word as a POSIX shell takes it: as it is where that is safe, else in single quotes. Any bytes survive but NUL.
std::string shellWord(std::string_view word);

} // namespace mirrorball
