#include "core/preview/eye_frame.h"
#include "core/preview/renderer.h"

#include "gl_fixture.h"
#include "test_environments.h"

#include "core/sphere/direction.h"

#include <cmath>
#include <random>

using namespace mirrorball;
using namespace mirrorball::preview;
using namespace mirrorball::test;

using Pick = mirrorball::test::GlTest;

namespace {

RenderSettings view(GeometryKind kind)
{
    RenderSettings settings;
    settings.width = 160;
    settings.height = 120;
    settings.samples = 4;
    settings.geometry.kind = kind;
    settings.camera = Camera{.yaw = 0.6f, .pitch = 0.35f, .roll = 0.2f, .distance = 3.0f, .target = {0.1f, -0.05f, 0.2f}};
    return settings;
}

} // namespace

TEST_F(Pick, IsWhatTheBuffersHoldInThatPixel)
{
    Renderer renderer;
    for (const Projection projection : {Projection::Perspective, Projection::Orthographic}) {
        RenderSettings settings = view(GeometryKind::Teapot);
        settings.camera.projection = projection;
        settings.yaw = 0.7f;
        const GeometryBuffers buffers = renderer.renderBuffers(settings);
        int hits = 0;
        for (int y = 3; y < settings.height; y += 13)
            for (int x = 2; x < settings.width; x += 11) {
                const auto hit = renderer.pick(settings, x, y);
                ASSERT_EQ(hit.has_value(), buffers.position.texel(x, y)[3] == 1.0f) << x << ' ' << y;
                if (!hit)
                    continue;
                ++hits;
                // Vertices snap to a grid of 1/256 pixel from the target's corner: another corner, other last digits.
                const auto at = [&](const Image& image) {
                    return glm::vec3(image.texel(x, y)[0], image.texel(x, y)[1], image.texel(x, y)[2]);
                };
                EXPECT_LT(glm::distance(hit->position, at(buffers.position)), 2e-4f);
                EXPECT_LT(glm::distance(hit->normal, at(buffers.normal)), 2e-4f);
                EXPECT_LT(glm::distance(hit->lookup, at(buffers.direction)), 2e-4f);
                EXPECT_LT(glm::distance(hit->lookup, glm::vec3(yawed(glm::dvec3(hit->reflected), -settings.yaw))), 1e-5f);
            }
        EXPECT_GT(hits, 15);
    }
}

TEST_F(Pick, RefusesPixelsOutsideThePicture)
{
    Renderer renderer;
    const RenderSettings settings = view(GeometryKind::Sphere);
    EXPECT_THROW(renderer.pick(settings, 160, 0), InvalidArgument);
    EXPECT_THROW(renderer.pick(settings, 0, -1), InvalidArgument);
}

TEST(EyeFrame, IsATurnThatBringsTheViewToZByTheShortestWay)
{
    std::mt19937 random(5);
    std::normal_distribution<double> normal;
    const auto unit = [&] { return glm::normalize(glm::dvec3(normal(random), normal(random), normal(random))); };
    for (int i = 0; i < 1000; ++i) {
        glm::dvec3 v = unit();
        v.z = std::abs(v.z);
        const glm::dvec3 a = unit(), b = unit();
        EXPECT_LT(glm::distance(aboutViewRay(v, v), glm::dvec3(0, 0, 1)), 1e-12);
        EXPECT_NEAR(glm::dot(aboutViewRay(v, a), aboutViewRay(v, b)), glm::dot(a, b), 1e-12);
        EXPECT_NEAR(aboutViewRay(v, a).z, glm::dot(v, a), 1e-12);
        const glm::dvec3 axis(-v.y, v.x, 0.0); // across v and Z: what the shortest way leaves where it is
        EXPECT_LT(glm::distance(aboutViewRay(v, axis), axis), 1e-12);
        EXPECT_EQ(aboutViewRay({0, 0, 1}, a), a);
    }
}

TEST_F(Pick, TheFrameOfTheShaderIsTheOneOfCore)
{
    std::vector<glm::vec4> inputs;
    for (const glm::dvec3& d : manyDirections(500))
        inputs.emplace_back(glm::vec3(d), 0.0f);
    const auto results = evaluateGlsl(
        "#include \"lib/eye_frame.glsl\"\nvec4 twin(vec4 d) { return vec4(aboutViewRay(vec3(0.48, -0.6, 0.64), d.xyz), 0.0); }", inputs);
    for (size_t i = 0; i < inputs.size(); ++i)
        ASSERT_LT(glm::distance(glm::dvec3(results[i]), aboutViewRay({0.48, -0.6, 0.64}, glm::dvec3(inputs[i]))), 1e-6);
}
