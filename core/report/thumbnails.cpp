#include "thumbnails.h"

#include "core/base/error.h"
#include "core/image/color.h"
#include "core/image/image_io.h"
#include "core/image/reproject.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace mirrorball {

namespace {

Image imageIn(const MapLayout& layout, const EnvironmentMap& map)
{
    return layout == map.layout ? map.image : reproject(map, {.target = layout}).image;
}

/// Blue over white to red for -1 over 0 to 1: the ends and the middle of ColorBrewer's RdBu. In 33 steps, which a .png packs well.
glm::vec3 diverging(double value)
{
    constexpr std::array<glm::vec3, 5> anchors{glm::vec3(5, 48, 97), glm::vec3(67, 147, 195), glm::vec3(247, 247, 247),
                                               glm::vec3(214, 96, 77), glm::vec3(103, 0, 31)};
    const double stepped = std::round(16.0 * std::clamp(value, -1.0, 1.0)) / 16.0;
    const double at = 2.0 * (stepped + 1.0);
    const auto first = std::min<size_t>(static_cast<size_t>(at), 3);
    return glm::mix(anchors[first], anchors[first + 1], static_cast<float>(at - static_cast<double>(first))) / 255.0f;
}

double roundedUp(double value)
{
    if (!(value > 0.0) || !std::isfinite(value))
        return 1e-12;
    const double decade = std::pow(10.0, std::floor(std::log10(value)));
    for (const double step : {1.0, 2.0, 5.0})
        if (value <= step * decade * (1.0 + 1e-9))
            return step * decade;
    return 10.0 * decade;
}

} // namespace

std::string mapPicture(const EnvironmentMap& map, int height)
{
    const MapLayout latlong{.kind = Parameterization::Latlong, .size = height};
    return encodePng(toDisplay(imageIn(latlong, map), pictureExposure(map), ToneCurve::Filmic));
}

double pictureExposure(const EnvironmentMap& map)
{
    const double mean = luminance(meanRadiance(map));
    return mean > 0.0 && std::isfinite(mean) ? std::log2(0.25 / mean) : 0.0;
}

std::string texelPicture(const EnvironmentMap& map, double exposure)
{
    return encodePng(toDisplay(map.image, exposure, ToneCurve::Filmic));
}

ErrorPicture errorPicture(const EnvironmentMap& map, const EnvironmentMap& reference, const MapLayout& shown)
{
    if (map.layout != reference.layout)
        throw InvalidArgument("error picture: the two maps must have the same parameterization and size");
    EnvironmentMap difference = map;
    for (size_t i = 0; i < difference.image.texels.size(); ++i)
        difference.image.texels[i] -= reference.image.texels[i];
    const SolidAngles solidAngles(map.layout);
    double power = 0.0;
    for (int y = 0; y < map.image.height; ++y)
        for (int x = 0; x < map.image.width; ++x) {
            const float* rgb = reference.image.texel(x, y);
            const double value = luminance({rgb[0], rgb[1], rgb[2]});
            power += solidAngles.at(x, y) * value * value / (4.0 * pi);
        }
    const double rms = power > 0.0 ? std::sqrt(power) : 1.0;

    Image picture = imageIn(shown, difference);
    std::vector<double> signedError, sizes;
    for (size_t i = 0; i < picture.texels.size(); i += 3) {
        signedError.push_back(luminance({picture.texels[i], picture.texels[i + 1], picture.texels[i + 2]}) / rms);
        sizes.push_back(std::abs(signedError.back()));
    }
    const auto percentile = sizes.begin() + static_cast<std::ptrdiff_t>(0.995 * static_cast<double>(sizes.size()));
    std::nth_element(sizes.begin(), percentile, sizes.end());
    const double limit = roundedUp(*percentile);
    for (size_t i = 0; i < signedError.size(); ++i) {
        const glm::vec3 color = diverging(signedError[i] / limit);
        std::copy_n(&color.x, 3, &picture.texels[3 * i]);
    }
    return {encodePng(picture), limit};
}

std::string dataUri(const std::string& png)
{
    constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text = "data:image/png;base64,";
    for (size_t i = 0; i < png.size(); i += 3) {
        std::uint32_t bits = 0;
        for (size_t j = 0; j < 3; ++j)
            bits = bits << 8 | (i + j < png.size() ? static_cast<unsigned char>(png[i + j]) : 0u);
        for (size_t j = 0; j < 4; ++j)
            text += i + j > png.size() ? '=' : digits[bits >> (18 - 6 * j) & 63];
    }
    return text;
}

} // namespace mirrorball
