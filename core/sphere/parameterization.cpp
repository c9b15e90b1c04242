#include "parameterization.h"

#include "angular_map.h"
#include "core/base/error.h"
#include "cube_map.h"
#include "dual_paraboloid.h"
#include "latlong.h"
#include "octahedral.h"
#include "sphere_map.h"

#include <cstddef>

namespace mirrorball {

std::string_view name(Parameterization p)
{
    switch (p) {
    case Parameterization::Latlong:
        return "latlong";
    case Parameterization::Cube:
        return "cube";
    case Parameterization::Sphere:
        return "sphere";
    case Parameterization::Angular:
        return "angular";
    case Parameterization::Paraboloid:
        return "paraboloid";
    case Parameterization::Octahedral:
        return "octahedral";
    }
    return {};
}

std::optional<Parameterization> parameterizationFromName(std::string_view word)
{
    for (const auto p : allParameterizations)
        if (name(p) == word)
            return p;
    return {};
}

void validate(const MapLayout& layout)
{
    if (layout.size < 1 || layout.size > 32768)
        throw InvalidArgument("size " + std::to_string(layout.size) + " is out of range: give 1 to 32768 texels");
    if (layout.kind != Parameterization::Paraboloid && layout.border != 0)
        throw InvalidArgument("border " + std::to_string(layout.border) + ": only a paraboloid map has one, give 0 for " +
                              std::string(name(layout.kind)));
    if (layout.border < 0 || (layout.border > 0 && 2 * layout.border >= layout.size))
        throw InvalidArgument("border " + std::to_string(layout.border) + " leaves no disc in a half of " + std::to_string(layout.size) +
                              " texels: give 0 to " + std::to_string((layout.size - 1) / 2));
}

glm::dvec3 direction(const MapLayout& layout, const glm::dvec2& p)
{
    switch (layout.kind) {
    case Parameterization::Latlong:
        return latlong::direction(layout.size, p);
    case Parameterization::Cube:
        return cube_map::direction(layout.size, p);
    case Parameterization::Sphere:
        return sphere_map::direction(layout.size, p);
    case Parameterization::Angular:
        return angular_map::direction(layout.size, p);
    case Parameterization::Paraboloid:
        return dual_paraboloid::direction(layout.size, layout.border, p);
    case Parameterization::Octahedral:
        return octahedral::direction(layout.size, p);
    }
    return {};
}

glm::dvec2 coordinate(const MapLayout& layout, const glm::dvec3& d)
{
    switch (layout.kind) {
    case Parameterization::Latlong:
        return latlong::coordinate(layout.size, d);
    case Parameterization::Cube:
        return cube_map::coordinate(layout.size, d);
    case Parameterization::Sphere:
        return sphere_map::coordinate(layout.size, d);
    case Parameterization::Angular:
        return angular_map::coordinate(layout.size, d);
    case Parameterization::Paraboloid:
        return dual_paraboloid::coordinate(layout.size, layout.border, d);
    case Parameterization::Octahedral:
        return octahedral::coordinate(layout.size, d);
    }
    return {};
}

bool isInside(const MapLayout& layout, int x, int y)
{
    if (x < 0 || y < 0 || x >= layout.width() || y >= layout.height())
        return false;
    switch (layout.kind) {
    case Parameterization::Sphere:
    case Parameterization::Angular:
        return disc::inscribed(layout.size).holdsPart(x, y);
    case Parameterization::Paraboloid:
        return dual_paraboloid::half(layout.size, layout.border, x >= layout.size).holdsPart(x, y);
    default:
        return true;
    }
}

double solidAngle(const MapLayout& layout, const glm::dvec2& min, const glm::dvec2& max)
{
    switch (layout.kind) {
    case Parameterization::Latlong:
        return latlong::solidAngle(layout.size, min, max);
    case Parameterization::Cube:
        return cube_map::solidAngle(layout.size, min, max);
    case Parameterization::Sphere:
        return sphere_map::solidAngle(layout.size, min, max);
    case Parameterization::Angular:
        return angular_map::solidAngle(layout.size, min, max);
    case Parameterization::Paraboloid:
        return dual_paraboloid::solidAngle(layout.size, layout.border, min, max);
    case Parameterization::Octahedral:
        return octahedral::solidAngle(layout.size, min, max);
    }
    return 0.0;
}

double texelSolidAngle(const MapLayout& layout, int x, int y) { return solidAngle(layout, {x, y}, {x + 1, y + 1}); }

double density(const MapLayout& layout, const glm::dvec2& p)
{
    switch (layout.kind) {
    case Parameterization::Latlong:
        return latlong::density(layout.size, p);
    case Parameterization::Cube:
        return cube_map::density(layout.size, p);
    case Parameterization::Sphere:
        return sphere_map::density(layout.size, p);
    case Parameterization::Angular:
        return angular_map::density(layout.size, p);
    case Parameterization::Paraboloid:
        return dual_paraboloid::density(layout.size, layout.border, p);
    case Parameterization::Octahedral:
        return octahedral::density(layout.size, p);
    }
    return 0.0;
}

SolidAngles::SolidAngles(const MapLayout& layout, const JobControl& job)
    : m_columns(layout.kind == Parameterization::Latlong ? 1 : layout.size), m_rows(layout.size),
      m_values(static_cast<size_t>(m_columns) * static_cast<size_t>(m_rows))
{
    const JobControl quiet{.stop = job.stop, .progress = {}, .threads = job.threads}; // progress is the caller's to report
    parallelRows(m_rows, quiet, [&](int first, int last) {
        for (int y = first; y < last; ++y)
            for (int x = 0; x < m_columns; ++x)
                m_values[static_cast<size_t>(y) * static_cast<size_t>(m_columns) + static_cast<size_t>(x)] = texelSolidAngle(layout, x, y);
    });
}

Texel acrossSeam(const MapLayout& layout, Texel chart, int x, int y)
{
    switch (layout.kind) {
    case Parameterization::Latlong:
        return latlong::acrossSeam(layout.size, x, y);
    case Parameterization::Cube:
        return cube_map::acrossSeam(layout.size, chart, x, y);
    case Parameterization::Sphere:
        return sphere_map::acrossSeam(layout.size, x, y);
    case Parameterization::Angular:
        return angular_map::acrossSeam(layout.size, x, y);
    case Parameterization::Paraboloid:
        return dual_paraboloid::acrossSeam(layout.size, layout.border, chart, x, y);
    case Parameterization::Octahedral:
        return octahedral::acrossSeam(layout.size, x, y);
    }
    return chart;
}

} // namespace mirrorball
