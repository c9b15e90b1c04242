#pragma once

#include <QColor>
#include <QString>

#include <glm/glm.hpp>

#include <optional>

/// A linear color as people choose it: what a screen can show, and how much brighter it is than that.
namespace mirrorball::studio {

struct ColorParts {
    QColor shown{};  ///< sRGB
    double ev = 0.0; ///< stops above what the screen shows: 0 or more

    bool operator==(const ColorParts&) const = default;
};
/// The largest channel of what is shown is at most 1. @param linear  Rec.709, each channel 0 or more
ColorParts colorParts(const glm::dvec3& linear);
/// Linear Rec.709: the decoded color times 2^ev, rounded to 5 digits behind the point.
glm::dvec3 linearColor(const ColorParts& parts);

/// "#ed9961" of what is shown.
QString hexText(const ColorParts& parts);
/// Of "#ed9961", "ed9961" or "#e96". Nothing where the text is none of them.
std::optional<QColor> colorOfHex(const QString& text);

/// The color of a black body, linear Rec.709, its largest channel 1, none below 0.
/// @param kelvin  1667 to 25000
/// Source: Kim et al., US patent 7024034 (2006), cubic fits of the Planckian locus in CIE 1931 xy; IEC 61966-2-1 for the matrix
glm::dvec3 blackBody(double kelvin);

} // namespace mirrorball::studio
