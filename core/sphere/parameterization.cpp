#include "parameterization.h"

#include "disc.h"

#include "core/base/error.h"

#include <cstddef>

namespace mirrorball {

std::string_view name(Parameterization p) { return mapping(p).name; }

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
    if (!mapping(layout.kind).hasBorder && layout.border != 0)
        throw InvalidArgument("border " + std::to_string(layout.border) + ": only a paraboloid map has one, give 0 for " +
                              std::string(name(layout.kind)));
    if (layout.border < 0 || (layout.border > 0 && 2 * layout.border >= layout.size))
        throw InvalidArgument("border " + std::to_string(layout.border) + " leaves no disc in a half of " + std::to_string(layout.size) +
                              " texels: give 0 to " + std::to_string((layout.size - 1) / 2));
}

glm::dvec3 direction(const MapLayout& layout, const glm::dvec2& p) { return mapping(layout.kind).direction(layout, p); }

glm::dvec2 coordinate(const MapLayout& layout, const glm::dvec3& d) { return mapping(layout.kind).coordinate(layout, d); }

bool isInside(const MapLayout& layout, int x, int y)
{
    if (x < 0 || y < 0 || x >= layout.width() || y >= layout.height())
        return false;
    return !mapping(layout.kind).hasDiscs() || disc::at(layout, x).holdsPart(x, y);
}

double solidAngle(const MapLayout& layout, const glm::dvec2& min, const glm::dvec2& max)
{
    return mapping(layout.kind).solidAngle(layout, min, max);
}

double texelSolidAngle(const MapLayout& layout, int x, int y) { return solidAngle(layout, {x, y}, {x + 1, y + 1}); }

double density(const MapLayout& layout, const glm::dvec2& p) { return mapping(layout.kind).density(layout, p); }

SolidAngles::SolidAngles(const MapLayout& layout, const JobControl& job)
    : m_columns(mapping(layout.kind).rowsAreAlike ? 1 : layout.size), m_rows(layout.size),
      m_values(static_cast<size_t>(m_columns) * static_cast<size_t>(m_rows))
{
    const JobControl quiet{.stop = job.stop, .progress = {}, .threads = job.threads}; // progress is the caller's to report
    parallelRows(m_rows, quiet, [&](int first, int last) {
        for (int y = first; y < last; ++y)
            for (int x = 0; x < m_columns; ++x)
                m_values[static_cast<size_t>(y) * static_cast<size_t>(m_columns) + static_cast<size_t>(x)] = texelSolidAngle(layout, x, y);
    });
}

Texel acrossSeam(const MapLayout& layout, Texel chart, int x, int y) { return mapping(layout.kind).acrossSeam(layout, chart, x, y); }

} // namespace mirrorball
