#pragma once

#include "image.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <optional>
#include <string_view>

/// From scene-linear RGB to what a display shows, and from other RGB primaries to ours (Rec.709, D65).
namespace mirrorball {

/// Luminance of linear Rec.709 RGB: Y = 0.2126 R + 0.7152 G + 0.0722 B. Source: ITU-R BT.709-6, item 3.2.
inline double luminance(const glm::dvec3& rgb) { return 0.2126 * rgb.r + 0.7152 * rgb.g + 0.0722 * rgb.b; }

/// The sRGB transfer function: linear light in [0, 1] to the encoded value in [0, 1].
///   12.92 x for x <= 0.0031308, else 1.055 x^(1/2.4) - 0.055
/// Source: IEC 61966-2-1:1999, section 5.2.
float encodeSrgb(float linear);

/// The inverse of encodeSrgb(): x / 12.92 for x <= 0.04045, else ((x + 0.055) / 1.055)^2.4.
float decodeSrgb(float encoded);

/// How radiance of any size is brought into [0, 1], each channel by itself. The preview's shader has the same three.
///   none      min(x, 1)
///   reinhard  x / (1 + x)                                                     Reinhard et al. 2002, eq. 3
///   filmic    min(x (2.51 x + 0.03) / (x (2.43 x + 0.59) + 0.14), 1)          Narkowicz 2015, a fit of the ACES curve
enum class ToneCurve { None, Reinhard, Filmic };

/// "none", "reinhard", "filmic".
std::string_view name(ToneCurve curve);
/// The inverse of name(). Empty for any other word.
std::optional<ToneCurve> toneCurveFromName(std::string_view word);

/// The curve at x, in [0, 1] for every x: NaN and negative values give 0, +infinity gives 1.
float toneMapped(float x, ToneCurve curve);

/// The display picture of a linear image: encodeSrgb(toneMapped(2^exposureEv x)) of the first three channels, all in [0, 1].
/// A fourth channel is opacity and only clamped; the colors, which come multiplied by it, are divided by it first, because what is encoded
/// cannot be divided any more. So those of the display picture are not multiplied, as 8-bit files have them.
Image toDisplay(const Image& linear, double exposureEv, ToneCurve curve);

/// The nearest of 256 levels: round(255 x), with x clamped to [0, 1] and NaN taken as 0.
std::uint8_t toByte(float x);

/// The primaries and the white of an RGB space as CIE 1931 (x, y); the default is Rec.709 with D65.
struct Chromaticities {
    glm::dvec2 red{0.64, 0.33};
    glm::dvec2 green{0.30, 0.60};
    glm::dvec2 blue{0.15, 0.06};
    glm::dvec2 white{0.3127, 0.3290};
    bool operator==(const Chromaticities&) const = default;
};

/// The matrix M that takes linear RGB of the given primaries to linear Rec.709: rgb709 = M rgb. White goes to white (the Bradford
/// adaptation to D65); wide gamuts give negative values, which stay.
/// @throws InvalidArgument when the primaries are not finite, lie on a line, or the white has y = 0
/// Source: SMPTE RP 177-1993 for the primaries; Lam 1985 (CIECAM97 form) for the adaptation.
glm::dmat3 toRec709(const Chromaticities& from);

} // namespace mirrorball
