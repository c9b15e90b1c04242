#pragma once

#include "core/filter/lobe.h"

#include <string_view>
#include <vector>

namespace mirrorball {

/// The inverse of describe(): "phong:50" is the exponent, "ggx:0.09" alpha (roughness squared), "diffuse" has no number.
/// @throws InvalidArgument that shows the word and the three forms
Lobe lobeFromWord(std::string_view word);

/// A list with commas: "phong:50,ggx:0.3,diffuse". @throws InvalidArgument, also for an empty one
std::vector<Lobe> lobesFromWords(std::string_view list);

/// Parts of a text between separators; an empty text has one empty part.
std::vector<std::string_view> split(std::string_view text, char separator);

} // namespace mirrorball
