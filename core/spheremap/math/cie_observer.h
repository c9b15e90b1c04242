#pragma once

#include <glm/glm.hpp>

#include <cmath>

namespace mirrorball {

/// The CIE 1931 2-degree observer at a wavelength in nm: X, Y, Z. A sum of Gaussians with two widths each, within 1 % of the tables' peak.
/// Source: Wyman, Sloan, Shirley, "Simple Analytic Approximations to the CIE XYZ Color Matching Functions", JCGT 2(2), 2013, eq. 4.
inline glm::dvec3 cieObserver(double wavelength)
{
    const auto lobe = [wavelength](double peak, double below, double above) {
        const double t = (wavelength - peak) / (wavelength < peak ? below : above);
        return std::exp(-0.5 * t * t);
    };
    return {1.056 * lobe(599.8, 37.9, 31.0) + 0.362 * lobe(442.0, 16.0, 26.7) - 0.065 * lobe(501.1, 20.4, 26.2),
            0.821 * lobe(568.8, 46.9, 40.5) + 0.286 * lobe(530.9, 16.3, 31.1),
            1.217 * lobe(437.0, 11.8, 36.0) + 0.681 * lobe(459.0, 26.0, 13.8)};
}

/// CIE XYZ to linear Rec.709. Spectral colors lie outside its gamut: channels come out negative. Source: IEC 61966-2-1.
inline glm::dvec3 rec709FromXyz(const glm::dvec3& xyz)
{
    return {3.2406 * xyz.x - 1.5372 * xyz.y - 0.4986 * xyz.z, -0.9689 * xyz.x + 1.8758 * xyz.y + 0.0415 * xyz.z,
            0.0557 * xyz.x - 0.2040 * xyz.y + 1.0570 * xyz.z};
}

} // namespace mirrorball
