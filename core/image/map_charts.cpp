#include "map_charts.h"

#include "latlong_positions.h"

#include "core/sphere/cube_map.h"
#include "core/sphere/disc.h"
#include "core/sphere/dual_paraboloid.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace mirrorball {

namespace {

constexpr double onPlane = 1e-13; ///< of a unit vector
constexpr double polarRows = 8.0; ///< beyond them the density changes by less than an eighth along a row's height

/// Which sides of a plane a coordinate lies on: bit 0 negative, bit 1 positive, both on the plane itself.
unsigned sides(double value, double scale) { return value > onPlane * scale ? 2u : value < -onPlane * scale ? 1u : 3u; }

/// Bits of the products of sides: bit a + 2 b + ... for side a of the first, b of the second.
unsigned product(unsigned a, unsigned b) { return ((b & 1u) != 0 ? a : 0u) | ((b & 2u) != 0 ? a << 2 : 0u); }

/// Where in the polar rows a colatitude lies by solid angle; y in rows from the pole.
double polarPosition(int n, double y)
{
    const double row = std::floor(y), half = 0.5 * pi / n;
    const auto cap = [&](double at) {
        const double s = std::sin(half * at);
        return s * s; // (1 - cos) / 2
    };
    const double from = cap(row);
    return row + (cap(y) - from) / (cap(row + 1.0) - from);
}

double byPolarRow(int n, double y) { return 2.0 * y < n ? polarPosition(n, std::max(y, 0.0)) : n - polarPosition(n, std::max(n - y, 0.0)); }

} // namespace

unsigned MapCharts::chartsOf(const glm::dvec3& d) const
{
    const glm::dvec3 a = glm::abs(d);
    const double scale = std::max({a.x, a.y, a.z});
    switch (m_layout.kind) {
    case Parameterization::Latlong:
        return product(sides(d.x, scale), sides(d.z, scale));
    case Parameterization::Sphere:
    case Parameterization::Angular:
        return product(sides(d.x, scale), sides(d.y, scale));
    case Parameterization::Paraboloid: // chart 0 is the front
        return (d.z >= -onPlane * scale ? 1u : 0u) | (d.z <= onPlane * scale ? 2u : 0u);
    case Parameterization::Octahedral: {
        const unsigned xz = product(sides(d.x, scale), sides(d.z, scale)), y = sides(d.y, scale);
        return ((y & 1u) != 0 ? xz : 0u) | ((y & 2u) != 0 ? xz << 4 : 0u);
    }
    case Parameterization::Cube: {
        const double least = scale * (1.0 - onPlane);
        unsigned faces = 0;
        for (int axis = 0; axis < 3; ++axis)
            if (a[axis] >= least)
                faces |= 1u << (2 * axis + (d[axis] < 0.0 ? 1 : 0));
        return faces;
    }
    }
    return 0;
}

