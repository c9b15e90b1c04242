#pragma once

#include "core/filter/ring_grid.h"
#include "support/directions.h"
#include "support/probe_builders.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace mirrorball::test {

// Probes, places and values for the tests of lobes that are split into a near and a far part.

/// Noise with a sun of 1e5 in one texel.
inline EnvironmentMap sunny(int height)
{
    EnvironmentMap probe = noiseProbe(height, 5);
    std::fill_n(probe.image.texel(height / 2, height / 3), 3, 1e5f);
    return probe;
}

/// Random directions, poles, the seam (-Z) to either side and from it, and the corners, edges and axes of a cube.
inline std::vector<glm::dvec3> directions(int random)
{
    std::vector<glm::dvec3> all = randomDirections(random), special = specialDirections();
    all.insert(all.end(), special.begin(), special.end());
    for (const glm::dvec3& d : {glm::dvec3(1e-12, 1, 0), glm::dvec3(0, -1, 1e-9), glm::dvec3(1e-9, 0.1, -1), glm::dvec3(-1e-9, 0.1, -1),
                                glm::dvec3(1e-3, 1, 1e-3), glm::dvec3(0.01, -1, 0.02)})
        all.push_back(glm::normalize(d));
    return all;
}

inline SpherePoint placeOf(const glm::dvec3& d)
{
    const double lon = std::atan2(d.x, d.z);
    return {.azimuth = pi - lon, .colatitude = std::atan2(std::sqrt(d.x * d.x + d.z * d.z), d.y)};
}

/// Of all texels, row by row.
inline std::vector<glm::dvec3> valuesOf(const EnvironmentMap& map)
{
    std::vector<glm::dvec3> values;
    for (size_t i = 0; i < map.image.texels.size(); i += 3)
        values.emplace_back(map.image.texels[i], map.image.texels[i + 1], map.image.texels[i + 2]);
    return values;
}

} // namespace mirrorball::test
