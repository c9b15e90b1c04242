#pragma once

#include "map_charts.h"

#include <vector>

namespace mirrorball {

/// Bends of an outline are followed to this many texels of the source.
inline constexpr double outlineTolerance = 0.002;

/// A part of a texel as a polygon in another map's image, within one chart of it. Corners run so that the area is positive:
/// the sum of (x_i y_i+1 - x_i+1 y_i) / 2, y down.
struct OutlinePiece {
    std::vector<glm::dvec2> corners{};
};

/// Outlines of a target's texels in a source's image.
///
/// A texel's boundary is followed as directions, each edge in equal parts so many that straight lines between their image positions are
/// within outlineTolerance of it, cut by the planes between the source's charts and laid out in each. Neighbors walk a common edge through
/// the same points, so the pieces of all texels cover the source's image once, without gaps, whatever the tolerance. Texels at a disc's rim
/// end there; those outside, and all of a paraboloid with a border, are taken as the map continues.
class TexelOutlines {
public:
    /// @param turn  as ReprojectOptions::turn, which comes before the yaw of those
    TexelOutlines(const MapLayout& target, double yaw, const glm::dmat3& turn, const MapCharts& source)
        : m_target(target), m_yaw(yaw), m_turns(turn != glm::dmat3(1.0)), m_back(glm::transpose(turn)), m_source(source)
    {
    }

    /// Direction in the source of an image position that belongs to texel (x, y), its edges included: unlike mirrorball::direction(), which
    /// takes a position on the edge between two faces or halves for the second one's.
    glm::dvec3 directionIn(int x, int y, const glm::dvec2& p) const;
    /// A grid of places of the image, row by row.
    struct Places {
        glm::dvec2 first{}, step{};
        int columns = 0, rows = 0;
        size_t count() const { return static_cast<size_t>(columns) * static_cast<size_t>(rows); }
    };
    /// directionIn() of many places that belong to texel (x, y)'s chart, not normalized. Within rounding what directionIn() is.
    void directions(int x, int y, const Places& places, double* dx, double* dy, double* dz) const;
    /// Whether the rim of a disc cuts the texel and ends it.
    bool endsAtRim(int x, int y) const;
    /// The texel in the source's image. One that a disc only touches, in a sliver of no area, is taken whole.
    std::vector<OutlinePiece> pieces(int x, int y) const { return pieces(x, y, Rim::Ends); }
    /// How far the middle of a straight edge between image positions of texel (x, y) lies from where it should, in texels of the source.
    /// Larger than any tolerance when the edge leaves its chart.
    double bend(int x, int y, const glm::dvec2& from, const glm::dvec2& to) const;
    /// How often an edge of that bend is halved till straight lines do for it: each halving leaves a quarter of the bend. At most
    /// mostHalvings.
    static int halvings(double bend);
    static constexpr int mostHalvings = 10;

private:
    enum class Rim { Ends, Continues };
    template <class At>
    void follow(const At& at, double t0, const glm::dvec3& d0, double t1, const glm::dvec3& d1, int depth,
                std::vector<glm::dvec3>& out) const;
    std::vector<OutlinePiece> pieces(int x, int y, Rim rim) const;
    std::vector<glm::dvec3> boundary(int x, int y, Rim rim) const;
    std::vector<glm::dvec3> clippedBoundary(int x, int y) const;
    void split(std::vector<glm::dvec3> polygon, size_t plane, std::vector<OutlinePiece>& out) const;
    void layOut(const std::vector<glm::dvec3>& polygon, int chart, std::vector<OutlinePiece>& out) const;
    void layOutRim(int chart, const glm::dvec3& d0, const glm::dvec2& p0, const glm::dvec3& d1, const glm::dvec2& p1, int depth,
                   std::vector<glm::dvec2>& out) const;
    /// From the turned environment to the source.
    glm::dvec3 turnedBack(const glm::dvec3& d) const
    {
        const glm::dvec3 unyawed = m_yaw == 0.0 ? d : yawed(d, -m_yaw);
        return m_turns ? m_back * unyawed : unyawed;
    }
    double bendBetween(const glm::dvec3& d0, const glm::dvec3& middle, const glm::dvec3& d1) const;

    MapLayout m_target;
    double m_yaw;
    bool m_turns;
    glm::dmat3 m_back;
    MapCharts m_source;
};

} // namespace mirrorball
