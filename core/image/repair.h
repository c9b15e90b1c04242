#pragma once

#include "image.h"

#include <cstdint>
#include <string>

namespace mirrorball {

/// Negative values are legitimate where a wide gamut was brought to Rec.709; lossy compression leaves them too.
enum class NegativePolicy { Keep, Clamp };

/// What repair() found, counted in channel values of the input.
struct RepairReport {
    std::int64_t nan = 0;
    std::int64_t positiveInfinity = 0;
    std::int64_t negativeInfinity = 0;
    std::int64_t negative = 0; ///< finite values below 0
    std::int64_t clamped = 0;  ///< those of them that were set to 0

    std::int64_t nonFinite() const { return nan + positiveInfinity + negativeInfinity; }
    RepairReport& operator+=(const RepairReport& other);
    bool operator==(const RepairReport&) const = default;
};

/// Mends rows of RGB in place. The rule looks at one row only, so streaming a file and reading it whole agree exactly:
///   NaN    linear between the nearest finite values left and right in its channel, around the row's ends; 0 if the row has none
///   +Inf   65504, the largest half: the infinities met in files are suns that overflowed half floats
///   -Inf   -65504, or 0 under Clamp
///   < 0    kept, or 0 under Clamp
RepairReport repairRows(float* rgb, int width, int rows, NegativePolicy policy);

/// The same for a whole image of any number of channels.
RepairReport repair(Image& image, NegativePolicy policy);

/// One line for the user: "12 NaN, 6 infinite values repaired; 5 negative values kept", or "no NaN, infinite or negative values".
std::string describe(const RepairReport& report);

} // namespace mirrorball
