#include "camera.h"

#include "core/sphere/direction.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>

namespace mirrorball::preview {

glm::vec3 Camera::eye() const { return target + distance * cameraToWorld()[2]; }

// The derivatives of directionFromLonLat along longitude (divided by its cosine) and latitude are the axes to the right and up: at
// the poles, too, where a look-at construction has no up.
glm::mat3 Camera::cameraToWorld() const
{
    const glm::vec3 towardsEye = directionFromLonLat(yaw, pitch);
    const glm::vec3 right(std::cos(yaw), 0.0f, -std::sin(yaw));
    const glm::vec3 up(-std::sin(yaw) * std::sin(pitch), std::cos(pitch), -std::cos(yaw) * std::sin(pitch));
    const float c = std::cos(roll), s = std::sin(roll);
    return {c * right + s * up, c * up - s * right, towardsEye};
}

glm::mat4 Camera::worldToClip(float aspect, float radius) const
{
    const glm::mat4 worldToCamera = glm::mat4(glm::transpose(cameraToWorld())) * glm::translate(glm::mat4(1.0f), -eye());
    if (projection == Projection::Orthographic) {
        const glm::vec2 half = distance * halfExtent(aspect);
        return glm::ortho(-half.x, half.x, -half.y, half.y, distance - radius, distance + radius) * worldToCamera;
    }
    const float near = std::max(distance - radius, 0.01f * distance);
    return glm::perspective(fieldOfView, aspect, near, std::max(distance + radius, 2.0f * near)) * worldToCamera;
}

glm::vec2 Camera::halfExtent(float aspect) const
{
    const float up = std::tan(0.5f * fieldOfView);
    return {aspect * up, up};
}

glm::vec4 Camera::viewer() const
{
    return projection == Projection::Orthographic ? glm::vec4(cameraToWorld()[2], 0.0f) : glm::vec4(eye(), 1.0f);
}

} // namespace mirrorball::preview
