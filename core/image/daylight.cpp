#include "daylight.h"

#include <algorithm>
#include <cmath>

namespace mirrorball {

namespace {

using glm::dvec3;

// Daylight after A. J. Preetham, P. Shirley, B. Smits, "A Practical Analytic Model for Daylight", SIGGRAPH 1999. Luminance Y (in
// kcd/m^2) and chromaticities x, y of the sky follow the five-parameter distribution of Perez et al. 1993 (Preetham's eq. 3),
//   F(theta, gamma) = (1 + A e^(B / cos theta)) (1 + C e^(D gamma) + E cos^2 gamma),
// relative to the zenith (eq. 4): Y = Y_z F(theta, gamma) / F(0, theta_s), and x and y alike. theta is the angle from the zenith,
// gamma the angle from the sun, theta_s the sun's angle from the zenith. The coefficients, linear in the turbidity T, and the zenith
// values are those of the paper's appendix A.2.
//
// The sun. Outside the atmosphere it gives 133 klx (Darula, Kittler, Gueymard 2005) with the color of a 5778 K black body, in
// Rec.709 (1.113, 0.975, 0.912) for luminance 1. On its way down it is dimmed by air molecules, aerosol and ozone (appendix A.1):
//   exp(-m (0.008735 w^-4.08 + beta w^-1.3 + 0.35 k_o)),   beta = 0.04608 T - 0.04586,
//   m = 1 / (cos theta_s + 0.15 (93.885 - theta_s in degrees)^-1.253),
// with w the wavelength in micrometres and k_o ozone's coefficient; here at 0.611, 0.549 and 0.464, the dominant wavelengths of
// Rec.709's primaries. For T = 2.5 at an elevation of 35 degrees m = 1.739 and (0.660, 0.612, 0.507) of R, G, B are left: 82 klx.
// Over the disc's solid angle 2 pi (1 - cos 0.2665 deg) = 6.797e-5 sr that is a luminance of 1.21e6 kcd/m^2. The zenith has
// 4.8 kcd/m^2: the ratio is 250 000. One unit of ours is 10 kcd/m^2, so the zenith is 0.48, the sun 1.2e5, a white card 1.9.

constexpr double skyTurbidity = 2.5;
constexpr double sunElevation = 35.0 * pi / 180.0;
constexpr double sunLongitude = 40.0 * pi / 180.0;
constexpr double kcdPerUnit = 10.0;

struct Perez {
    double a, b, c, d, e;
    double operator()(double cosTheta, double gamma, double cosGamma) const
    {
        return (1.0 + a * std::exp(b / cosTheta)) * (1.0 + c * std::exp(d * gamma) + e * cosGamma * cosGamma);
    }
};

/// Everything about the sky that does not depend on the direction.
struct Sky {
    dvec3 sun{}; ///< direction
    dvec3 sunRadiance{};
    Perez luminance{}, x{}, y{};
    dvec3 scale{};  ///< zenith value over F(0, theta_s): luminance, x, y
    dvec3 ground{}; ///< radiance of the lit ground

