#include "color_space.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>

namespace mirrorball {

namespace {

constexpr Chromaticities rec709{};
constexpr Chromaticities p3{{0.680, 0.320}, {0.265, 0.690}, {0.150, 0.060}, {0.3127, 0.3290}};
constexpr Chromaticities adobe{{0.64, 0.33}, {0.21, 0.71}, {0.15, 0.06}, {0.3127, 0.3290}};
constexpr Chromaticities rec2020{{0.708, 0.292}, {0.170, 0.797}, {0.131, 0.046}, {0.3127, 0.3290}};
constexpr Chromaticities ap1{{0.713, 0.293}, {0.165, 0.830}, {0.128, 0.044}, {0.32168, 0.33767}};
constexpr Chromaticities ap0{{0.7347, 0.2653}, {0.0, 1.0}, {0.0001, -0.0770}, {0.32168, 0.33767}};
constexpr Chromaticities romm{{0.7347, 0.2653}, {0.1596, 0.8404}, {0.0366, 0.0001}, {0.3457, 0.3585}};

const std::vector<ColorSpace>& spaces()
{
    static const std::vector<ColorSpace> all{{"linear", TransferCurve::Linear, 1.0, rec709},
                                             {"srgb", TransferCurve::Srgb, 1.0, rec709},
                                             {"gamma1.8", TransferCurve::Power, 1.8, rec709},
                                             {"gamma2.2", TransferCurve::Power, 2.2, rec709},
                                             {"display-p3", TransferCurve::Srgb, 1.0, p3},
                                             {"linear-p3", TransferCurve::Linear, 1.0, p3},
                                             {"adobe-rgb", TransferCurve::Power, 563.0 / 256.0, adobe},
                                             {"rec2020", TransferCurve::Linear, 1.0, rec2020},
                                             {"acescg", TransferCurve::Linear, 1.0, ap1},
                                             {"aces2065-1", TransferCurve::Linear, 1.0, ap0},
                                             {"prophoto", TransferCurve::ProPhoto, 1.8, romm}};
    return all;
}

} // namespace

std::optional<ColorSpace> colorSpaceFromName(std::string_view word)
{
    std::string wanted(word);
    std::transform(wanted.begin(), wanted.end(), wanted.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    for (const ColorSpace& space : spaces())
        if (space.name == wanted)
            return space;
    constexpr std::string_view gamma = "gamma";
    if (!wanted.starts_with(gamma))
        return std::nullopt;
    double exponent = 0.0;
    const char* const end = wanted.data() + wanted.size();
    const auto read = std::from_chars(wanted.data() + gamma.size(), end, exponent);
    if (read.ec != std::errc() || read.ptr != end || !(exponent >= 0.2 && exponent <= 10.0))
        return std::nullopt;
    return ColorSpace{wanted, TransferCurve::Power, exponent, rec709};
}

const std::vector<std::string>& colorSpaceNames()
{
    static const std::vector<std::string> names = [] {
        std::vector<std::string> all;
        for (const ColorSpace& space : spaces())
            all.push_back(space.name);
        return all;
    }();
    return names;
}

float toLight(float stored, const ColorSpace& space)
{
    const float size = std::abs(stored);
    float light = size;
    switch (space.curve) {
    case TransferCurve::Linear:
        return stored;
    case TransferCurve::Srgb:
        light = decodeSrgb(size);
        break;
    case TransferCurve::Power:
        light = static_cast<float>(std::pow(static_cast<double>(size), space.exponent));
        break;
    case TransferCurve::ProPhoto:
        light = size < 0.03125f ? size / 16.0f : static_cast<float>(std::pow(static_cast<double>(size), 1.8));
        break;
    }
    return std::copysign(light, stored);
}

std::optional<glm::mat3> primariesToRec709(const ColorSpace& space)
{
    const auto& c = space.primaries;
    const auto near = [](const glm::dvec2& a, const glm::dvec2& b) { return std::abs(a.x - b.x) < 1e-3 && std::abs(a.y - b.y) < 1e-3; };
    if (near(c.red, rec709.red) && near(c.green, rec709.green) && near(c.blue, rec709.blue) && near(c.white, rec709.white))
        return std::nullopt;
    return glm::mat3(toRec709(c));
}

} // namespace mirrorball
