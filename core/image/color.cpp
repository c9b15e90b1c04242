#include "color.h"

#include "core/base/error.h"
#include "core/base/job.h"

#include <algorithm>
#include <cmath>

namespace mirrorball {

float encodeSrgb(float linear) { return linear <= 0.0031308f ? 12.92f * linear : 1.055f * std::pow(linear, 1.0f / 2.4f) - 0.055f; }

float decodeSrgb(float encoded) { return encoded <= 0.04045f ? encoded / 12.92f : std::pow((encoded + 0.055f) / 1.055f, 2.4f); }

std::string_view name(ToneCurve curve)
{
    switch (curve) {
    case ToneCurve::None:
        return "none";
    case ToneCurve::Reinhard:
        return "reinhard";
    case ToneCurve::Filmic:
        return "filmic";
    }
    return {};
}

std::optional<ToneCurve> toneCurveFromName(std::string_view word)
{
    for (const ToneCurve curve : {ToneCurve::None, ToneCurve::Reinhard, ToneCurve::Filmic})
        if (word == name(curve))
            return curve;
    return {};
}

float toneMapped(float x, ToneCurve curve)
{
    if (!(x > 0.0f)) // NaN as well
        return 0.0f;
    x = std::min(x, 1e9f); // all three curves are flat to float precision by then, and x^2 stays finite
    switch (curve) {
    case ToneCurve::None:
        break;
    case ToneCurve::Reinhard:
        x = x / (1.0f + x);
        break;
    case ToneCurve::Filmic:
        x = x * (2.51f * x + 0.03f) / (x * (2.43f * x + 0.59f) + 0.14f);
        break;
    }
    return std::min(x, 1.0f);
}

Image toDisplay(const Image& linear, double exposureEv, ToneCurve curve)
{
    Image display(linear.width, linear.height, linear.channels);
    const double scale = std::exp2(exposureEv);
    parallelRows(linear.height, {}, [&](int first, int last) {
        for (size_t i = linear.index(0, first); i < linear.index(0, last); ++i) {
            const bool isOpacity = linear.channels == 4 && i % 4 == 3;
            const float opacity = linear.channels == 4 ? linear.texels[i - i % 4 + 3] : 1.0f;
            const double light = opacity > 0.0f && opacity < 1.0f ? linear.texels[i] / static_cast<double>(opacity) : linear.texels[i];
            display.texels[i] =
                isOpacity ? toneMapped(opacity, ToneCurve::None) : encodeSrgb(toneMapped(static_cast<float>(scale * light), curve));
        }
    });
    return display;
}

std::uint8_t toByte(float x) { return static_cast<std::uint8_t>(255.0f * toneMapped(x, ToneCurve::None) + 0.5f); }

namespace {

glm::dvec3 xyz(const glm::dvec2& xy) { return {xy.x, xy.y, 1.0 - xy.x - xy.y}; }

/// RGB to XYZ with Y = 1 for white: the columns are the primaries, scaled so that R = G = B = 1 is the white (RP 177, eq. 3.3.6).
glm::dmat3 rgbToXyz(const Chromaticities& c)
{
    const glm::dmat3 primaries(xyz(c.red), xyz(c.green), xyz(c.blue));
    const glm::dvec3 amounts = glm::inverse(primaries) * (xyz(c.white) / c.white.y);
    return {primaries[0] * amounts.r, primaries[1] * amounts.g, primaries[2] * amounts.b};
}

} // namespace

glm::dmat3 toRec709(const Chromaticities& from)
{
    const double area = glm::determinant(glm::dmat3(xyz(from.red), xyz(from.green), xyz(from.blue)));
    const glm::dvec2 sum = from.red + from.green + from.blue + from.white;
    if (!std::isfinite(sum.x) || !std::isfinite(sum.y) || std::abs(area) < 1e-9 || std::abs(from.white.y) < 1e-9)
        throw InvalidArgument("chromaticities: the primaries must span a triangle and the white must have y > 0; correct the file's "
                              "chromaticities or remove them to have Rec.709");
    const Chromaticities rec709;
    if (from == rec709)
        return glm::dmat3(1.0);

    // Bradford: scale the cone responses of the white seen to those of D65. Columns, as GLM has them.
    const glm::dmat3 cone({0.8951, -0.7502, 0.0389}, {0.2664, 1.7135, -0.0685}, {-0.1614, 0.0367, 1.0296});
    const glm::dvec3 seen = cone * (xyz(from.white) / from.white.y);
    const glm::dvec3 wanted = cone * (xyz(rec709.white) / rec709.white.y);
    const glm::dvec3 gain = wanted / seen;
    const glm::dmat3 scale({gain.x, 0, 0}, {0, gain.y, 0}, {0, 0, gain.z});
    return glm::inverse(rgbToXyz(rec709)) * glm::inverse(cone) * scale * cone * rgbToXyz(from);
}

} // namespace mirrorball
