#pragma once

#include <string>
#include <string_view>

namespace mirrorball {

/// The script, scene or page that loads the files of a profile, with the export's name filled in. Empty for a profile without one.
/// @param word  the profile's
/// @param name  of the export; letters, digits, - and _
std::string engineSnippet(std::string_view word, std::string_view name);

} // namespace mirrorball
