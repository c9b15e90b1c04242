#include "brush.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace mirrorball {

std::span<const std::string_view> words(BrushMode)
{
    static constexpr std::array<std::string_view, 3> list{"paint", "erase", "smudge"};
    return list;
}

double radiusAt(const Brush& brush, double pressure)
{
    return brush.radius * std::max(1.0 - brush.pressureRadius * (1.0 - pressure), 1.0 / 32.0);
}

double strengthAt(const Brush& brush, double pressure) { return brush.flow * (1.0 - brush.pressureFlow * (1.0 - pressure)); }

glm::dvec2 leanAt(const Brush& brush, const glm::dvec2& tiltDeg)
{
    const glm::dvec2 slope = glm::tan(glm::radians(tiltDeg));
    const double slope2 = glm::dot(slope, slope);
    const double stretch = 1.0 + brush.tilt * (std::sqrt(1.0 + slope2) - 1.0);
    if (!(stretch > 1.0))
        return glm::dvec2(0.0);
    return slope * std::sqrt((1.0 - 1.0 / (stretch * stretch)) / slope2);
}

DabProfile dabProfile(double radius, double hardness, double strength)
{
    double middle2 = 0.5 * (1.0 + hardness * hardness) * radius * radius;
    double half2 = 0.5 * (1.0 - hardness * hardness) * radius * radius;
    if (middle2 < 1.0) {
        strength *= middle2;
        middle2 = half2 = 1.0;
    }
    half2 = std::min(std::max(half2, std::sqrt(middle2)), middle2); // (m + 1/2)^2 - (m - 1/2)^2 = 2 m: one texel
    return {static_cast<float>(middle2 + half2), static_cast<float>(0.5 / half2), static_cast<float>(strength)};
}

} // namespace mirrorball
