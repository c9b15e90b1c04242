#pragma once

#include "plan.h"

#include <sstream>
#include <string>

/// What a plan decided, in words.
namespace mirrorball {

/// All parts one after the other, numbers with three digits.
template <typename... Parts>
std::string text(const Parts&... parts)
{
    std::ostringstream stream;
    stream.precision(3);
    (stream << ... << parts);
    return stream.str();
}

/// "cube 64 x 384"
std::string sizeText(const MapLayout& layout);

/// "1 level", "3 levels"
std::string plural(int count, const std::string& thing);

/// The document of a sphere map where it is known without opening a file, else null.
const SphereMapDocument* documentAtHand(const SphereMapPlan& map);

/// Why a stage is made or left out, in a line.
std::string inWords(const Decision& decision);

} // namespace mirrorball
