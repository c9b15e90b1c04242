#pragma once

#include "core/sphere/direction.h"
#include "core/sphere/parameterization.h"

#include <cmath>
#include <random>
#include <vector>

namespace mirrorball::test {

/// Directions spread uniformly over the sphere, the same ones on every run.
inline std::vector<glm::dvec3> randomDirections(int count, unsigned seed = 1)
{
    std::mt19937 engine(seed);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    std::vector<glm::dvec3> directions;
    for (int i = 0; i < count; ++i) {
        const double z = 2.0 * uniform(engine) - 1.0;
        const double phi = 2.0 * pi * uniform(engine);
        const double r = std::sqrt(1.0 - z * z);
        directions.emplace_back(r * std::cos(phi), r * std::sin(phi), z);
    }
    return directions;
}

/// The six axes, the twelve edge and the eight corner directions of the cube: where mappings have their seams and poles.
inline std::vector<glm::dvec3> specialDirections()
{
    std::vector<glm::dvec3> directions;
    for (int x = -1; x <= 1; ++x)
        for (int y = -1; y <= 1; ++y)
            for (int z = -1; z <= 1; ++z)
                if (x != 0 || y != 0 || z != 0)
                    directions.push_back(glm::normalize(glm::dvec3(x, y, z)));
    return directions;
}

/// Every kind at a size, with a border where there can be one.
inline std::vector<MapLayout> layoutsOfSize(int size)
{
    std::vector<MapLayout> layouts;
    for (const auto kind : allParameterizations)
        layouts.push_back({kind, size, 0});
    for (const auto kind : allParameterizations)
        if (size > 2 && mapping(kind).hasBorder)
            layouts.push_back({kind, size, 1});
    return layouts;
}

inline std::string describe(const MapLayout& layout)
{
    return std::string(name(layout.kind)) + " of size " + std::to_string(layout.size) + ", border " + std::to_string(layout.border);
}

} // namespace mirrorball::test
