#pragma once

#include "plan.h"

#include <sstream>
#include <string>

/// What the stages of a plan say.
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

/// What is promised of a filtered map before the probe is read, or what is predicted of it where nothing is; begins with "; ".
std::string promiseText(const PlannedFilter& filter);

/// "1 level", "3 levels"
std::string plural(int count, const std::string& thing);

/// The document of a sphere map where it is known without opening a file, else null.
const SphereMapDocument* documentAtHand(const SphereMapPlan& map);

/// Which sphere map it is and how its levels are made, as far as that is known without opening a file.
std::string sphereMapText(const SphereMapPlan& map);

/// The same of a map that is written.
std::string paintedText(const SphereMapPlan& map, const ExportTarget& target);

} // namespace mirrorball
