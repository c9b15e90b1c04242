#pragma once

#include <glm/glm.hpp>

#include <span>
#include <vector>

/// What a reflectance over wavelengths looks like as RGB: the CIE 1931 2-degree observer in daylight D65.
namespace mirrorball {

/// The share of each sample of a spectrum in the three channels:
///   rgb = M integral S(lambda) R(lambda) (x, y, z)(lambda) d lambda,
/// S illuminant D65, (x, y, z) the observer, M from XYZ to linear Rec.709, and each channel over that of a perfect mirror, so that R = 1
/// is (1, 1, 1) exactly. Between the samples R is linear, beyond the first and the last it stays what it is there. A saturated spectrum
/// lies outside Rec.709: a channel may come out below 0.
/// @param wavelengths  nm, strictly increasing, at least one
/// @return one weight per sample; their sum is (1, 1, 1)
/// Source: CIE 15.2-1986 tables 1.1 and 2.1, 380 to 780 nm in steps of 5 nm; IEC 61966-2-1
std::vector<glm::dvec3> observerWeights(std::span<const double> wavelengths);

} // namespace mirrorball
