#pragma once

#include <glm/glm.hpp>

namespace mirrorball {

/// The built-in probe `studio` (builtin_probes.h): soft boxes, a strip and black cards, each a flat panel in a gray room. RGB radiance from
/// the unit direction d.
glm::dvec3 studioRadiance(const glm::dvec3& d);

} // namespace mirrorball
