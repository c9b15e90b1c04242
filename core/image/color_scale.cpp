#include "color_scale.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace mirrorball {

namespace {

constexpr std::array<std::uint32_t, 10> viridis{0x440154, 0x482878, 0x3E4A89, 0x31688E, 0x26828E,
                                                0x1F9E89, 0x35B779, 0x6DCD59, 0xB4DE2C, 0xFDE725};
/// -1, -1/2, 0, 1/2, 1; in the same lightness pairwise.
constexpr std::array<std::uint32_t, 5> blueToOrange{0x74C7FF, 0x2F6FB0, 0x2B2B2B, 0xB0632A, 0xFFB469};

glm::vec3 fromHex(std::uint32_t rgb) { return glm::vec3((rgb >> 16) & 0xff, (rgb >> 8) & 0xff, rgb & 0xff) / 255.0f; }

template <size_t count>
glm::vec3 between(const std::array<std::uint32_t, count>& colors, double t)
{
    const double at = (t >= 0.0 ? std::min(t, 1.0) : 0.0) * (count - 1); // NaN is 0
    const size_t i = std::min(static_cast<size_t>(at), count - 2);
    return glm::mix(fromHex(colors[i]), fromHex(colors[i + 1]), static_cast<float>(at - static_cast<double>(i)));
}

} // namespace

glm::vec3 falseColor(double t) { return between(viridis, t); }

glm::vec3 signedColor(double t) { return between(blueToOrange, std::isnan(t) ? 0.5 : 0.5 * (t + 1.0)); }

} // namespace mirrorball
