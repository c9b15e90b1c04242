#pragma once

#include <glm/glm.hpp>

#include <cmath>

/// Oklab: a space in which equal steps look about equally large, for mixing colors. L is lightness, a green to red, b blue to yellow.
/// Source: B. Ottosson, "A perceptual color space for image processing" (2020), with its matrices for linear Rec.709 (sRGB) primaries.
namespace mirrorball::oklab {

/// Linear Rec.709 to Oklab. Any real numbers: cube roots keep their sign, so HDR and wide-gamut colors survive the round trip.
inline glm::dvec3 fromLinear(const glm::dvec3& c)
{
    const double l = std::cbrt(0.4122214708 * c.r + 0.5363325363 * c.g + 0.0514459929 * c.b);
    const double m = std::cbrt(0.2119034982 * c.r + 0.6806995451 * c.g + 0.1073969566 * c.b);
    const double s = std::cbrt(0.0883024619 * c.r + 0.2817188376 * c.g + 0.6299787005 * c.b);
    return {0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s, 1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s,
            0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s};
}

/// The inverse.
inline glm::dvec3 toLinear(const glm::dvec3& lab)
{
    const auto cube = [](double x) { return x * x * x; };
    const double l = cube(lab.x + 0.3963377774 * lab.y + 0.2158037573 * lab.z);
    const double m = cube(lab.x - 0.1055613458 * lab.y - 0.0638541728 * lab.z);
    const double s = cube(lab.x - 0.0894841775 * lab.y - 1.2914855480 * lab.z);
    return {4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s, -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
            -0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s};
}

/// Both colors mixed in Oklab, back in linear light and not below 0.
inline glm::dvec3 mixed(const glm::dvec3& from, const glm::dvec3& to, double t)
{
    return glm::max(toLinear(glm::mix(fromLinear(from), fromLinear(to), t)), glm::dvec3(0.0));
}

} // namespace mirrorball::oklab
