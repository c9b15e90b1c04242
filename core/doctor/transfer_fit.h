#pragma once

#include "core/image/image.h"

#include <string_view>

/// Whether the values of a map are radiance, or went through a curve.
namespace mirrorball {

enum class Transfer {
    Linear,
    SrgbEncoded,  ///< values are sRGB-encoded, or radiance^(1/2.2)
    SrgbDecoded,  ///< radiance was decoded as if it were sRGB: radiance^2.2
    Reinhard,     ///< x/(1+x), ...
    ReinhardSrgb, ///< ... then sRGB
    Filmic,       ///< Narkowicz' curve (color.h), ...
    FilmicSrgb,   ///< ... then sRGB
    Clipped,      ///< min(x, 1), ...
    ClippedSrgb   ///< ... then sRGB
};

/// A few words: "linear", "sRGB-encoded", ...
std::string_view name(Transfer transfer);
/// Whether undo() gives the radiance back, but for a factor.
bool isReversible(Transfer transfer);
/// The value that the curve makes of `x`, negative taken as 0; sRGB goes on above 1.
double transferred(double x, Transfer transfer);
/// The inverse of the reversible ones.
Image undone(const Image& map, Transfer transfer);

struct TransferFit {
    Transfer transfer = Transfer::Linear;
    double exposure = 1.0;    ///< the truth is multiplied by it before the curve
    double error = 0.0;       ///< mean absolute difference of logarithms, of the curve
    double linearError = 0.0; ///< that of a factor alone
};

/// The curve that makes `map` of `truth` best, both N x 6N or any size alike; anything but Linear only where it fits clearly better.
TransferFit fitTransfer(const Image& map, const Image& truth);

/// Pictures of height 6 N or N averaged by whole blocks of texels to a face edge of at most `edge`.
Image averaged(const Image& image, int charts, int edge);

} // namespace mirrorball
