#pragma once

#include "color.h"

#include <glm/glm.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// The color spaces that files come in, and how they become linear Rec.709.
namespace mirrorball {

/// How stored values stand for light.
enum class TransferCurve { Linear, Srgb, Power, ProPhoto };

/// An RGB space: its curve and its primaries.
struct ColorSpace {
    std::string name{};
    TransferCurve curve = TransferCurve::Linear;
    double exponent = 1.0; ///< of Power: light = stored^exponent
    Chromaticities primaries{};
};

/// A space by its name: linear, srgb, gamma1.8, gamma2.2 and any other gammaN, display-p3, linear-p3, adobe-rgb, rec2020 (linear), acescg,
/// aces2065-1, prophoto. Empty for any other word. Sources: IEC 61966-2-1; SMPTE EG 432-1; Adobe RGB (1998), version 2005-05; ITU-R
/// BT.2020-2; Academy S-2014-004 and S-2008-001; ISO 22028-2 (ROMM RGB).
std::optional<ColorSpace> colorSpaceFromName(std::string_view word);

/// The names that colorSpaceFromName() knows, but for the gammas without end.
const std::vector<std::string>& colorSpaceNames();

/// The light of one stored value. Negative values, which float files hold, are mirrored: f(-x) = -f(x).
float toLight(float stored, const ColorSpace& space);

/// The matrix to Rec.709; none where the primaries are Rec.709's to 1e-3, as files round them. @throws InvalidArgument for no real
/// primaries
std::optional<glm::mat3> primariesToRec709(const ColorSpace& space);

} // namespace mirrorball
