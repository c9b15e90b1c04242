#pragma once

#include <string>
#include <vector>

/// Which rule the roughness of the levels of a map follows.
namespace mirrorball {

/// What was measured of one level.
struct MeasuredLevel {
    double roughness = 0.0;  ///< square root of alpha
    double unresolved = 0.0; ///< roughness that its texels cannot tell from 0
};

/// How well one rule fits.
struct LawFit {
    std::string name{};              ///< "filament", "babylon", "linear", ...; law words of roughness_law.h where there is one
    std::string owner{};             ///< "Filament and three.js"; may be empty
    std::string formula{};           ///< "r = 1 - sqrt(1 - l/4)": with the map's numbers
    std::vector<double> roughness{}; ///< that it asks of the levels
    double error = 0.0;              ///< rms of the difference in roughness, over the levels that a law says something of
};

/// Every known rule for a chain whose first level is `width` texels wide, the best first. A roughness law of roughness_law.h each, and:
/// 2i/11, which PlayCanvas' own generator filters with, and alpha = l/(n-1).
std::vector<LawFit> fitLaws(const std::vector<MeasuredLevel>& levels, int width);

/// The largest error that counts as following a law.
inline constexpr double lawTolerance = 0.03;

} // namespace mirrorball
