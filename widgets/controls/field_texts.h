#pragma once

#include <set>
#include <string>

namespace mirrorball::studio {

/// The words of core that forms show: names, help and units of all fields of a scene and of a sphere map, the words of their enums, what
/// presets and kinds of layers are called. lupdate finds them in a file that studio_field_texts writes of this.
std::set<std::string> fieldTexts();

} // namespace mirrorball::studio
