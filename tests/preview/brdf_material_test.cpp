#include "core/preview/renderer.h"
#include "core/preview/scene_settings.h"

#include "gl_fixture.h"
#include "scene_picture.h"
#include "test_environments.h"

#include "core/base/error.h"
#include "core/filter/brdf_sum.h"
#include "core/filter/filter_source.h"
#include "core/shading/reflection_kernel.h"

#include <algorithm>
#include <cmath>
#include <numeric>

// A BRDF in the scene's material, as the picture shows it: against the integral over every texel of the probe.

using namespace mirrorball;
using namespace mirrorball::preview;
using namespace mirrorball::test;

using BrdfMaterial = mirrorball::test::GlTest;

namespace {

constexpr int edge = 48;

Scene ballOf(const std::string& model, int lookups)
{
    Scene scene;
    scene.material.brdf = {.model = model, .lookups = lookups};
    scene.view.geometry = "sphere";
    scene.view.tessellation = 64;
    scene.view.camera.projection = Projection::Orthographic;
    scene.view.background.kind = Backdrop::None;
    scene.view.width = scene.view.height = edge;
    return scene;
}

Scene exactBallOf(const std::string& model)
{
    Scene scene = ballOf(model, 5);
    scene.material.brdf.kind = LookupKind::Exact;
    return scene;
}

// A lamp and a strip of light over a dim sky, small enough to be summed over at every pixel.
EnvironmentMap smallProbe()
{
    return environmentFrom({Parameterization::Latlong, 64, 0}, [](const glm::dvec3& d) {
        const double lamp = std::exp(40.0 * (glm::dot(d, glm::normalize(glm::dvec3(0.5, 0.7, 0.6))) - 1.0));
        const double strip = std::exp(-30.0 * d.y * d.y) * (d.x > 0.0 ? 1.0 : 0.3);
        return glm::vec3(float(0.2 + 6.0 * lamp + strip), float(0.25 + 5.0 * lamp + 0.5 * strip), float(0.3 + 4.0 * lamp));
    });
}

EnvironmentMap whiteSky()
{
    return environmentFrom({Parameterization::Latlong, 32, 0}, [](const glm::dvec3&) { return glm::vec3(1.0f); });
}

glm::dvec3 at(const Image& image, int x, int y)
{
    const float* t = image.texel(x, y);
    return {t[0], t[1], t[2]};
}

/// The share of the picture's light that is wrong, root mean square over every third pixel seen at views of [from, to) degrees.
double errorOf(const ScenePicture& picture, const Brdf& brdf, const EnvironmentMap& probe, double from, double to)
{
    double wrong = 0.0, right = 0.0;
    int seen = 0;
    for (int y = 0; y < edge; y += 3)
        for (int x = 0; x < edge; x += 3) {
            if (picture.buffers.normal.texel(x, y)[3] != 1.0f)
                continue;
            const glm::dvec3 n = glm::normalize(at(picture.buffers.normal, x, y));
            const double nv = glm::dot(n, picture.toViewer), view = std::acos(std::clamp(nv, -1.0, 1.0));
            if (!(view >= glm::radians(from) && view < glm::radians(to)))
                continue;
            const glm::dvec3 r = glm::normalize(2.0 * nv * n - picture.toViewer);
            const glm::dvec3 truth = BrdfSum(probe, brdf, view).at(std::span(&n, 1), std::span(&r, 1)).front();
            const glm::dvec3 error = at(picture.radiance, x, y) - truth;
            wrong += glm::dot(error, error);
            right += glm::dot(truth, truth);
            ++seen;
        }
    EXPECT_GT(seen, 10);
    return std::sqrt(wrong / right);
}

} // namespace

