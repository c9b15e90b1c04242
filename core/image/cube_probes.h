#pragma once

#include <glm/glm.hpp>

namespace mirrorball {

/// The built-in probes that are the inside of a cube (builtin_probes.h says what they show): the wall, and the place on it, that a
/// direction meets decide its color. RGB radiance from the unit direction d.
glm::dvec3 cubeRoomRadiance(const glm::dvec3& d);
glm::dvec3 axesRadiance(const glm::dvec3& d);

} // namespace mirrorball
