#pragma once

#include "environment_map.h"

#include <array>

namespace mirrorball {

/// How a map is read between its texels' centers.
enum class Resample {
    Linear, ///< bilinear
    Cubic,  ///< Keys' cubic convolution through the 4 x 4 texels around, held within the range of the four nearest: sharper, no ringing
};

/// Keys' weights of the texels at -1, 0, 1, 2 from the one at or before a place, which is f in [0, 1) of a texel past it; their sum is 1.
std::array<float, 4> keysWeights(double f);

/// The radiance in direction d, which need not be normalized. Seamless. Cubic asks for a map of size 4; smaller ones are read bilinearly.
/// Source: R. Keys, Cubic Convolution Interpolation for Digital Image Processing, IEEE Trans. ASSP 29 (1981), with a = -1/2.
glm::vec3 lookUp(const EnvironmentMap& map, const glm::dvec3& d, Resample resample);
/// The same in many directions (x[i], y[i], z[i]): rgb[3 i].
void lookUp(const EnvironmentMap& map, size_t count, const double* x, const double* y, const double* z, Resample resample, float* rgb);

} // namespace mirrorball
