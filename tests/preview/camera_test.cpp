#include "core/preview/camera.h"
#include "core/sphere/direction.h"

#include <gtest/gtest.h>

using namespace mirrorball;
using namespace mirrorball::preview;

TEST(Camera, AtRestLooksFromPlusZWithPlusXOnTheRight)
{
    const Camera camera;
    EXPECT_NEAR(camera.eye().z, camera.distance, 1e-6f);
    const glm::mat4 m = camera.worldToClip(1.5f, 1.0f);
    const auto onScreen = [&](const glm::vec3& p) { return glm::vec2(m * glm::vec4(p, 1.0f)) / (m * glm::vec4(p, 1.0f)).w; };
    EXPECT_LT(glm::length(onScreen({0, 0, 0})), 1e-6f);
    EXPECT_GT(onScreen({0.5f, 0, 0}).x, 0.1f);
    EXPECT_GT(onScreen({0, 0.5f, 0}).y, 0.1f);
}

TEST(Camera, AxesAreARightHandedFrameAtEveryAngle)
{
    for (float yaw = -7.0f; yaw < 7.0f; yaw += 0.61f)
        for (const float pitch : {-1.5707963f, -1.0f, 0.0f, 0.3f, 1.5707963f}) {
            const Camera camera{.yaw = yaw, .pitch = pitch};
            const glm::mat3 m = camera.cameraToWorld();
            EXPECT_NEAR(glm::determinant(m), 1.0f, 1e-5f);
            EXPECT_NEAR(glm::dot(m[0], m[1]), 0.0f, 1e-6f);
            EXPECT_LT(glm::distance(m[2], glm::vec3(directionFromLonLat(yaw, pitch))), 1e-6f);
            EXPECT_GE(m[1].y, -1e-6f) << "up stays up";
        }
}

TEST(Camera, OrthographicShowsTheTargetAtTheSameSize)
{
    Camera camera{.yaw = 0.4f, .pitch = 0.2f};
    const glm::vec3 p = 0.01f * camera.cameraToWorld()[0];
    const auto x = [&] {
        const glm::vec4 clip = camera.worldToClip(1.0f, 1.0f) * glm::vec4(p, 1.0f);
        return clip.x / clip.w;
    };
    const float perspective = x();
    camera.projection = Projection::Orthographic;
    EXPECT_NEAR(x() / perspective, 1.0f, 1e-4f);
}