    Sky();
    dvec3 radianceAbove(const dvec3& d) const;
};

Sky::Sky()
{
    constexpr double t = skyTurbidity;
    constexpr double s = pi / 2 - sunElevation; // theta_s
    sun = directionFromLonLat(sunLongitude, sunElevation);

    luminance = {0.1787 * t - 1.4630, -0.3554 * t + 0.4275, -0.0227 * t + 5.3251, 0.1206 * t - 2.5771, -0.0670 * t + 0.3703};
    x = {-0.0193 * t - 0.2592, -0.0665 * t + 0.0008, -0.0004 * t + 0.2125, -0.0641 * t - 0.8989, -0.0033 * t + 0.0452};
    y = {-0.0167 * t - 0.2608, -0.0950 * t + 0.0092, -0.0079 * t + 0.2102, -0.0441 * t - 1.6537, -0.0109 * t + 0.0529};
    const double chi = (4.0 / 9.0 - t / 120.0) * (pi - 2.0 * s);
    const double zenithLuminance = (4.0453 * t - 4.9710) * std::tan(chi) - 0.2155 * t + 2.4192;
    const double zenithX = t * t * (0.00166 * s * s * s - 0.00375 * s * s + 0.00209 * s) +
                           t * (-0.02903 * s * s * s + 0.06377 * s * s - 0.03202 * s + 0.00394) +
                           (0.11693 * s * s * s - 0.21196 * s * s + 0.06052 * s + 0.25886);
    const double zenithY = t * t * (0.00275 * s * s * s - 0.00610 * s * s + 0.00317 * s) +
                           t * (-0.04214 * s * s * s + 0.08970 * s * s - 0.04153 * s + 0.00516) +
                           (0.15346 * s * s * s - 0.26756 * s * s + 0.06670 * s + 0.26688);
    const double c = std::cos(s);
    scale = {zenithLuminance / kcdPerUnit / luminance(1.0, s, c), zenithX / x(1.0, s, c), zenithY / y(1.0, s, c)};

    const double beta = 0.04608 * t - 0.04586;
    const double airMass = 1.0 / (c + 0.15 * std::pow(93.885 - s * 180.0 / pi, -1.253));
    const dvec3 wavelength(0.611, 0.549, 0.464), ozone(0.120, 0.085, 0.007), outside = 133.0 * dvec3(1.113, 0.975, 0.912);
    const double solidAngle = 2.0 * pi * (1.0 - std::cos(skySunRadius));
    for (int i = 0; i < 3; ++i) {
        const double depth = 0.008735 * std::pow(wavelength[i], -4.08) + beta * std::pow(wavelength[i], -1.3) + 0.35 * ozone[i];
        sunRadiance[i] = outside[i] * std::exp(-airMass * depth) / solidAngle / kcdPerUnit;
    }

    // The ground is a diffuse plane: radiance = albedo / pi times the irradiance of sun and sky, the latter by the midpoint rule.
    dvec3 irradiance = sunRadiance * solidAngle * sun.y;
    constexpr int rows = 24, columns = 48;
    for (int i = 0; i < rows; ++i)
        for (int j = 0; j < columns; ++j) {
            const double sinLat = (i + 0.5) / rows;
            irradiance += radianceAbove(directionFromLonLat((j + 0.5) * 2.0 * pi / columns, std::asin(sinLat))) * sinLat *
                          (2.0 * pi / (rows * columns));
        }
    ground = dvec3(0.150, 0.152, 0.105) * irradiance / pi;
}

/// The sky's own radiance, without the sun's disc; d.y >= 0.
dvec3 Sky::radianceAbove(const dvec3& d) const
{
    const double cosTheta = std::max(d.y, 1e-3); // e^(B / cos theta) has gone to 0 by then
    const double cosGamma = std::clamp(glm::dot(d, sun), -1.0, 1.0);
    const double gamma = std::acos(cosGamma);
    const double bigY = scale[0] * luminance(cosTheta, gamma, cosGamma);
    const double cx = scale[1] * x(cosTheta, gamma, cosGamma);
    const double cy = scale[2] * y(cosTheta, gamma, cosGamma);
    const double bigX = bigY * cx / cy, bigZ = bigY * (1.0 - cx - cy) / cy;
    // XYZ to linear Rec.709 (D65). Source: IEC 61966-2-1:1999, section 5.2.
    return glm::max(dvec3(3.2406 * bigX - 1.5372 * bigY - 0.4986 * bigZ, -0.9689 * bigX + 1.8758 * bigY + 0.0415 * bigZ,
                          0.0557 * bigX - 0.2040 * bigY + 1.0570 * bigZ),
                    0.0);
}

const Sky& sky()
{
    static const Sky theSky;
    return theSky;
}

} // namespace

dvec3 skyWithoutSun(const dvec3& d)
{
    const Sky& s = sky();
    if (d.y >= 0.0)
        return s.radianceAbove(d);
    const double haze = std::exp(d.y / 0.035);
    if (haze < 1e-6)
        return s.ground;
    const dvec3 horizon(d.x, 0.0, d.z);
    return glm::mix(s.ground, s.radianceAbove(glm::normalize(horizon)), haze);
}

dvec3 skyRadiance(const dvec3& d)
{
    const dvec3 own = skyWithoutSun(d);
    // The chord 2 sin(r/2) tells the tiny angle better than the cosine does.
    const bool inDisc = glm::length(d - sky().sun) <= 2.0 * std::sin(0.5 * skySunRadius);
    return inDisc ? own + sky().sunRadiance : own;
}

dvec3 skySunDirection() { return sky().sun; }

dvec3 skySunRadiance() { return sky().sunRadiance; }

} // namespace mirrorball
