#include "stroke.h"

#include "../error.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace mirrorball {

namespace {

std::string text(double value)
{
    std::string digits = std::to_string(value);
    if (digits.find('.') != std::string::npos)
        digits.erase(digits.find_last_not_of('0') + 1);
    if (digits.ends_with('.'))
        digits.pop_back();
    return digits;
}

/// Checks the numbers of a settings struct against their fields.
class RangeCheck {
public:
    explicit RangeCheck(std::string path) : m_path(std::move(path)) {}

    template <typename T>
    void operator()(const Field& field, const T& value) const
    {
        if constexpr (std::is_same_v<T, glm::dvec3>) {
            for (int c = 0; c < 3; ++c)
                check(field, value[c]);
        } else if constexpr (std::is_arithmetic_v<T> && !std::is_same_v<T, bool>) {
            check(field, static_cast<double>(value));
        }
    }

private:
    void check(const Field& field, double value) const
    {
        if (!(value >= field.low && value <= field.high))
            throw InvalidArgument(m_path + "." + std::string(field.name) + ": must lie in [" + text(field.low) + ", " + text(field.high) +
                                  "]; it is " + (std::isfinite(value) ? text(value) : "not a finite number"));
    }

    std::string m_path;
};

double stepAt(const Brush& brush, double pressure)
{
    const double spacing = brush.mode == BrushMode::Smudge ? std::min(brush.spacing, 0.1) : brush.spacing;
    return spacing * 2.0 * radiusAt(brush, pressure);
}

/// Calls `touch(q, pressure)` at each dab along the way.
template <typename Touch>
void walk(const Stroke& stroke, const Touch& touch)
{
    const auto& points = stroke.points;
    if (points.empty())
        return;
    touch(points[0].q, points[0].pressure);
    double left = stepAt(stroke.brush, points[0].pressure); // way to the next dab
    for (size_t i = 1; i < points.size(); ++i) {
        const StrokePoint& a = points[i - 1];
        const StrokePoint& b = points[i];
        const double length = glm::length(b.q - a.q);
        double at = 0.0;
        while (length - at >= left) {
            at += left;
            const double t = at / length;
            const double pressure = glm::mix(a.pressure, b.pressure, t);
            touch(glm::mix(a.q, b.q, t), pressure);
            left = stepAt(stroke.brush, pressure);
        }
        left -= length - at;
    }
}

[[noreturn]] void refuseDabs(const std::string& what)
{
    throw InvalidArgument(what + ": needs more than " + std::to_string(mostDabs) +
                          " dabs; draw less at once, or use a larger radius, a wider spacing or less symmetry");
}

} // namespace

void validate(std::span<const Stroke> strokes, const std::string& path)
{
    size_t points = 0;
    double dabs = 0.0;
    for (size_t s = 0; s < strokes.size(); ++s) {
        const Stroke& stroke = strokes[s];
        const std::string name = path + "[" + std::to_string(s) + "]";
        Brush::visitFields(stroke.brush, RangeCheck(name + ".brush"));
        Symmetry::visitFields(stroke.symmetry, RangeCheck(name + ".symmetry"));
        points += stroke.points.size();
        if (points > mostStrokePoints)
            throw InvalidArgument(path + ": hold more than " + std::to_string(mostStrokePoints) +
                                  " points; thin the strokes out or spread them over several layers");
        double touches = 1.0; // an upper bound: between two points the steps are no shorter than at the lighter one
        for (size_t i = 0; i < stroke.points.size(); ++i) {
            const StrokePoint& point = stroke.points[i];
            const auto where = [&] { return name + ".points[" + std::to_string(i) + "]"; };
            if (!(std::abs(point.q.x) <= farthestPoint && std::abs(point.q.y) <= farthestPoint))
                throw InvalidArgument(where() + ": must lie within " + text(farthestPoint) + " disc radii of the centre, as finite numbers");
            if (!(point.pressure >= 0.0 && point.pressure <= 1.0))
                throw InvalidArgument(where() + ": has a pressure outside [0, 1]; pressure is the third number of a point");
            if (i > 0) {
                const StrokePoint& before = stroke.points[i - 1];
                touches += glm::length(point.q - before.q) / stepAt(stroke.brush, std::min(point.pressure, before.pressure));
            }
        }
        dabs += touches * stroke.symmetry.radial * (stroke.symmetry.mirror ? 2.0 : 1.0);
        if (dabs > static_cast<double>(mostDabs))
            refuseDabs(name);
    }
}

StrokeDabs strokeDabs(const Stroke& stroke)
{
    const std::vector<glm::dmat2> maps = symmetryMaps(stroke.symmetry);
    std::vector<Dab> drawn;
    walk(stroke, [&](const glm::dvec2& q, double pressure) {
        if ((drawn.size() + 1) * maps.size() > mostDabs)
            refuseDabs("the stroke");
        drawn.push_back({q, drawn.empty() ? glm::dvec2(0.0) : q - drawn.back().q, radiusAt(stroke.brush, pressure),
                         strengthAt(stroke.brush, pressure)});
    });
    StrokeDabs result{.copies = maps.size()};
    result.dabs.reserve(drawn.size() * maps.size());
    for (const glm::dmat2& map : maps)
        for (const Dab& dab : drawn)
            result.dabs.push_back({map * dab.q, map * dab.motion, dab.radius, dab.strength});
    return result;
}

} // namespace mirrorball
