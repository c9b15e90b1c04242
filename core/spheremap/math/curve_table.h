#pragma once

#include "core/base/fields.h"

#include <array>
#include <vector>

namespace mirrorball {

/// A point of a tone curve, on square roots of light.
struct CurvePoint {
    double x = 0.0;
    double y = 0.0;
    UnknownKeys unknown{};

    bool operator==(const CurvePoint&) const = default;
    template <typename Self, typename Visit>
    static void visitFields(Self& self, Visit&& visit)
    {
        visit(Field{"x", "square root of the channel before", 0, 1}, self.x);
        visit(Field{"y", "square root of the channel after", 0, 4}, self.y);
    }
};

/// A smooth curve through points, monotone between them, as a table over [0, 1], read linearly: a cubic whose tangents lie within the
/// circle of radius 3. Before the first point and behind the last it is flat; past 1 it goes on as a straight line through the origin, f(x)
/// = x f(1). Source: Fritsch and Carlson 1980.
class CurveTable {
public:
    /// @param points  in any order, two or more
    explicit CurveTable(std::vector<CurvePoint> points);

    /// @param x  not negative
    float at(float x) const
    {
        if (!(x < 1.0f)) // NaN too
            return x * m_entries[intervals];
        const float p = x * static_cast<float>(intervals);
        const int i = static_cast<int>(p);
        const float low = m_entries[static_cast<size_t>(i)];
        return low + (p - static_cast<float>(i)) * (m_entries[static_cast<size_t>(i) + 1] - low);
    }

private:
    static constexpr int intervals = 1024;
    std::array<float, intervals + 1> m_entries{};
};

} // namespace mirrorball
