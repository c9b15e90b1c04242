#pragma once

#include "brush.h"
#include "symmetry.h"

#include <glm/glm.hpp>

#include <span>
#include <string>
#include <vector>

namespace mirrorball {

inline constexpr double mostTilt = 60.0; ///< degrees, either way: what pens report

/// One sample of a pen's way.
struct StrokePoint {
    glm::dvec2 q{0.0};     ///< on the disc (sphere/disc.h): x to the right, y up, |q| = 1 at the rim; a stroke may leave the disc
    double pressure = 1.0; ///< [0, 1]
    glm::dvec2 tilt{0.0};  ///< degrees from upright along x and y, [-mostTilt, mostTilt]; 0 also from pens that do not say
    bool operator==(const StrokePoint&) const = default;
};

/// What an artist drew in one go: a brush, how it repeats, and the way of the pen in the order of time. Not pixels: it can be evaluated
/// at any size of the map.
struct Stroke {
    Brush brush{};
    Symmetry symmetry{};
    std::vector<StrokePoint> points{}; ///< joined by straight lines; one point is one dab, none draws nothing
    UnknownKeys unknown{};
    bool operator==(const Stroke&) const = default;
};

inline constexpr double mostStrokes = 100000;               ///< in one list of strokes
inline constexpr size_t mostStrokePoints = size_t{1} << 20; ///< in one list of strokes
inline constexpr size_t mostDabs = size_t{1} << 21;         ///< in one list of strokes, symmetry included
inline constexpr double farthestPoint = 4.0;                ///< of a coordinate from the center, disc radii

/// Checks one stroke. @throws InvalidArgument naming point and field
void checkFields(const std::string& path, const Stroke& stroke);

/// @throws InvalidArgument naming stroke, point and field, for a number that is not finite or out of its range, too many points, and
/// strokes that would take more than mostDabs dabs
/// @param path  what the list is called in messages: "strokes"
void validate(std::span<const Stroke> strokes, const std::string& path = "strokes");

/// One touch of the tip, in disc radii.
struct Dab {
    glm::dvec2 q{0.0};
    glm::dvec2 motion{0.0}; ///< from the dab before it; 0 for the first
    double radius = 0.0;    ///< across the way that the pen leans
    double strength = 0.0;
    glm::dvec2 lean{0.0}; ///< see leanAt()
};

/// The dabs of a stroke with all its symmetric copies, independent of the size of the map: the drawn ones in order, then those of the
/// second copy, and so on.
struct StrokeDabs {
    std::vector<Dab> dabs{};
    size_t copies = 1;
    size_t touches() const { return dabs.size() / copies; }
};

/// Dabs lie `spacing` diameters apart along the way, the diameter being that under the pressure there; the first is on the first point. A
/// dab depends on nothing later in the stroke: lengthening a stroke only appends touches. Smudging takes steps of at most 1/10 of a
/// diameter, because it is a motion.
/// @throws InvalidArgument when there would be more than mostDabs
StrokeDabs strokeDabs(const Stroke& stroke);

} // namespace mirrorball