// In white light of 1 the reflected radiance is the directional albedo, for any number of lookups.
TEST_F(BrdfMaterial, UnderAWhiteSkyShowsItsDirectionalAlbedo)
{
    const EnvironmentMap white = whiteSky();
    const std::string model = "ggx:roughness=0.6,f0=0.7";
    const Brdf brdf = brdfFromText(model);
    for (const int lookups : {0, 3, 5}) {
        const ScenePicture picture = drawScene(ballOf(model, lookups), white);
        int seen = 0;
        for (int y = 0; y < edge; y += 2)
            for (int x = 0; x < edge; x += 2) {
                const glm::dvec3 n = at(picture.buffers.normal, x, y);
                const double nv = glm::dot(n, picture.toViewer);
                if (picture.buffers.normal.texel(x, y)[3] != 1.0f || nv < 0.1) // nearer to the rim the table's columns are far apart
                    continue;
                const glm::dvec3 albedo = directionalAlbedo(brdf, std::acos(std::min(nv, 1.0)));
                for (int c = 0; c < 3; ++c)
                    EXPECT_NEAR(at(picture.radiance, x, y)[c], albedo[c], 0.01) << lookups << " lookups, n.v " << nv;
                ++seen;
            }
        EXPECT_GT(seen, 100);
    }
}

TEST_F(BrdfMaterial, DrawnExactlyIsTheIntegralAtEveryPixel)
{
    const EnvironmentMap probe = smallProbe();
    for (const char* model : {"ggx:roughness=0.5,metal=gold", "ggx:roughness=0.7"}) {
        const Brdf brdf = brdfFromText(model);
        Scene scene = exactBallOf(model);
        scene.probe.yawDeg = 0.0;
        const ScenePicture picture = drawScene(scene, probe);
        EXPECT_LT(errorOf(picture, brdf, probe, 0.0, 45.0), 0.01) << model;
        EXPECT_LT(errorOf(picture, brdf, probe, 45.0, 75.0), 0.01) << model;
        EXPECT_LT(errorOf(picture, brdf, probe, 75.0, 87.0), 0.03) << model;
    }
}

// The same light comes to the same surface, whether the environment turns with the camera or stands.
TEST_F(BrdfMaterial, DrawnExactlyInEyeSpaceHasTheTurnOfTheProbeInItsMaps)
{
    const EnvironmentMap probe = smallProbe();
    Scene scene = exactBallOf("ggx:roughness=0.5");
    scene.view.camera = {.yawDeg = 0.0, .pitchDeg = 0.0, .distance = scene.view.camera.distance, .projection = Projection::Orthographic};
    scene.probe.yawDeg = 50.0;
    const Image world = drawScene(scene, probe).radiance;
    scene.map.space = MapSpace::Eye;
    const Image eye = drawScene(scene, probe).radiance;
    for (size_t i = 0; i < world.texels.size(); ++i)
        EXPECT_NEAR(eye.texels[i], world.texels[i], 0.01f * world.texels[i] + 1e-3f);
}

// White under a white sky, below a coat of the same light: whatever is reflected, all of it comes back.
TEST_F(BrdfMaterial, DrawnExactlyIsACoatAndLiesBelowOne)
{
    Scene scene = exactBallOf("ggx:roughness=0.45,ior=1.5");
    scene.material.combine = Combine::Coat;
    scene.material.diffuse = {.weight = 1.0, .color = glm::dvec3(1.0)};
    scene.material.clearCoat.weight = 1.0;
    const ScenePicture picture = drawScene(scene, whiteSky());
    for (int y = 0; y < edge; y += 3)
        for (int x = 0; x < edge; x += 3)
            if (picture.buffers.normal.texel(x, y)[3] == 1.0f) {
                EXPECT_NEAR(picture.radiance.texel(x, y)[0], 1.0, 2e-3);
            }
}

// A white metal under a white sky: three and Filament add what bounces more than once, all of it.
TEST_F(BrdfMaterial, OfAnEngineInAFurnaceVanishesInTheSky)
{
    for (const LookupKind kind : {LookupKind::Three, LookupKind::Filament}) {
        Scene scene = ballOf("ggx:roughness=0.8", 5);
        scene.material.brdf.kind = kind;
        const ScenePicture picture = drawScene(scene, whiteSky());
        for (int y = 0; y < edge; y += 3)
            for (int x = 0; x < edge; x += 3)
                if (picture.buffers.normal.texel(x, y)[3] == 1.0f && glm::dot(at(picture.buffers.normal, x, y), picture.toViewer) > 0.05) {
                    EXPECT_NEAR(picture.radiance.texel(x, y)[1], 1.0f, 2e-3) << describe(LookupChoice{kind});
                }
    }
}