std::span<const glm::dvec3> MapCharts::planes() const
{
    static const std::array<glm::dvec3, 2> lunes{{{1, 0, 0}, {0, 0, 1}}}, quadrants{{{1, 0, 0}, {0, 1, 0}}};
    static const std::array<glm::dvec3, 1> halves{{{0, 0, 1}}};
    static const std::array<glm::dvec3, 3> octants{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    static const std::array<glm::dvec3, 6> faces{{{1, 1, 0}, {1, -1, 0}, {0, 1, 1}, {0, 1, -1}, {1, 0, 1}, {1, 0, -1}}};
    switch (m_layout.kind) {
    case Parameterization::Latlong:
        return lunes;
    case Parameterization::Cube:
        return faces;
    case Parameterization::Paraboloid:
        return halves;
    case Parameterization::Octahedral:
        return octants;
    case Parameterization::Sphere:
    case Parameterization::Angular:
        return quadrants;
    }
    return {};
}

bool MapCharts::isSingular(const glm::dvec3& d) const
{
    constexpr double tiny = 1e-24;
    switch (m_layout.kind) {
    case Parameterization::Latlong:
        return d.x * d.x + d.z * d.z < tiny * d.y * d.y;
    case Parameterization::Sphere:
    case Parameterization::Angular:
        return d.z < 0.0 && d.x * d.x + d.y * d.y < tiny * d.z * d.z;
    case Parameterization::Cube:
    case Parameterization::Paraboloid:
    case Parameterization::Octahedral:
        return false;
    }
    return false;
}

glm::dvec2 MapCharts::position(int chart, const glm::dvec3& d, const glm::dvec3& beside) const
{
    const int n = m_layout.size;
    switch (m_layout.kind) {
    case Parameterization::Latlong: {
        if (isSingular(d))
            return {isSingular(beside) ? 0.0 : position(chart, beside).x, d.y > 0.0 ? 0.0 : n};
        glm::dvec2 p;
        positions(chart, 1, &d.x, &d.y, &d.z, &p.x, &p.y);
        return p;
    }
    case Parameterization::Cube: {
        const int axis = chart / 2;
        const double depth = std::abs(d[axis]);
        const glm::dvec3 s = cube_map::facePoint(chart, 1.0, 0.0) - cube_map::facePoint(chart, 0.0, 0.0);
        const glm::dvec3 t = cube_map::facePoint(chart, 0.0, 1.0) - cube_map::facePoint(chart, 0.0, 0.0);
        return {0.5 * n * (glm::dot(d, s) / depth + 1.0), n * static_cast<double>(chart) + 0.5 * n * (glm::dot(d, t) / depth + 1.0)};
    }
    case Parameterization::Paraboloid:
        return dual_paraboloid::half(n, m_layout.border, chart == 1)
            .toImage(glm::dvec2(d.x, d.y) / (glm::length(d) + (chart == 1 ? -d.z : d.z)));
    case Parameterization::Octahedral: {
        const double x = (chart & 1) != 0 ? 1.0 : -1.0, z = (chart & 2) != 0 ? 1.0 : -1.0;
        const double sum = x * d.x + std::abs(d.y) + z * d.z;
        glm::dvec2 ab = glm::dvec2(d.x, d.z) / sum;
        if ((chart & 4) == 0) // the lower half
            ab = {x * (1.0 - z * ab.y), z * (1.0 - x * ab.x)};
        return 0.5 * n * (ab + 1.0);
    }
    case Parameterization::Sphere:
    case Parameterization::Angular: {
        const double sign = m_layout.kind == Parameterization::Angular ? -1.0 : 1.0;
        if (!isSingular(d))
            return coordinate(m_layout, glm::normalize(d));
        const glm::dvec2 azimuth = isSingular(beside) ? glm::dvec2(1.0, 0.0) : glm::normalize(glm::dvec2(sign * beside.x, beside.y));
        return disc::inscribed(n).toImage(azimuth);
    }
    }
    return {};
}

void MapCharts::positions(int chart, size_t count, const double* x, const double* y, const double* z, double* px, double* py) const
{
    if (m_layout.kind != Parameterization::Latlong) {
        for (size_t i = 0; i < count; ++i) {
            const glm::dvec2 p = position(chart, {x[i], y[i], z[i]});
            px[i] = p.x;
            py[i] = p.y;
        }
        return;
    }
    // The lune's middle: columns grow against the longitude.
    const int n = m_layout.size;
    const double lon = ((chart & 2) != 0 ? 0.25 : 0.75) * ((chart & 1) != 0 ? pi : -pi);
    latlongSharePositions(n, (pi - lon) * n / pi, count, x, y, z, px, py);
    for (size_t i = 0; i < count; ++i)
        if (!(py[i] >= polarRows && py[i] <= n - polarRows)) // beside a pole, where the first order will not do
            py[i] = byPolarRow(n, (0.5 * pi - std::atan2(y[i], std::sqrt(x[i] * x[i] + z[i] * z[i]))) * n / pi);
}

double MapCharts::density(int x, int y) const
{
    const glm::dvec2 middle{x + 0.5, y + 0.5};
    switch (m_layout.kind) {
    case Parameterization::Latlong:
        return texelSolidAngle(m_layout, x, y);
    case Parameterization::Sphere:
    case Parameterization::Angular:
    case Parameterization::Paraboloid: {
        if (!isInside(m_layout, x, y))
            return 0.0;
        const disc::Disc disc = disc::at(m_layout, x);
        const glm::dvec2 q = disc.fromImage(middle);
        const double rho = glm::length(q);
        return mirrorball::density(m_layout, rho < 1.0 ? middle : disc.toImage(q * (1.0 - 1e-9) / rho));
    }
    case Parameterization::Octahedral: { // where a fold runs through the texel the density has a kink
        const double n = m_layout.size, a = std::abs(2.0 * middle.x - n), b = std::abs(2.0 * middle.y - n); // in half texels
        if (a < 1.0 || b < 1.0 || std::abs(a + b - n) < 2.0)
            return texelSolidAngle(m_layout, x, y);
        return mirrorball::density(m_layout, middle);
    }
    case Parameterization::Cube:
        break;
    }
    return mirrorball::density(m_layout, middle);
}

} // namespace mirrorball
