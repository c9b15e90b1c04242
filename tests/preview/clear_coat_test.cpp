#include "core/scene/plan.h"
#include "core/shading/fresnel.h"

#include "gl_fixture.h"
#include "scene_picture.h"
#include "test_environments.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <string>

namespace mirrorball {
namespace {

using ClearCoat = test::GlTest;

constexpr int edge = 96;

/// A ball alone, seen so that its normals are those of the picture's plane.
Scene ball()
{
    Scene scene;
    scene.view.geometry = "sphere";
    scene.view.tessellation = 64;
    scene.view.width = scene.view.height = edge;
    scene.view.background.kind = Backdrop::None;
    scene.view.camera = {.yawDeg = 0.0, .pitchDeg = 0.0, .distance = 3.0, .projection = Projection::Orthographic};
    scene.map.size = 64;
    return scene;
}

EnvironmentMap sky(bool isWhite)
{
    return test::environmentFrom({Parameterization::Latlong, 64, 0}, [isWhite](const glm::dvec3& d) {
        return isWhite ? glm::vec3(1.0f) : glm::vec3(1.0 + 0.9 * d.x, 0.6 + 0.5 * d.y, 1.2 - 0.8 * d.z * d.z);
    });
}

/// Pixels that lie wholly on the ball, with the cosine between normal and viewer.
template <typename Use>
void overTheBall(const test::ScenePicture& picture, Use use)
{
    int pixels = 0;
    for (int y = 0; y < edge; y += 3)
        for (int x = 0; x < edge; x += 3)
            if (const float* n = picture.buffers.normal.texel(x, y); n[3] == 1.0f && n[2] > 0.1f) {
                ++pixels;
                use(x, y, static_cast<double>(n[2]));
            }
    ASSERT_GT(pixels, 300);
}

// What the coat reflects does not get below it: white paint in a white furnace stays white, whatever the coat.
TEST_F(ClearCoat, MakesNoLightAndLosesNone)
{
    Scene scene = ball();
    scene.material.specular.weight = 0.0;
    scene.material.diffuse = {.weight = 1.0, .color = glm::dvec3(1.0)};
    for (const double index : {1.1, 4.0})
        for (const double weight : {0.3, 1.0}) {
            scene.material.clearCoat = {.weight = weight, .index = index};
            const test::ScenePicture picture = test::drawScene(scene, sky(true));
            overTheBall(picture, [&](int x, int y, double) {
                EXPECT_NEAR(picture.radiance.texel(x, y)[1], 1.0, 2e-3) << index << ' ' << weight << " at " << x << ',' << y;
            });
        }
}

// The picture of both layers is that of each alone, by the Fresnel term of the coat: a sharp reflection on a soft one.
TEST_F(ClearCoat, LiesOverAGlossyLobe)
{
    Scene below = ball();
    below.material.specular = {.lobe = SurfaceLobe::Ggx, .roughness = 0.6, .color = {0.9, 0.4, 0.2}};
    Scene mirror = ball(), both = below;
    both.material.clearCoat = {.weight = 0.8, .index = 2.0};
    const EnvironmentMap probe = sky(false);
    const test::ScenePicture one = test::drawScene(below, probe), other = test::drawScene(mirror, probe),
                             picture = test::drawScene(both, probe);
    overTheBall(picture, [&](int x, int y, double cosine) {
        const double f = 0.8 * fresnelDielectric(cosine, 2.0);
        for (int c = 0; c < 3; ++c) {
            const double wanted = f * other.radiance.texel(x, y)[c] + (1.0 - f) * one.radiance.texel(x, y)[c];
            EXPECT_NEAR(picture.radiance.texel(x, y)[c], wanted, 3e-3 * wanted) << x << ',' << y;
        }
    });
}

// As one lobe more it takes nothing from what is below: the sum of both pictures.
TEST_F(ClearCoat, AddsALobeWhereAskedTo)
{
    Scene below = ball();
    below.material.specular = {.lobe = SurfaceLobe::Ggx, .roughness = 0.6, .color = {0.9, 0.4, 0.2}};
    Scene mirror = ball(), both = below;
    both.material.clearCoat = {.weight = 0.8, .index = 2.0, .combine = Combine::Add};
    const EnvironmentMap probe = sky(false);
    const test::ScenePicture one = test::drawScene(below, probe), other = test::drawScene(mirror, probe),
                             picture = test::drawScene(both, probe);
    overTheBall(picture, [&](int x, int y, double cosine) {
        for (int c = 0; c < 3; ++c) {
            const double wanted = 0.8 * fresnelDielectric(cosine, 2.0) * other.radiance.texel(x, y)[c] + one.radiance.texel(x, y)[c];
            EXPECT_NEAR(picture.radiance.texel(x, y)[c], wanted, 3e-3 * wanted) << x << ',' << y;
        }
    });
}

// A glossy coat over a mirror is as blurred as a glossy material, and the map is made for it.
TEST_F(ClearCoat, HasALobeOfItsOwn)
{
    Scene gloss = ball(), coated = ball();
    gloss.material.specular = {.lobe = SurfaceLobe::Phong, .exponent = 20.0};
    coated.material.specular.weight = 0.0;
    coated.material.clearCoat = {.weight = 1.0, .index = 1e6, .lobe = SurfaceLobe::Phong, .exponent = 20.0}; // F is 1 but for 4e-6
    const EnvironmentMap probe = sky(false);
    const test::ScenePicture wanted = test::drawScene(gloss, probe), picture = test::drawScene(coated, probe);
    overTheBall(picture, [&](int x, int y, double) {
        EXPECT_NEAR(picture.radiance.texel(x, y)[0], wanted.radiance.texel(x, y)[0], 2e-3 * wanted.radiance.texel(x, y)[0])
            << x << ',' << y;
    });
}

TEST_F(ClearCoat, IsPaidForWhereItIsSeenAlone)
{
    const MapLayout probe{Parameterization::Latlong, 512, 0};
    const auto stage = [&](const Scene& scene) -> const PlannedStage* {
        static Plan plan;
        plan = makePlan(scene, probe);
        const auto found = std::find_if(plan.decisions.begin(), plan.decisions.end(),
                                        [](const PlannedStage& s) { return s.name.find("clear coat") != std::string::npos; });
        return found == plan.decisions.end() ? nullptr : &*found;
    };
    Scene scene;
    EXPECT_FALSE(stage(scene)) << "of what there is not nothing is said";
    scene.material.clearCoat.weight = 0.5;
    ASSERT_TRUE(stage(scene));
    EXPECT_TRUE(makePlan(scene, probe).clearCoat);
    scene.material.clearCoat.index = 1.0;
    ASSERT_TRUE(stage(scene));
    EXPECT_TRUE(stage(scene)->isLeftOut);
    EXPECT_FALSE(makePlan(scene, probe).clearCoat);
    scene.material.clearCoat.index = 1.5;
    scene.view.shading = Shading::Normals;
    ASSERT_TRUE(stage(scene));
    EXPECT_TRUE(stage(scene)->isLeftOut);
    scene.view.shading = Shading::Material;
    scene.material.sphereMap = {.source = "jade", .use = SphereMapUse::Replace};
    EXPECT_FALSE(makePlan(scene, probe).clearCoat);
    scene.material.sphereMap.use = SphereMapUse::Add;
    EXPECT_TRUE(makePlan(scene, probe).clearCoat);
    // As with the material's own reflection: no larger than its lobe needs, and in haste where its spectrum is long no better than that.
    scene.material.clearCoat = {.weight = 1.0, .lobe = SurfaceLobe::Phong, .exponent = 5.0};
    EXPECT_LT(makePlan(scene, probe).clearCoat->filters.front().options.target.size, scene.map.size);
    scene.material.clearCoat.exponent = 5000.0;
    EXPECT_EQ(makePlan(scene, probe, {.detail = coarseDetail}).clearCoat->filters.front().options.tolerance, coarseDetail.longTolerance);
}

} // namespace
} // namespace mirrorball
