#include "stroke_recorder.h"

#include <algorithm>
#include <cmath>

namespace mirrorball {

namespace {

double rounded(double value) { return std::round(value * 1e5) / 1e5; }

/// To a tenth of a degree, more than pens tell apart.
double roundedTilt(double degrees) { return std::round(std::clamp(degrees, -mostTilt, mostTilt) * 10.0) / 10.0; }

StrokePoint middle(const StrokePoint& a, const StrokePoint& b)
{
    return {0.5 * (a.q + b.q), 0.5 * (a.pressure + b.pressure), 0.5 * (a.tilt + b.tilt)};
}

} // namespace

StrokeRecorder::StrokeRecorder(Brush brush, Symmetry symmetry, double leap)
    : m_brush(std::move(brush)), m_symmetry(std::move(symmetry)), m_leap(leap)
{
}

void StrokeRecorder::push(const StrokePoint& point)
{
    const StrokePoint kept{{rounded(point.q.x), rounded(point.q.y)},
                           std::clamp(rounded(point.pressure), 0.0, 1.0),
                           {roundedTilt(point.tilt.x), roundedTilt(point.tilt.y)}};
    std::vector<StrokePoint>& points = m_strokes.back().points;
    if (points.empty() || points.back() != kept)
        points.push_back(kept);
}

/// b^2: (1-t)^2 m0 + 2 t (1-t) c + t^2 m1, cut finely enough that its chords stay within 1/20 of the tip's radius, or 1e-4.
void StrokeRecorder::add(const StrokePoint& sample)
{
    if (!std::isfinite(sample.q.x + sample.q.y + sample.pressure + sample.tilt.x + sample.tilt.y))
        return;
    const StrokePoint at{glm::clamp(sample.q, -farthestPoint, farthestPoint), sample.pressure,
                         m_brush.tilt > 0.0 ? sample.tilt : glm::dvec2(0.0)};
    if (!m_samples.empty() && glm::distance(m_samples.back().q, at.q) > m_leap)
        endStroke();
    if (m_samples.empty()) {
        m_strokes.push_back({.brush = m_brush, .symmetry = m_symmetry});
        push(at);
        m_samples.push_back(at);
        return;
    }
    if (glm::distance(m_samples.back().q, at.q) < 1e-5)
        return;
    if (m_samples.size() == 1) {
        push(middle(m_samples[0], at));
        m_samples.push_back(at);
        return;
    }
    const StrokePoint &before = m_samples[0], &control = m_samples[1];
    const StrokePoint from = middle(before, control), to = middle(control, at);
    // A chord of a quadratic cut into n leaves it by at most |m0 - 2c + m1| / (4 n^2).
    const double bend = glm::length(from.q - 2.0 * control.q + to.q), within = std::max(1e-4, 0.05 * m_brush.radius);
    const int pieces = std::clamp(static_cast<int>(std::ceil(std::sqrt(bend / (4.0 * within)))), 1, 32);
    for (int i = 1; i <= pieces; ++i) {
        const double t = static_cast<double>(i) / pieces, s = 1.0 - t;
        push({s * s * from.q + 2.0 * t * s * control.q + t * t * to.q,
              s * s * from.pressure + 2.0 * t * s * control.pressure + t * t * to.pressure,
              s * s * from.tilt + 2.0 * t * s * control.tilt + t * t * to.tilt});
    }
    m_samples = {control, at};
}

void StrokeRecorder::endStroke()
{
    if (m_samples.size() == 2)
        push(m_samples[1]);
    m_samples.clear();
}

void StrokeRecorder::lift() { endStroke(); }

void StrokeRecorder::finish() { endStroke(); }

} // namespace mirrorball
