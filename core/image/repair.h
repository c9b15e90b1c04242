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
    std::int64_t negative = 0;   ///< finite values below 0
    std::int64_t clamped = 0;    ///< those of them that were set to 0
    std::int64_t filledRows = 0; ///< rows of a channel without a finite value

    std::int64_t nonFinite() const { return nan + positiveInfinity + negativeInfinity; }
    RepairReport& operator+=(const RepairReport& other);
    bool operator==(const RepairReport&) const = default;
};

/// What is wrong with a row, a bit a channel: no value of it is finite.
using DeadChannels = unsigned;

/// Mends one row of interleaved channels in place, but for channels without a finite value, which it only counts:
///   NaN    linear between the nearest finite values left and right in its channel, around the row's ends
///   +Inf   65504, the largest half: the infinities met in files are suns that overflowed half floats
///   -Inf   -65504, or 0 under Clamp
///   < 0    kept, or 0 under Clamp
DeadChannels repairRow(float* row, int width, int channels, NegativePolicy policy, RepairReport& report);

/// A value between those of the nearest rows above and below that have one, at these distances; null where there is no such row.
float betweenRows(const float* above, const float* below, int fromAbove, int toBelow);

/// Mends a whole image of any number of channels: each row as repairRow() does, and what has no finite value - stitched panoramas lack
/// their nadir - linear between the nearest rows above and below that have some; from one of them where there is no other, 0 where there is
/// none. RepairedReader (repaired_reader.h) does the same to a stream.
RepairReport repair(Image& image, NegativePolicy policy);

/// One line for the user: "12 NaN, 6 infinite values repaired; 5 negative values kept", or "no NaN, infinite or negative values".
std::string describe(const RepairReport& report);

} // namespace mirrorball
