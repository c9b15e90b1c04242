#pragma once

#include "environment_map.h"

#include "core/base/job.h"

#include <vector>

namespace mirrorball {

/// An environment map and its halvings. Level i + 1 has half the size of level i, rounded down; the last has size 1.
/// A paraboloid's border is halved too, rounded up: each level's own layout says which directions its texels stand for.
struct MipPyramid {
    std::vector<EnvironmentMap> levels{};
};

/// Levels down to size 1: floor(log2(size)) + 1.
int levelCount(const MapLayout& base);
/// The layout of a level of a chain: size halved `level` times, rounded down, at least 1; a border halved as often, rounded up.
MapLayout levelLayout(const MapLayout& base, int level);

/// Builds the pyramid. Each level is a box average weighted by solid angle, after every texel beside a box's edge has exchanged radiance
/// with its neighbor over that edge: [1 3 3 1]/8 across each pair, over seams, poles, cube edges and disc rims as well as inside, so no
/// level shows where the charts meet.
/// A constant map stays constant, and the mean radiance of every level is that of the map: both to the rounding of float.
/// @throws InvalidArgument for a layout out of range; Cancelled
MipPyramid buildMipPyramid(const EnvironmentMap& map, const JobControl& job = {});

/// The pyramid of a cube as gluBuild2DMipmaps and the drivers of 2002 made it: each face by itself, in boxes of 2 x 2 texels without
/// weights, so that levels do not fit together at the edges of faces. It is what 002 section 3 warns of; for comparison only. An odd last
/// row or column is dropped. A constant map stays constant.
/// @throws InvalidArgument unless the map is a cube; Cancelled
MipPyramid buildFacePyramid(const EnvironmentMap& cube, const JobControl& job = {});

/// Trilinear lookup: bilinear and seamless in the two levels beside `level`, which is clamped to [0, last].
glm::vec3 radiance(const MipPyramid& pyramid, const glm::dvec3& d, double level);

} // namespace mirrorball
