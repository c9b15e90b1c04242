#include "flecks.h"

#include <cmath>
#include <limits>
#include <numbers>

namespace mirrorball::preview {

namespace {

glm::vec3 unitFloats(const glm::uvec3& hash) { return glm::vec3(hash >> 8u) * (1.0f / 16777216.0f); }

glm::uvec3 cellHash(const glm::ivec3& cell, int seed)
{
    return pcg3d(glm::uvec3(cell) + glm::uvec3(static_cast<std::uint32_t>(seed)) * glm::uvec3(3266489917u, 668265263u, 374761393u));
}

FleckCell cellOf(const glm::uvec3& hash, const Flecks& flecks)
{
    const glm::vec3 u = unitFloats(pcg3d(hash));
    if (u.x >= static_cast<float>(flecks.density))
        return {};
    const float angle = 2.0f * std::numbers::pi_v<float> * u.y, radius = static_cast<float>(flecks.spread) * std::sqrt(u.z);
    return {radius * glm::vec2(std::cos(angle), std::sin(angle)), true};
}

} // namespace

glm::uvec3 pcg3d(glm::uvec3 v)
{
    v = v * 1664525u + 1013904223u;
    v.x += v.y * v.z;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    v ^= v >> 16u;
    v.x += v.y * v.z;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    return v;
}

// Points stay within a quarter of their cube's middle, so that the nearest one is among the eight cubes around the place.
FleckPlace fleckPlace(const glm::vec3& position, const Flecks& flecks)
{
    const glm::vec3 q = position / static_cast<float>(flecks.size);
    const glm::ivec3 corner(glm::floor(q - 0.5f));
    float nearest = std::numeric_limits<float>::max(), second = nearest;
    glm::vec3 nearestPoint(0.0f), secondPoint(0.0f);
    glm::uvec3 nearestHash(0u), secondHash(0u);
    for (int i = 0; i < 8; ++i) {
        const glm::ivec3 cell = corner + glm::ivec3(i & 1, (i >> 1) & 1, i >> 2);
        const glm::uvec3 hash = cellHash(cell, flecks.seed);
        const glm::vec3 point = glm::vec3(cell) + 0.25f + 0.5f * unitFloats(hash);
        const glm::vec3 away = q - point;
        const float distance2 = glm::dot(away, away);
        if (distance2 < nearest) {
            second = nearest;
            secondPoint = nearestPoint;
            secondHash = nearestHash;
            nearest = distance2;
            nearestPoint = point;
            nearestHash = hash;
        } else if (distance2 < second) {
            second = distance2;
            secondPoint = point;
            secondHash = hash;
        }
    }
    return {cellOf(nearestHash, flecks), cellOf(secondHash, flecks),
            (second - nearest) / (2.0f * glm::distance(nearestPoint, secondPoint))};
}

} // namespace mirrorball::preview
