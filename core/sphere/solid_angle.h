#pragma once

#include <glm/glm.hpp>

#include <cmath>

namespace mirrorball {

/// Solid angle in steradians of the triangle a b c seen from the origin; the corners need not be normalized, the sign is that of
/// the winding.
///   tan(omega / 2) = a.(b x c) / (|a||b||c| + (a.b)|c| + (b.c)|a| + (c.a)|b|)
/// The triple product is taken of differences, so that a triangle of 1e-8 rad keeps its relative precision.
/// Source: A. van Oosterom, J. Strackee, The Solid Angle of a Plane Triangle, IEEE Trans. Biomed. Eng. 30 (1983), eq. 8.
inline double triangleSolidAngle(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c)
{
    const double la = glm::length(a), lb = glm::length(b), lc = glm::length(c);
    const double triple = glm::dot(a, glm::cross(b - a, c - a));
    return 2.0 * std::atan2(triple, la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la + glm::dot(c, a) * lb);
}

} // namespace mirrorball
