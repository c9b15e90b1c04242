#pragma once

#include "core/sphere/parameterization.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <span>

namespace mirrorball {

/// A map's image as charts without seams: closed regions of the sphere, bounded by planes through the origin, in each of which image
/// positions are continuous and one to one. Latlong: the four lunes between the planes x = 0 and z = 0, which meet at the poles; cube: the
/// six faces; octahedral: the eight octants; paraboloid: the two halves; sphere and angular map: the four quadrants that meet at -Z.
///
/// Image positions are those of parameterization.h, except that in a latlong the position inside a row is the share of the row's solid
/// angle above it: a cut through a row divides it as it divides the sphere.
class MapCharts {
public:
    explicit MapCharts(const MapLayout& layout) : m_layout(layout) {}

    const MapLayout& layout() const { return m_layout; }
    /// The charts whose closed region holds d, as bits. d need not be normalized.
    unsigned chartsOf(const glm::dvec3& d) const;
    /// The planes that divide the sphere into pieces of one chart each.
    std::span<const glm::dvec3> planes() const;
    /// Whether d is a point that a whole edge of the image stands for: a latlong's pole, the -Z of a sphere or angular map.
    bool isSingular(const glm::dvec3& d) const;
    /// Image position of d in the chart, over its edges too. A singular d lies at the azimuth of `beside`.
    glm::dvec2 position(int chart, const glm::dvec3& d, const glm::dvec3& beside) const;
    glm::dvec2 position(int chart, const glm::dvec3& d) const { return position(chart, d, d); }
    /// position() of many directions, none of them singular or all at their own azimuth, given by coordinate: x[i], y[i], z[i].
    void positions(int chart, size_t count, const double* x, const double* y, const double* z, double* px, double* py) const;
    /// Steradians per square texel at the middle of texel (x, y); at a disc's rim that of the nearest place inside, 0 for texels outside.
    double density(int x, int y) const;

private:
    MapLayout m_layout;
};

} // namespace mirrorball
