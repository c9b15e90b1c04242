#pragma once

#include "core/scene/scene_kinds.h"

#include <glm/glm.hpp>

namespace mirrorball::preview {

/// A camera that orbits a target. A value; CameraSettings is the same in degrees, which stand in files as they were typed. Yaw and pitch
/// are the longitude and latitude of the eye seen from the target: 0, 0 looks from +Z towards -Z with +X on the right; yaw turns the eye
/// towards +X, pitch towards +Y.
struct Camera {
    float yaw = 0.0f;         ///< radians
    float pitch = 0.0f;       ///< radians, in [-pi/2, pi/2]
    float roll = 0.0f;        ///< radians about the view, counterclockwise seen from behind the camera
    float distance = 3.2f;    ///< from the target, > 0
    float fieldOfView = 0.7f; ///< radians, from bottom to top, in (0, pi)
    glm::vec3 target{0.0f};
    Projection projection = Projection::Perspective;

    bool operator==(const Camera&) const = default;

    glm::vec3 eye() const;
    /// Rotation from the camera's axes (x right, y up, z towards the viewer) to the world's.
    glm::mat3 cameraToWorld() const;
    /// World to clip space; the depth range encloses a sphere of this radius about the target.
    glm::mat4 worldToClip(float aspect, float radius) const;
    /// tan of half the angle of view across and up. An orthographic camera sees the background in the same angle, not in one direction.
    glm::vec2 halfExtent(float aspect) const;
    /// (eye, 1), or for an orthographic camera (direction towards the viewer, 0).
    glm::vec4 viewer() const;
};

} // namespace mirrorball::preview
