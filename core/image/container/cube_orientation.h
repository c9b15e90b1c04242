#pragma once

#include "core/image/image.h"

#include <glm/glm.hpp>

namespace mirrorball {

/// How an engine stores our environment in the faces of a cube: the texel at (face, s, t), row 0 being t = -1, holds
///   L(axes e), e = facePoint(face, s, t), or facePoint(face, s, -t) where the rows stand bottom up.
/// `axes` is a signed permutation of the axes, so that texels are moved and never mixed.
struct CubeOrientation {
    glm::dmat3 axes{1.0};
    bool bottomUp = false;

    bool operator==(const CubeOrientation&) const = default;
};

/// Faces mirrored in x, as clients with a left-handed cube lookup need them in a right-handed world.
inline CubeOrientation mirroredInX() { return {.axes = glm::dmat3(-1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0)}; }
/// The same for an axis z.
inline CubeOrientation mirroredInZ() { return {.axes = glm::dmat3(1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, -1.0)}; }

/// The faces, N x 6N in our convention, as the engine stores them.
Image toStored(const Image& ours, const CubeOrientation& orientation);
/// The inverse.
Image fromStored(const Image& stored, const CubeOrientation& orientation);

} // namespace mirrorball
