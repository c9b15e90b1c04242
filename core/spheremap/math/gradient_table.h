#pragma once

#include "span.h"

#include "core/base/fields.h"

#include <glm/glm.hpp>

#include <array>
#include <span>
#include <string_view>
#include <vector>

namespace mirrorball {

/// A color at a place of a gradient.
struct GradientStop {
    double position = 0.0;
    glm::dvec3 color{0.0};
    double opacity = 1.0;
    UnknownKeys unknown{};

    bool operator==(const GradientStop&) const = default;
    template <typename Self, typename Visit>
    static void visitFields(Self& self, Visit&& visit)
    {
        visit(Field{"position", "where on the gradient; two stops at one place make a hard edge", 0, 1}, self.position);
        visit(Field{"color", "linear RGB", 0, 1000}, self.color);
        visit(Field{"opacity", "0: what lies below shows through", 0, 1}, self.opacity);
    }
};

/// How the colors between two stops are found: in Oklab, where steps look even and blue goes to yellow without mud, or in linear light,
/// as light itself mixes.
enum class ColorMixing { Oklab, Linear };
std::span<const std::string_view> words(ColorMixing); // oklab linear

/// A gradient as a table over [0, 1], read linearly.
class GradientTable {
public:
    /// @param stops  in any order; none: transparent
    GradientTable(std::span<const GradientStop> stops, ColorMixing mixing);

    struct Entry {
        float r, g, b, a;
    };
    /// The color at t, which is clamped to [0, 1].
    Entry at(float t) const
    {
        const float x = std::min(1.0f, std::max(0.0f, t)) * static_cast<float>(intervals);
        const int i = std::min(static_cast<int>(x), intervals - 1);
        const float f = x - static_cast<float>(i);
        const Entry &p = m_entries[static_cast<size_t>(i)], &q = m_entries[static_cast<size_t>(i) + 1];
        return {p.r + f * (q.r - p.r), p.g + f * (q.g - p.g), p.b + f * (q.b - p.b), p.a + f * (q.a - p.a)};
    }

    /// The colors at `count` places, each as at() gives it.
    void look(int count, const float* t, ColorSpan& out) const;

private:
    static constexpr int intervals = 2048;
    std::array<Entry, intervals + 1> m_entries{};
};

} // namespace mirrorball
