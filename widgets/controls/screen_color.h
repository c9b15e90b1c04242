#pragma once

#include "core/image/color.h"

#include <QColor>

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>

namespace mirrorball::studio {

/// Linear RGB as the screen shows it (sRGB), clamped.
inline QColor screenColor(const glm::dvec3& linear)
{
    const auto encode = [](double x) { return encodeSrgb(static_cast<float>(std::clamp(x, 0.0, 1.0))); };
    return QColor::fromRgbF(encode(linear.r), encode(linear.g), encode(linear.b));
}

} // namespace mirrorball::studio
