#pragma once

#include "core/image/environment_map.h"

#include <cmath>
#include <memory>
#include <random>
#include <vector>

/// Small environments to look things up in.
namespace mirrorball::test {

/// A map of this layout filled from a function of direction.
template <class Radiance>
EnvironmentMap environmentFrom(const MapLayout& layout, const Radiance& radiance)
{
    EnvironmentMap map(layout);
    for (int y = 0; y < map.image.height; ++y)
        for (int x = 0; x < map.image.width; ++x) {
            const glm::vec3 value = radiance(texelDirection(layout, x, y));
            std::copy(&value.x, &value.x + 3, map.image.texel(x, y));
        }
    return map;
}

/// Every direction differs from every other, smoothly.
inline glm::vec3 smoothRadiance(const glm::dvec3& d)
{
    return {1.0 + 0.5 * d.x + 0.2 * d.y * d.z, 1.0 + 0.5 * d.y - 0.2 * d.z * d.x, 1.0 + 0.5 * d.z + 0.2 * d.x * d.y};
}

/// One color per half axis: +X red, -X cyan, +Y green, -Y magenta, +Z blue, -Z yellow, the largest component deciding.
inline glm::vec3 axisColor(const glm::dvec3& d)
{
    const glm::dvec3 a = glm::abs(d);
    if (a.x >= a.y && a.x >= a.z)
        return d.x > 0 ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 1);
    if (a.y >= a.z)
        return d.y > 0 ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 1);
    return d.z > 0 ? glm::vec3(0, 0, 1) : glm::vec3(1, 1, 0);
}

/// One layout of every kind at a size, with a border where there can be one.
inline std::vector<MapLayout> everyLayout(int size)
{
    std::vector<MapLayout> layouts;
    for (const Parameterization kind : allParameterizations)
        layouts.push_back({kind, size, mapping(kind).hasBorder ? 2 : 0});
    return layouts;
}

inline std::shared_ptr<const std::vector<EnvironmentMap>> asLevels(EnvironmentMap map)
{
    return std::make_shared<const std::vector<EnvironmentMap>>(1, std::move(map));
}

/// Directions all over the sphere, the half axes and near misses of them among them.
inline std::vector<glm::dvec3> manyDirections(int count = 5000)
{
    std::vector<glm::dvec3> directions;
    for (const double sign : {-1.0, 1.0})
        for (int axis = 0; axis < 3; ++axis)
            for (const double off : {0.0, 1e-3, -1e-3, 0.05}) {
                glm::dvec3 d(0.7 * off);
                d[axis] = sign;
                d[(axis + 1) % 3] = off;
                directions.push_back(glm::normalize(d));
            }
    std::mt19937 random(7);
    std::normal_distribution<double> normal;
    while (directions.size() < static_cast<size_t>(count))
        directions.push_back(glm::normalize(glm::dvec3(normal(random), normal(random), normal(random))));
    for (glm::dvec3& d : directions)
        d = glm::dvec3(glm::vec3(d)); // what the GPU is given
    return directions;
}

} // namespace mirrorball::test
