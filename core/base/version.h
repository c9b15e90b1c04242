#pragma once

#include <string_view>

namespace mirrorball {

/// The version of this build, "0.1.0": what side-cars name.
std::string_view version();

} // namespace mirrorball
