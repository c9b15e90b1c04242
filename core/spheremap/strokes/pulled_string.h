#pragma once

#include <glm/glm.hpp>

namespace mirrorball {

/// Steadies a hand: the brush hangs on a string from the pointer, and follows only where the string is taut.
///
/// With p the pointer, b the brush and L the string's length
///   b' = b                          where |p - b| <= L
///   b' = p - L (p - b) / |p - b|    elsewhere
/// so a pointer that moves straight on has the brush L behind it, a tremor within L of the brush moves nothing, and along a way the brush
/// draws a tractrix: of a wave of length w across the way it keeps 1 / sqrt(1 + (2 pi L / w)^2). With L = 0 the brush is where the pointer
/// is. A stroke ends where the brush is: a stretch to the pointer would be the one that nobody steadied.
class PulledString {
public:
    /// Brush and pointer begin at one place. @param length  L, in the unit of the places; 0 and less: none
    explicit PulledString(double length = 0.0, const glm::dvec2& at = glm::dvec2(0.0)) : m_length(length), m_brush(at) {}

    /// @return where the brush is now
    const glm::dvec2& pull(const glm::dvec2& pointer)
    {
        if (!(m_length > 0.0))
            return m_brush = pointer;
        const glm::dvec2 way = pointer - m_brush;
        const double distance = glm::length(way);
        if (distance > m_length)
            m_brush = pointer - way * (m_length / distance);
        return m_brush;
    }
    const glm::dvec2& brush() const { return m_brush; }

private:
    double m_length;
    glm::dvec2 m_brush;
};

} // namespace mirrorball
