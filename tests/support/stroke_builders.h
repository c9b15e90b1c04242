#pragma once

#include "core/spheremap/strokes/stroke.h"

#include <cmath>
#include <random>
#include <vector>

/// Strokes for tests and benchmarks.
namespace mirrorball {

/// A stroke along a straight line under full pressure.
inline Stroke straightStroke(const glm::dvec2& from, const glm::dvec2& to, const Brush& brush = {})
{
    return {.brush = brush, .points = {{from, 1.0}, {to, 1.0}}};
}

/// One dab under full pressure.
inline Stroke dab(const glm::dvec2& q, const Brush& brush = {}) { return {.brush = brush, .points = {{q, 1.0}}}; }

/// As an artist at work might draw: curved strokes of about `length` disc radii with changing pressure, brushes and colors, now and
/// then an erasing one; `smudges` of every hundred push.
inline std::vector<Stroke> handDrawnStrokes(int count, unsigned seed, double radius = 0.04, double length = 0.5, int smudges = 0)
{
    std::mt19937 random(seed);
    const auto uniform = [&](double low, double high) { // std's distributions differ from library to library
        return low + (high - low) * (static_cast<double>(random()) / 4294967296.0);
    };
    std::vector<Stroke> strokes;
    for (int s = 0; s < count; ++s) {
        Stroke stroke;
        const double kind = uniform(0.0, 100.0);
        stroke.brush.mode = kind < smudges ? BrushMode::Smudge : kind > 90.0 ? BrushMode::Erase : BrushMode::Paint;
        stroke.brush.color = {uniform(0, 1), uniform(0, 1), uniform(0, 1)};
        stroke.brush.radius = radius * uniform(0.4, 1.6);
        stroke.brush.hardness = uniform(0.0, 0.9);
        stroke.brush.flow = uniform(0.2, 1.0);
        glm::dvec2 q{uniform(-0.8, 0.8), uniform(-0.8, 0.8)};
        double heading = uniform(0.0, 6.28);
        const double bend = uniform(-0.15, 0.15);
        constexpr int points = 32;
        for (int i = 0; i < points; ++i) {
            const double t = static_cast<double>(i) / (points - 1);
            stroke.points.push_back({q, 0.3 + 0.7 * std::sin(3.14159 * t)});
            q += glm::dvec2(std::cos(heading), std::sin(heading)) * (length / points);
            heading += bend;
        }
        strokes.push_back(std::move(stroke));
    }
    return strokes;
}

} // namespace mirrorball
