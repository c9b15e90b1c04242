#pragma once

#include "stroke.h"

#include <vector>

namespace mirrorball {

/// Turns the samples of a pen into the points of strokes.
///
/// A hand's curve comes in as corners, a hundred a second. The recorder joins the middles of neighboring samples by quadratic curves with
/// the samples as control points (a uniform quadratic B-spline): smooth, nowhere beyond the samples, and with a point that once stands
/// never moved again, so that what is drawn so far is drawn. Numbers are rounded to 1e-5 of the disc's radius, 1/100 of a texel at 2048,
/// and tilts to a tenth of a degree, to keep files short; for the same reason tilts that the brush takes no notice of are left out.
///
/// On the model the place on the map may leap from one sample to the next, where the pen crosses an outline. A leap ends the stroke and
/// begins another, so that no line is drawn across the map.
class StrokeRecorder {
public:
    /// @param leap  distance of two samples, in disc radii, from which on the pen has left the surface it was on
    StrokeRecorder(Brush brush, Symmetry symmetry, double leap = 8.0);

    void add(const StrokePoint& sample);
    /// The pen was off the model: what comes next is a new stroke.
    void lift();
    /// The pen is up: the last curves are drawn to their ends.
    void finish();

    /// The strokes so far, each of at least one point.
    const std::vector<Stroke>& strokes() const { return m_strokes; }

private:
    void endStroke();
    void push(const StrokePoint& point);

    Brush m_brush;
    Symmetry m_symmetry;
    double m_leap;
    std::vector<Stroke> m_strokes{};
    std::vector<StrokePoint> m_samples{}; ///< the last two of the stroke at hand
};

} // namespace mirrorball
