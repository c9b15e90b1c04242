#pragma once

#include "environment_map.h"

#include "core/base/job.h"

#include <glm/glm.hpp>

#include <span>
#include <string_view>

/// Light probes that are computed, so that everything works with no file at hand. Each is a function of direction, known at every
/// point; an EnvironmentMap of it is an area average of that function over each texel.
namespace mirrorball {

/// One built-in probe.
struct BuiltinProbe {
    std::string_view name;                       ///< what follows "builtin:" on the command line
    std::string_view description;                ///< one sentence
    glm::dvec3 (*radiance)(const glm::dvec3& d); ///< RGB radiance from the unit direction d: finite and not negative everywhere
};

/// studio, sky, cube-room, axes; in that order.
///
/// * studio: a gray photographic studio; the camera is thought at +Z, the key light up at its left (-X), the backdrop at -Z.
/// * sky: clear daylight of Preetham et al. 1999 with the sun's disc. One unit of radiance is 10 kcd/m^2.
/// * cube-room: the view from the center of a colored cube, 000 figures 1 and 5. Luminance rises -Y -Z +X -X +Z +Y, each about
///   1.8 times the one before, so that the walls can be told apart without seeing hue.
/// * axes: every cube face has its color (+X red, +Y green, +Z blue, the negative ones their complements), its name, an arrow to
///   its upper edge, a white upper right corner, and the names of its neighbors. All read correctly for an observer inside who
///   looks at the face's center with +Y up; for +Y with -Z up and for -Y with +Z up (the head tilted from +Z). Images
///   that are seen from outside show it mirrored: OpenGL's cube faces, the sphere map, the front paraboloid. Latlong and angular
///   map show it as it is.
std::span<const BuiltinProbe> builtinProbes();

/// The probe of that name. @throws InvalidArgument naming the known ones
const BuiltinProbe& builtinProbe(std::string_view name);

inline constexpr MapLayout builtinProbeLayout{Parameterization::Latlong, 512, 0};

/// The probe as a map: the solid-angle-weighted mean of its radiance over each texel. Texels are supersampled where neighbors
/// differ, and all of them in small maps; the sun is splatted, so its radiance integral is the same at any size and in any
/// parameterization. Texels that lie outside a disc take the color of the continued mapping.
/// @throws InvalidArgument for an unknown name (naming the known ones) or a bad layout; Cancelled
EnvironmentMap renderBuiltinProbe(std::string_view name, const MapLayout& layout = builtinProbeLayout, const JobControl& job = {});

} // namespace mirrorball
