#include "core/scene/plan.h"

#include "core/base/error.h"
#include "core/filter/source_file.h"
#include "core/scene/material_presets.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace mirrorball {
namespace {

using testing::HasSubstr;

constexpr MapLayout probe{Parameterization::Latlong, 512, 0};

const Stage& stage(const Plan& plan, const std::string& name)
{
    static const Stage none{.name = "none"};
    const auto found = std::find_if(plan.stages.begin(), plan.stages.end(), [&](const Stage& s) { return s.name == name; });
    if (found == plan.stages.end())
        ADD_FAILURE() << "no stage " << name;
    return found == plan.stages.end() ? none : *found;
}

void expectLeftOut(const Plan& plan, const std::string& name, const std::string& why)
{
    EXPECT_TRUE(stage(plan, name).leftOut) << name;
    EXPECT_THAT(stage(plan, name).why, HasSubstr(why));
}

void expectNeeded(const Plan& plan, const std::string& name, const std::string& why)
{
    EXPECT_FALSE(stage(plan, name).leftOut) << name;
    EXPECT_THAT(stage(plan, name).why, HasSubstr(why));
}

TEST(Plan, AMirrorNeedsNoFilterNoPyramidNoFresnelAndNoIrradiance)
{
    const Plan plan = makePlan({}, probe);
    expectNeeded(plan, "compute probe", "builtin:studio, latlong 1024 x 512");
    expectLeftOut(plan, "spectrum", "nothing is filtered");
    expectLeftOut(plan, "filter specular map", "mirror");
    expectNeeded(plan, "resample specular map", "cube 512 x 3072");
    expectLeftOut(plan, "mip levels of specular map", "lambda is 0");
    expectLeftOut(plan, "irradiance map", "diffuse weight is 0");
    expectLeftOut(plan, "resample background", "already is latlong 1024 x 512");
    expectLeftOut(plan, "fresnel term", "F is 1 at every angle");
    expectLeftOut(plan, "other maps", "no latlong, sphere, angular, paraboloid, octahedral is built");
    EXPECT_FALSE(plan.filtersAny());
    EXPECT_FALSE(plan.diffuse);
    EXPECT_TRUE(plan.exports.empty());
    for (const Stage& s : plan.stages)
        EXPECT_FALSE(s.why.empty()) << s.name;
}

TEST(Plan, AGlossyLobeIsFilteredAtItsBandLimitAndNoLargerThanItShows)
{
    Scene scene;
    scene.material.specular = {.lobe = SurfaceLobe::Phong, .exponent = 50.0};
    const Plan plan = makePlan(scene, probe);
    expectNeeded(plan, "filter specular map", "phong:50 into cube 128 x 768");
    expectNeeded(plan, "filter specular map", "512 is left out");
    expectNeeded(plan, "spectrum", "one forward transform for 1 lobe");
    EXPECT_TRUE(plan.filtersAny());
    EXPECT_EQ(plan.specular->filters.front().options.target.size, 128);
}

TEST(Plan, AnUnresolvedLobeIsALookup)
{
    Scene scene;
    scene.material.specular = {.lobe = SurfaceLobe::Phong, .exponent = 1e7};
    const Plan plan = makePlan(scene, probe);
    expectLeftOut(plan, "filter specular map", "texels wide at half maximum, under 1.5");
    expectLeftOut(plan, "spectrum", "nothing is filtered");
}

TEST(Plan, LambdaAsksForAPyramid)
{
    Scene scene;
    scene.material.lambda = 2.5;
    const Plan plan = makePlan(scene, probe);
    expectNeeded(plan, "mip levels of specular map", "lambda 2.5: 10 levels");
    EXPECT_TRUE(plan.specular->pyramid);

    Scene shrinking;
    shrinking.map.mips = true;
    expectNeeded(makePlan(shrinking, probe), "mip levels of specular map", "where reflections shrink: 10 levels");
}

TEST(Plan, ALevelBiasUpwardsAsksForAPyramid)
{
    Scene scene;
    scene.material.lodBias = 1.5;
    expectNeeded(makePlan(scene, probe), "mip levels of specular map", "LOD bias 1.5");
    scene.material.lodBias = -1.0; // sharper than the finest there is not
    expectLeftOut(makePlan(scene, probe), "mip levels of specular map", "only the finest");
}

TEST(Plan, ADebugViewNeedsNoMaterial)
{
    Scene scene;
    scene.material.diffuse.weight = 1.0;
    scene.view.background.kind = Backdrop::None;
    for (const Shading shading : {Shading::Wireframe, Shading::Normals, Shading::TexCoords, Shading::Seams}) {
        scene.view.shading = shading;
        const Plan plan = makePlan(scene, probe);
        EXPECT_FALSE(plan.needsProbe());
        expectLeftOut(plan, "specular map", "and not the material");
        expectLeftOut(plan, "irradiance map", "and not the material");
    }
    scene.view.shading = Shading::Mips;
    EXPECT_TRUE(makePlan(scene, probe).specular);
}

TEST(Plan, ASphereMapThatReplacesTheReflectionNeedsNoEnvironment)
{
    Scene scene;
    scene.view.background.kind = Backdrop::None;
    expectLeftOut(makePlan(scene, probe), "sphere map", "none is named");
    scene.material.sphereMap = {.source = "silhouette", .size = 256};
    for (const SphereMapUse use : {SphereMapUse::Replace, SphereMapUse::Multiply}) {
        scene.material.sphereMap.use = use;
        const Plan plan = makePlan(scene, probe);
        EXPECT_FALSE(plan.needsProbe());
        expectLeftOut(plan, "specular map", "stands in for the reflection");
        expectNeeded(plan, "sphere map", "silhouette, 256 x 256, authored levels");
        expectLeftOut(plan, "flecks", "density is 0");
        ASSERT_EQ(plan.sphereMaps.size(), 1u);
    }
    for (const SphereMapUse use : {SphereMapUse::Over, SphereMapUse::Tint, SphereMapUse::Add}) {
        scene.material.sphereMap.use = use;
        EXPECT_TRUE(makePlan(scene, probe).specular);
    }
}

TEST(Plan, SaysHowTheLevelsOfASphereMapAreMade)
{
    Scene scene;
    SphereMapSettings& map = scene.material.sphereMap;
    const auto why = [&] {
        for (const Stage& stage : makePlan(scene, probe).stages)
            if (stage.name == "sphere map")
                return stage.why;
        return std::string();
    };
    map = {.source = "silhouette", .size = 64}; // a line of three pixels in each level
    EXPECT_EQ(why(), "silhouette, 64 x 64, authored levels");
    map.levels = SphereMapLevels::Plain;
    EXPECT_EQ(why(), "silhouette, 64 x 64, plain levels");
    map = {.source = "jade", .size = 64};
    EXPECT_EQ(why(), "jade, 64 x 64, plain levels, for no layer is made for levels");
    SphereMapDocument own;
    own.layers = {{.content = FillLayer{}}};
    map = {.document = {std::make_shared<const SphereMapDocument>(own)}, .size = 64};
    EXPECT_EQ(why(), "the scene's own, 64 x 64, plain levels, for no layer is made for levels");
    own.layers[0].firstLevel = 2;
    map.document = {std::make_shared<const SphereMapDocument>(own)};
    EXPECT_EQ(why(), "the scene's own, 64 x 64, authored levels");
    map = {.source = "no-such/map.spheremap", .size = 64}; // not opened to make a plan
    EXPECT_EQ(why(), "no-such/map.spheremap, 64 x 64, authored levels where the file has them");
    map = {.source = "no-such/matcap.png", .size = 64};
    EXPECT_EQ(why(), "no-such/matcap.png, a picture of its own size, plain levels");
}

TEST(Plan, AWindowShowsALayerForEachSphereMapNamed)
{
    Scene scene;
    scene.view.geometry = "window";
    scene.material.sphereMap.source = "near.spheremap";
    scene.view.window.far = "far.spheremap";
    const Plan plan = makePlan(scene, probe);
    ASSERT_EQ(plan.sphereMaps.size(), 2u);
    EXPECT_EQ(plan.sphereMaps[1].source, "far.spheremap");
    expectLeftOut(plan, "sphere map, middle", "none is named");
    expectLeftOut(plan, "specular map", "no material");
}

TEST(Plan, ReadsAMeshOnlyWhereOneIsNamed)
{
    Scene scene;
    expectLeftOut(makePlan(scene, probe), "read mesh", "built in");
    scene.view.geometry = "bunny.ply";
    expectNeeded(makePlan(scene, probe), "read mesh", "bunny.ply");
}

TEST(Plan, ConstantFresnelTermsAreFoldedIntoTheColors)
{
    Scene scene;
    scene.material.diffuse.weight = 1.0;
    scene.material.combine = Combine::Coat;
    Plan plan = makePlan(scene, probe); // F = 1: nothing gets below the coat
    expectLeftOut(plan, "irradiance map", "the coat mirrors everything");
    EXPECT_EQ(plan.material.specular, glm::dvec3(1.0));

    scene.material.fresnel = {.kind = FresnelKind::Dielectric, .index = 1.0}; // F = 0
    plan = makePlan(scene, probe);
    expectLeftOut(plan, "specular map", "index of refraction is 1");
    expectLeftOut(plan, "fresnel term", "index is 1");
    expectNeeded(plan, "filter irradiance map", "diffuse into cube 64 x 384");
    EXPECT_EQ(plan.material.fresnel.kind, FresnelKind::None);
    EXPECT_EQ(plan.material.combine, Combine::Add);

    scene.material.fresnel.index = 1.5;
    plan = makePlan(scene, probe);
    expectNeeded(plan, "fresnel term", "index 1.5");
    EXPECT_TRUE(plan.specular && plan.diffuse);
}

TEST(Plan, WithoutAReflectionAddNeedsNoFresnelTermButACoatDoes)
{
    Scene scene;
    scene.material.specular.weight = 0.0;
    scene.material.diffuse.weight = 1.0;
    scene.material.fresnel.kind = FresnelKind::Dielectric;
    Plan plan = makePlan(scene, probe);
    expectLeftOut(plan, "fresnel term", "specular weight is 0");
    expectLeftOut(plan, "specular map", "specular weight is 0");
    scene.material.combine = Combine::Coat;
    plan = makePlan(scene, probe);
    expectNeeded(plan, "fresnel term", "index 1.5");
    EXPECT_FALSE(plan.specular);
}

TEST(Plan, ABlackMaterialOnAPlainBackgroundDoesNotOpenTheProbe)
{
    Scene scene;
    scene.probe.source = "light.hdr";
    scene.material.specular.color = glm::dvec3(0.0);
    scene.view.background.kind = Backdrop::Color;
    const Plan plan = makePlan(scene, probe);
    expectLeftOut(plan, "read probe", "no map is needed");
    expectLeftOut(plan, "background", "one color");
    EXPECT_FALSE(plan.needsProbe());
}

TEST(Plan, ALargeProbeIsTruncatedRowByRowWhenEveryMapIsFiltered)
{
    constexpr MapLayout large{Parameterization::Latlong, 8192, 0};
    Scene scene;
    scene.probe.source = "large.exr";
    scene.material.specular = {.lobe = SurfaceLobe::Phong, .exponent = 50.0};
    scene.view.background.kind = Backdrop::None;
    expectNeeded(makePlan(scene, large), "read probe",
                 "truncated to band limit " + std::to_string(streamedBandLimit(makePlan(scene, large).filters().front())));
    scene.view.background.kind = Backdrop::Environment;
    const Plan held = makePlan(scene, large);
    expectNeeded(held, "read probe", "held whole");
    EXPECT_EQ(held.background->filters.front().options.target.size, 2048) << "no picture shows more";
}

TEST(Plan, ExportsAreChosenByNameAndTheOthersLeftOut)
{
    Scene scene;
    scene.exports = {{.name = "env", .kind = ExportKind::Source, .mips = true},
                     {.name = "env-hdr", .kind = ExportKind::Source, .file = "flat.hdr", .mips = true},
                     {.name = "irradiance", .kind = ExportKind::Diffuse, .size = 32},
                     {.name = "chain", .kind = ExportKind::Chain, .size = 64}};
    const Plan all = makePlan(scene, probe, {.picture = false, .exports = std::vector<std::string>{}});
    EXPECT_EQ(all.exports.size(), 4u);
    expectNeeded(all, "mip levels of env", "9 levels");
    expectLeftOut(all, "mip levels of env-hdr", "flat.hdr holds none");
    expectLeftOut(all, "mip levels of irradiance", "not asked for");
    EXPECT_EQ(all.exports[3].map.filters.size(), 7u);
    expectLeftOut(all, "filter chain level 0", "roughness 0");
    expectNeeded(all, "filter chain level 6", "ggx:1 into cube 1 x 6");

    const Plan one = makePlan(scene, probe, {.picture = false, .exports = std::vector<std::string>{"irradiance"}});
    ASSERT_EQ(one.exports.size(), 1u);
    expectLeftOut(one, "export env", "not among those asked for");
    EXPECT_THROW(makePlan(scene, probe, {.picture = false, .exports = std::vector<std::string>{"irradianse"}}), InvalidArgument);
}

TEST(Plan, APaintedMapAloneLeavesTheProbeAlone)
{
    Scene scene;
    scene.material.sphereMap.source = "silhouette";
    scene.exports = {{.name = "chain", .kind = ExportKind::Painted, .size = 64, .mips = true},
                     {.name = "matcap", .kind = ExportKind::Painted, .size = 64, .border = 2, .file = "m.png"},
                     {.name = "env", .kind = ExportKind::Source}};
    const PlanRequest painted{.picture = false, .exports = std::vector<std::string>{"chain", "matcap"}};
    const PlanRequest all{.picture = false, .exports = std::vector<std::string>{}};
    EXPECT_FALSE(mayNeedProbe(scene, painted));
    EXPECT_TRUE(mayNeedProbe(scene, all));
    const Plan plan = makePlan(scene, {}, painted);
    EXPECT_FALSE(plan.needsProbe());
    EXPECT_TRUE(plan.filters().empty());
    expectLeftOut(plan, "compute probe", "no map is needed");
    expectLeftOut(plan, "export env", "not among those asked for");
    expectNeeded(plan, "paint chain", "silhouette, 64 x 64, authored levels");
    expectNeeded(plan, "paint matcap", "silhouette, 64 x 64 with a border of 2, one level");
    expectNeeded(plan, "save matcap", "m.png");
    EXPECT_TRUE(makePlan(scene, probe, all).needsProbe());

    scene.material.sphereMap = {};
    try {
        makePlan(scene, {}, {.picture = false, .exports = std::vector<std::string>{"matcap"}});
        ADD_FAILURE() << "there is nothing to paint";
    } catch (const InvalidArgument& error) {
        EXPECT_THAT(error.what(), HasSubstr("exports[1].kind: painted"));
    }
    EXPECT_NO_THROW(makePlan(scene, probe, {.picture = false, .exports = std::vector<std::string>{"env"}}));
    EXPECT_NO_THROW(makePlan(scene, probe));
}

TEST(Plan, IsMadeForEveryPresetInEveryParameterization)
{
    for (const MaterialPreset& preset : materialPresets())
        for (const Parameterization p : allParameterizations) {
            Scene scene;
            scene.material = preset.material;
            scene.map.parameterization = p;
            EXPECT_NO_THROW(makePlan(scene, probe)) << preset.name;
        }
}

TEST(Plan, LambdaByAngleIsEvaluatedOnlyWhereAskedForAndWhereLambdaHoldsALevel)
{
    Scene scene;
    scene.material.lambdaGrazing = 1.0;
    expectLeftOut(makePlan(scene, probe), "lambda by angle", "lambda is 0");
    scene.material.lambda = 3.0;
    expectNeeded(makePlan(scene, probe), "lambda by angle", "lambda_grazing 1");
    scene.material.lambdaGrazing = 0.0;
    expectLeftOut(makePlan(scene, probe), "lambda by angle", "the same at every angle");
}

TEST(Plan, FacesAreHalvedByThemselvesWhereAskedForAndWhereThereAreFaces)
{
    Scene scene;
    scene.material.lambda = 3.0;
    scene.map.mipFiltering = MipFiltering::PerFace;
    Plan plan = makePlan(scene, probe);
    expectNeeded(plan, "mip levels of specular map", "seams will show");
    EXPECT_EQ(plan.specular->filtering, MipFiltering::PerFace);
    scene.map.parameterization = Parameterization::Octahedral;
    plan = makePlan(scene, probe);
    expectNeeded(plan, "mip levels of specular map", "halved across seams");
    EXPECT_EQ(plan.specular->filtering, MipFiltering::AcrossSeams);
}

/// What a scene costs in all.
StageCost total(const Plan& plan)
{
    StageCost sum;
    for (const Stage& s : plan.stages)
        if (!s.leftOut) {
            sum.seconds += s.expected.seconds;
            sum.bytes += s.expected.bytes;
        }
    return sum;
}

TEST(Plan, EverythingCanBeAskedForAndLeavesOutNothingThatAMapOrShaderCouldNeed)
{
    for (const MaterialPreset& preset : materialPresets()) {
        Scene scene;
        scene.material = preset.material;
        const Plan all = makePlan(scene, probe, {.extent = PlanExtent::Everything}), needed = makePlan(scene, probe);
        ASSERT_TRUE(all.specular && all.diffuse && all.background) << preset.name;
        EXPECT_TRUE(all.specular->pyramid || all.brdf) << "a chain has its levels";
        EXPECT_EQ(all.specular->filters.front().options.target.size, scene.map.size) << "no smaller for a smooth lobe";
        EXPECT_EQ(all.diffuse->filters.front().options.target.size, scene.map.size);
        EXPECT_EQ(all.others.size(), allParameterizations.size() - 1);
        EXPECT_EQ(all.material.fresnel.kind == FresnelKind::None, all.brdf.has_value()) << "a BRDF has its own";
        EXPECT_EQ(stage(all, "fresnel term").leftOut, all.brdf.has_value());
        EXPECT_FALSE(stage(all, "spectrum").leftOut);
        EXPECT_TRUE(needed.others.empty());
        EXPECT_GT(total(all).seconds, total(needed).seconds) << preset.name;
        EXPECT_GT(total(all).bytes, total(needed).bytes) << preset.name;
    }
}

TEST(Plan, TellsWhatItsStagesAreExpectedToCost)
{
    Scene scene;
    scene.material.specular = {.lobe = SurfaceLobe::Phong, .exponent = 50.0};
    scene.material.diffuse.weight = 1.0;
    scene.map.mips = true;
    scene.exports = {{.name = "env", .kind = ExportKind::Source, .mips = true}};
    const Plan plan = makePlan(scene, probe, {.exports = std::vector<std::string>{}});
    for (const char* name : {"compute probe", "spectrum", "filter specular map", "mip levels of specular map", "filter irradiance map",
                             "draw", "resample env", "mip levels of env", "save env"})
        EXPECT_GT(stage(plan, name).expected.seconds, 0.0) << name;
    // What a stage leaves behind: three floats a texel, and a third as much again for the levels below.
    EXPECT_EQ(stage(plan, "filter irradiance map").expected.bytes, 64 * 384 * 12);
    EXPECT_EQ(stage(plan, "mip levels of env").expected.bytes, 256 * 1536 * 12 / 3);
    for (const Stage& s : plan.stages)
        if (s.leftOut) {
            EXPECT_EQ(s.expected, StageCost{}) << s.name << ": what is left out costs nothing";
        }
}

TEST(Plan, ChecksTheSceneFirst)
{
    Scene scene;
    scene.map.size = 0;
    EXPECT_THROW(makePlan(scene, probe), InvalidArgument);
}

TEST(Plan, FollowsTheMethodThatTheSceneAsksFor)
{
    Scene scene;
    scene.material.specular = {.lobe = SurfaceLobe::Phong, .exponent = 50.0};
    scene.filter = {.method = Method::Importance, .tolerance = 1e-2, .samples = 64};
    scene.exports = {{.name = "gloss", .kind = ExportKind::Specular, .size = 32},
                     {.name = "matt", .kind = ExportKind::Diffuse, .size = 32}};
    const Plan plan = makePlan(scene, {Parameterization::Latlong, 512, 0}, {.exports = std::vector<std::string>{}});
    for (const MapPlan* map : {&*plan.specular, &plan.exports[0].map}) {
        EXPECT_EQ(map->filters.front().options.method, Method::Importance);
        EXPECT_EQ(map->filters.front().options.knobs.samples, 64);
        EXPECT_EQ(map->filters.front().options.tolerance, 1e-2);
    }
    EXPECT_EQ(plan.exports[1].map.filters.front().options.method, Method::Auto) << "diffuse light is no specular map";
}

TEST(Plan, LeavesToAutoWhatTheChosenMethodRefuses)
{
    Scene scene;
    scene.material.specular = {.lobe = SurfaceLobe::Phong, .exponent = 50.0};
    scene.filter.method = Method::Sh9; // diffuse only
    const Plan plan = makePlan(scene, {Parameterization::Latlong, 512, 0});
    EXPECT_EQ(plan.specular->filters.front().options.method, Method::Auto);
    const auto stage = std::find_if(plan.stages.begin(), plan.stages.end(), [](const Stage& s) { return s.name == "filter specular map"; });
    ASSERT_NE(stage, plan.stages.end());
    EXPECT_NE(stage->why.find("sh9 was asked for but cannot do this"), std::string::npos) << stage->why;
}

} // namespace
} // namespace mirrorball
