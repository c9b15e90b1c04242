#include "stroke.h"

#include "core/base/error.h"
#include "core/base/field_checks.h"

#include <algorithm>
#include <cmath>

namespace mirrorball {

namespace {

double stepAt(const Brush& brush, double pressure)
{
    const double spacing = brush.mode == BrushMode::Smudge ? std::min(brush.spacing, 0.1) : brush.spacing;
    return spacing * 2.0 * radiusAt(brush, pressure);
}

/// Calls `touch(point)` at each dab along the way.
template <typename Touch>
void walk(const Stroke& stroke, const Touch& touch)
{
    const auto& points = stroke.points;
    if (points.empty())
        return;
    touch(points[0]);
    double left = stepAt(stroke.brush, points[0].pressure); // way to the next dab
    for (size_t i = 1; i < points.size(); ++i) {
        const StrokePoint& a = points[i - 1];
        const StrokePoint& b = points[i];
        const double length = glm::length(b.q - a.q);
        double at = 0.0;
        while (length - at >= left) {
            at += left;
            const double t = at / length;
            const StrokePoint here{glm::mix(a.q, b.q, t), glm::mix(a.pressure, b.pressure, t), glm::mix(a.tilt, b.tilt, t)};
            touch(here);
            left = stepAt(stroke.brush, here.pressure);
        }
        left -= length - at;
    }
}

[[noreturn]] void refuseDabs(const std::string& what)
{
    throw InvalidArgument(what + ": needs more than " + std::to_string(mostDabs) +
                          " dabs; draw less at once, or use a larger radius, a wider spacing or less symmetry");
}

/// An upper bound on the dabs of one copy: between two points the steps are no shorter than at the lighter one.
double mostTouches(const Stroke& stroke)
{
    double touches = 1.0;
    for (size_t i = 1; i < stroke.points.size(); ++i) {
        const StrokePoint &a = stroke.points[i - 1], &b = stroke.points[i];
        touches += glm::length(b.q - a.q) / stepAt(stroke.brush, std::min(a.pressure, b.pressure));
    }
    return touches;
}

double mostDabsOf(const Stroke& stroke) { return mostTouches(stroke) * stroke.symmetry.radial * (stroke.symmetry.mirror ? 2.0 : 1.0); }

} // namespace

void checkFields(const std::string& path, const Stroke& stroke)
{
    Brush::visitFields(stroke.brush, RangeChecker(path + ".brush"));
    Symmetry::visitFields(stroke.symmetry, RangeChecker(path + ".symmetry"));
    if (stroke.points.size() > mostStrokePoints)
        throw InvalidArgument(path + ".points: are more than " + std::to_string(mostStrokePoints) + "; thin the stroke out");
    for (size_t i = 0; i < stroke.points.size(); ++i) {
        const StrokePoint& point = stroke.points[i];
        const auto where = [&] { return path + ".points[" + std::to_string(i) + "]"; };
        if (!(std::abs(point.q.x) <= farthestPoint && std::abs(point.q.y) <= farthestPoint))
            throw InvalidArgument(where() + ": must lie within " + numberText(farthestPoint) +
                                  " disc radii of the center, as finite numbers");
        if (!(point.pressure >= 0.0 && point.pressure <= 1.0))
            throw InvalidArgument(where() + ": has a pressure outside [0, 1]; pressure is the third number of a point");
        if (!(std::abs(point.tilt.x) <= mostTilt && std::abs(point.tilt.y) <= mostTilt))
            throw InvalidArgument(where() + ": has a tilt outside [-60, 60] degrees; tilts are the fourth and fifth number of a point");
    }
    if (mostDabsOf(stroke) > static_cast<double>(mostDabs))
        refuseDabs(path);
}

void validate(std::span<const Stroke> strokes, const std::string& path)
{
    size_t points = 0;
    double dabs = 0.0;
    for (size_t s = 0; s < strokes.size(); ++s) {
        checkFields(path + "[" + std::to_string(s) + "]", strokes[s]);
        points += strokes[s].points.size();
        dabs += mostDabsOf(strokes[s]);
        if (points > mostStrokePoints)
            throw InvalidArgument(path + ": hold more than " + std::to_string(mostStrokePoints) +
                                  " points; thin the strokes out or spread them over several layers");
        if (dabs > static_cast<double>(mostDabs))
            refuseDabs(path);
    }
}

StrokeDabs strokeDabs(const Stroke& stroke)
{
    const std::vector<glm::dmat2> maps = symmetryMaps(stroke.symmetry);
    std::vector<Dab> drawn;
    walk(stroke, [&](const StrokePoint& at) {
        if ((drawn.size() + 1) * maps.size() > mostDabs)
            refuseDabs("the stroke");
        drawn.push_back({at.q, drawn.empty() ? glm::dvec2(0.0) : at.q - drawn.back().q, radiusAt(stroke.brush, at.pressure),
                         strengthAt(stroke.brush, at.pressure), leanAt(stroke.brush, at.tilt)});
    });
    StrokeDabs result{.copies = maps.size()};
    result.dabs.reserve(drawn.size() * maps.size());
    for (const glm::dmat2& map : maps)
        for (const Dab& dab : drawn)
            result.dabs.push_back({map * dab.q, map * dab.motion, dab.radius, dab.strength, map * dab.lean});
    return result;
}

} // namespace mirrorball