// 000 sections 3.2.3 and 3.2.4: one round lobe is wrong where the surface is seen at an angle. The lookups are not.
TEST_F(BrdfMaterial, IsNearTheIntegralWhereTheSplitSumIsFar)
{
    const EnvironmentMap probe = smallProbe();
    for (const char* model : {"ggx:roughness=0.5,metal=gold", "ggx:roughness=0.7"}) {
        const Brdf brdf = brdfFromText(model);
        const ScenePicture lookups = drawScene(ballOf(model, 5), probe), split = drawScene(ballOf(model, 0), probe);
        EXPECT_LT(errorOf(lookups, brdf, probe, 0.0, 45.0), 0.03) << model;
        const double ours = errorOf(lookups, brdf, probe, 45.0, 75.0), theirs = errorOf(split, brdf, probe, 45.0, 75.0);
        EXPECT_LT(ours, 0.06) << model;
        EXPECT_LT(4.0 * ours, theirs) << model;
    }
}

// What the layer reflects does not get below it: under white light a coat over white paint gives all of it back.
TEST_F(BrdfMaterial, ACoatLeavesTheRestOfTheLightToThePaint)
{
    const EnvironmentMap white = environmentFrom({Parameterization::Latlong, 32, 0}, [](const glm::dvec3&) { return glm::vec3(1.0f); });
    Scene scene = ballOf("ggx:roughness=0.45,ior=1.5", 5);
    scene.material.combine = Combine::Coat;
    scene.material.diffuse = {.weight = 1.0, .color = glm::dvec3(1.0)};
    const ScenePicture picture = drawScene(scene, white);
    for (int y = 0; y < edge; y += 3)
        for (int x = 0; x < edge; x += 3)
            if (picture.buffers.normal.texel(x, y)[3] == 1.0f) {
                EXPECT_NEAR(picture.radiance.texel(x, y)[0], 1.0, 2e-3);
            }
}

TEST_F(BrdfMaterial, APlanWithoutOneIsAsBefore)
{
    const Scene without;
    const Plan plan = makePlan(without, {Parameterization::Latlong, 64, 0});
    EXPECT_FALSE(plan.brdf);
    ASSERT_TRUE(plan.specular);
    EXPECT_EQ(plan.specular->filters.size(), 1u);
    const Plan with = makePlan(ballOf("ggx:roughness=0.5", 5), {Parameterization::Latlong, 64, 0});
    ASSERT_TRUE(with.brdf);
    EXPECT_GT(with.specular->filters.size(), 4u);
    EXPECT_EQ(with.material.fresnel.kind, FresnelKind::None);
}

TEST_F(BrdfMaterial, APlanOfAnExactOneMakesItsMapsAndNoChain)
{
    const MapLayout probe{Parameterization::Latlong, 64, 0};
    Scene scene = exactBallOf("ggx:roughness=0.5");
    const Plan plan = makePlan(scene, probe);
    EXPECT_TRUE(plan.isExact() && plan.needsProbe() && plan.filtersAny());
    EXPECT_FALSE(plan.specular);
    EXPECT_EQ(plan.brdf->tolerance, 1e-2);
    const NeededMaps needed = neededMaps(renderSettings(scene, plan));
    EXPECT_TRUE(needed.viewStack);
    EXPECT_FALSE(needed.specular);
    // Where the material shows no reflection there is nothing to be exact about.
    scene.material.specular.weight = 0.0;
    EXPECT_FALSE(makePlan(scene, probe).brdf);
    scene.material.specular.weight = 1.0;
    scene.view.shading = Shading::Normals;
    EXPECT_FALSE(makePlan(scene, probe).brdf);
    scene.view.shading = Shading::Mips; // levels are those of lookups
    EXPECT_FALSE(makePlan(scene, probe).isExact());
    EXPECT_TRUE(makePlan(scene, probe).specular);
    scene.view.shading = Shading::Material;
    EXPECT_THROW(makePlan(scene, {Parameterization::Latlong, 8192, 0}), InvalidArgument);
}

TEST_F(BrdfMaterial, AModelThatIsNoneIsRefusedByItsField)
{
    try {
        validate(ballOf("ggx:rough=0.5", 5));
        FAIL();
    } catch (const InvalidArgument& error) {
        EXPECT_TRUE(std::string(error.what()).starts_with("material.brdf.model: ")) << error.what();
    }
}
