#pragma once

#include <functional>
#include <string>

namespace mirrorball {

/// What brings a color, in place, from a space of the OpenColorIO configuration that $OCIO names to linear Rec.709: through the
/// configuration's own name for that, or its interchange role aces_interchange.
/// @throws InvalidArgument, beginning with "color_space", when there is no such space or configuration
std::function<void(float* rgb)> ocioSpace(const std::string& name);

} // namespace mirrorball
