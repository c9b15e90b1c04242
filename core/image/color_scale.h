#pragma once

#include <glm/glm.hpp>

/// Colors for numbers: what a false-color picture and the scale beside it share. Encoded for a display (sRGB), each channel in [0, 1].
namespace mirrorball {

/// From dark to bright in even steps for the eye, t in [0, 1] (clamped): violet, blue, green, yellow.
/// Source: S. van der Walt, N. Smith, matplotlib's viridis (CC0), read at 10 points and joined by straight lines.
glm::vec3 falseColor(double t);

/// Two-sided, t in [-1, 1] (clamped): blue for negative, neutral dark gray at 0, orange for positive; equally light at both ends, and told
/// apart by eyes that cannot tell red from green.
glm::vec3 signedColor(double t);

} // namespace mirrorball
