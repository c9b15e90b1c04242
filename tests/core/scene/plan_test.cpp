#include "plan_decisions.h"

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

using test::expectLeftOut;
using test::leftOut;
using test::needed;
using test::stage;

TEST(Plan, AMirrorNeedsNoFilterNoPyramidNoFresnelAndNoIrradiance)
{
    const Plan plan = makePlan({}, probe);
    EXPECT_EQ(needed<ReadsProbe>(plan, "compute probe").layout, probe);
    expectLeftOut(plan, "spectrum", Because::NothingIsFiltered);
    expectLeftOut(plan, "filter specular map", Because::SurfaceIsMirror);
    EXPECT_EQ(needed<ResamplesLevel>(plan, "resample specular map").to, (MapLayout{Parameterization::Cube, 512, 0}));
    expectLeftOut(plan, "mip levels of specular map", Because::FinestLevelIsEnough);
    expectLeftOut(plan, "irradiance map", Because::DiffuseWeightIsZero);
    EXPECT_EQ(leftOut<IsProbeAlready>(plan, "resample background").layout, probe);
    expectLeftOut(plan, "fresnel term", Because::ReflectanceIsOne);
    EXPECT_EQ(leftOut<ReadsOneParameterization>(plan, "other maps").kind, Parameterization::Cube);
    EXPECT_FALSE(plan.filtersAny());
    EXPECT_FALSE(plan.diffuse);
    EXPECT_TRUE(plan.exports.empty());
}

TEST(Plan, AGlossyLobeIsFilteredAtItsBandLimitAndNoLargerThanItShows)
{
    Scene scene;
    scene.material.specular = {.lobe = SurfaceLobe::Phong, .exponent = 50.0};
    const Plan plan = makePlan(scene, probe);
    const auto filters = needed<FiltersLevel>(plan, "filter specular map");
    EXPECT_EQ(filters.filter.options.target, (MapLayout{Parameterization::Cube, 128, 0}));
    EXPECT_EQ(filters.filter.options.lobe, phongLobe(50.0));
    EXPECT_EQ(filters.choice.askedSize, 512);
    EXPECT_EQ(needed<TransformsOnce>(plan, "spectrum").lobes, 1);
    EXPECT_TRUE(plan.filtersAny());
    EXPECT_EQ(plan.specular->filters.front().options.target.size, 128);
}

TEST(Plan, AnUnresolvedLobeIsALookup)
{
    Scene scene;
    scene.material.specular = {.lobe = SurfaceLobe::Phong, .exponent = 1e7};
    const Plan plan = makePlan(scene, probe);
    EXPECT_FALSE(leftOut<LooksUp>(plan, "filter specular map").plan.filtered);
    expectLeftOut(plan, "spectrum", Because::NothingIsFiltered);
}

TEST(Plan, LambdaAsksForAPyramid)
{
    Scene scene;
    scene.material.lambda = 2.5;
    const Plan plan = makePlan(scene, probe);
    const auto halves = needed<HalvesForPicture>(plan, "mip levels of specular map");
    EXPECT_EQ(halves.lambda, 2.5);
    EXPECT_EQ(halves.levels, 10);
    EXPECT_TRUE(plan.specular->pyramid);

    Scene shrinking;
    shrinking.map.mips = true;
    EXPECT_EQ(needed<HalvesForPicture>(makePlan(shrinking, probe), "mip levels of specular map").lambda, 0.0);
}

TEST(Plan, ALevelBiasUpwardsAsksForAPyramid)
{
    Scene scene;
    scene.material.lodBias = 1.5;
    EXPECT_EQ(needed<HalvesForPicture>(makePlan(scene, probe), "mip levels of specular map").lodBias, 1.5);
    scene.material.lodBias = -1.0; // sharper than the finest there is not
    expectLeftOut(makePlan(scene, probe), "mip levels of specular map", Because::FinestLevelIsEnough);
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
        EXPECT_EQ(leftOut<ShowsDebugView>(plan, "specular map").shading, shading);
        EXPECT_EQ(leftOut<ShowsDebugView>(plan, "irradiance map").shading, shading);
    }
    scene.view.shading = Shading::Mips;
    EXPECT_TRUE(makePlan(scene, probe).specular);
}

TEST(Plan, ASphereMapThatReplacesTheReflectionNeedsNoEnvironment)
{
    Scene scene;
    scene.view.background.kind = Backdrop::None;
    expectLeftOut(makePlan(scene, probe), "sphere map", Because::NoneIsNamed);
    scene.material.sphereMap = {.source = "silhouette", .size = 256};
    for (const SphereMapUse use : {SphereMapUse::Replace, SphereMapUse::Multiply}) {
        scene.material.sphereMap.use = use;
        const Plan plan = makePlan(scene, probe);
        EXPECT_FALSE(plan.needsProbe());
        expectLeftOut(plan, "specular map", Because::SphereMapReplaces);
        EXPECT_EQ(needed<EvaluatesSphereMap>(plan, "sphere map").map.size, 256);
        expectLeftOut(plan, "flecks", Because::FleckDensityIsZero);
        ASSERT_EQ(plan.sphereMaps.size(), 1u);
    }
    for (const SphereMapUse use : {SphereMapUse::Over, SphereMapUse::Tint, SphereMapUse::Add}) {
        scene.material.sphereMap.use = use;
        EXPECT_TRUE(makePlan(scene, probe).specular);
    }
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
    expectLeftOut(plan, "sphere map, middle", Because::NoneIsNamed);
    expectLeftOut(plan, "specular map", Because::RoomHasNoMaterial);
}

TEST(Plan, ReadsAMeshOnlyWhereOneIsNamed)
{
    Scene scene;
    EXPECT_EQ(leftOut<MeshIsBuiltin>(makePlan(scene, probe), "read mesh").geometry, "teapot");
    scene.view.geometry = "bunny.ply";
    EXPECT_EQ(needed<ReadsMesh>(makePlan(scene, probe), "read mesh").file, "bunny.ply");
}

TEST(Plan, ConstantFresnelTermsAreFoldedIntoTheColors)
{
    Scene scene;
    scene.material.diffuse.weight = 1.0;
    scene.material.combine = Combine::Coat;
    Plan plan = makePlan(scene, probe); // F = 1: nothing gets below the coat
    expectLeftOut(plan, "irradiance map", Because::CoatMirrorsAll);
    EXPECT_EQ(plan.material.specular, glm::dvec3(1.0));

    scene.material.fresnel = {.kind = FresnelKind::Dielectric, .index = 1.0}; // F = 0
    plan = makePlan(scene, probe);
    expectLeftOut(plan, "specular map", Because::IndexIsOne);
    expectLeftOut(plan, "fresnel term", Because::ReflectanceIsZero);
    EXPECT_EQ(needed<FiltersLevel>(plan, "filter irradiance map").filter.options.target, (MapLayout{Parameterization::Cube, 64, 0}));
    EXPECT_EQ(plan.material.fresnel.kind, FresnelKind::None);
    EXPECT_EQ(plan.material.combine, Combine::Add);

    scene.material.fresnel.index = 1.5;
    plan = makePlan(scene, probe);
    EXPECT_EQ(needed<DielectricAtEveryPixel>(plan, "fresnel term").index, 1.5);
    EXPECT_TRUE(plan.specular && plan.diffuse);
}

TEST(Plan, WithoutAReflectionAddNeedsNoFresnelTermButACoatDoes)
{
    Scene scene;
    scene.material.specular.weight = 0.0;
    scene.material.diffuse.weight = 1.0;
    scene.material.fresnel.kind = FresnelKind::Dielectric;
    Plan plan = makePlan(scene, probe);
    expectLeftOut(plan, "fresnel term", Because::SpecularWeightIsZero);
    expectLeftOut(plan, "specular map", Because::SpecularWeightIsZero);
    scene.material.combine = Combine::Coat;
    plan = makePlan(scene, probe);
    EXPECT_EQ(needed<DielectricAtEveryPixel>(plan, "fresnel term").index, 1.5);
    EXPECT_FALSE(plan.specular);
}

TEST(Plan, ABlackMaterialOnAPlainBackgroundDoesNotOpenTheProbe)
{
    Scene scene;
    scene.probe.source = "light.hdr";
    scene.material.specular.color = glm::dvec3(0.0);
    scene.view.background.kind = Backdrop::Color;
    const Plan plan = makePlan(scene, probe);
    expectLeftOut(plan, "read probe", Because::NoMapIsNeeded);
    expectLeftOut(plan, "background", Because::BackdropIsOneColor);
    EXPECT_FALSE(plan.needsProbe());
}

TEST(Plan, ALargeProbeIsTruncatedRowByRowWhenEveryMapIsFiltered)
{
    constexpr MapLayout large{Parameterization::Latlong, 8192, 0};
    Scene scene;
    scene.probe.source = "large.exr";
    scene.material.specular = {.lobe = SurfaceLobe::Phong, .exponent = 50.0};
    scene.view.background.kind = Backdrop::None;
    EXPECT_EQ(needed<ReadsProbe>(makePlan(scene, large), "read probe").streamedBandLimit,
              streamedBandLimit(makePlan(scene, large).filters().front()));
    scene.view.background.kind = Backdrop::Environment;
    const Plan held = makePlan(scene, large);
    EXPECT_TRUE(needed<ReadsProbe>(held, "read probe").isLargeAndWhole);
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
    EXPECT_EQ(needed<HalvesForExport>(all, "mip levels of env").levels, 9);
    EXPECT_EQ(leftOut<FileHoldsNoLevels>(all, "mip levels of env-hdr").file, "flat.hdr");
    expectLeftOut(all, "mip levels of irradiance", Because::NotAskedFor);
    EXPECT_EQ(all.exports[3].map.filters.size(), 7u);
    expectLeftOut(all, "filter chain level 0", Because::RoughnessIsZero);
    EXPECT_EQ(needed<FiltersLevel>(all, "filter chain level 6").filter.options.lobe, ggxLobe(1.0));

    const Plan one = makePlan(scene, probe, {.picture = false, .exports = std::vector<std::string>{"irradiance"}});
    ASSERT_EQ(one.exports.size(), 1u);
    expectLeftOut(one, "export env", Because::NotAmongThoseAskedFor);
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
    expectLeftOut(plan, "compute probe", Because::NoMapIsNeeded);
    expectLeftOut(plan, "export env", Because::NotAmongThoseAskedFor);
    EXPECT_EQ(needed<PaintsFile>(plan, "paint chain").target.name, "chain");
    EXPECT_EQ(needed<PaintsFile>(plan, "paint matcap").map.size, 60) << "inside its border";
    EXPECT_EQ(needed<SavesFile>(plan, "save matcap").file, "m.png");
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
    expectLeftOut(makePlan(scene, probe), "lambda by angle", Because::LambdaHoldsNoLevel);
    scene.material.lambda = 3.0;
    EXPECT_EQ(needed<LambdaAtEveryPixel>(makePlan(scene, probe), "lambda by angle").grazing, 1.0);
    scene.material.lambdaGrazing = 0.0;
    expectLeftOut(makePlan(scene, probe), "lambda by angle", Because::LambdaIsTheSame);
}

TEST(Plan, FacesAreHalvedByThemselvesWhereAskedForAndWhereThereAreFaces)
{
    Scene scene;
    scene.material.lambda = 3.0;
    scene.map.mipFiltering = MipFiltering::PerFace;
    Plan plan = makePlan(scene, probe);
    EXPECT_TRUE(needed<HalvesForPicture>(plan, "mip levels of specular map").perFace);
    EXPECT_EQ(plan.specular->filtering, MipFiltering::PerFace);
    scene.map.parameterization = Parameterization::Octahedral;
    plan = makePlan(scene, probe);
    EXPECT_FALSE(needed<HalvesForPicture>(plan, "mip levels of specular map").perFace);
    EXPECT_EQ(plan.specular->filtering, MipFiltering::AcrossSeams);
}

/// What a scene costs in all.
StageCost total(const Plan& plan)
{
    StageCost sum;
    for (const PlannedStage& s : plan.decisions)
        if (!s.isLeftOut) {
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
        EXPECT_EQ(stage(all, "fresnel term").isLeftOut, all.brdf.has_value());
        EXPECT_FALSE(stage(all, "spectrum").isLeftOut);
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
    for (const PlannedStage& s : plan.decisions)
        if (s.isLeftOut) {
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
    const LevelChoice choice = needed<FiltersLevel>(plan, "filter specular map").choice;
    EXPECT_EQ(choice.asked, Method::Sh9);
    EXPECT_FALSE(choice.refusal.empty());
}

} // namespace
} // namespace mirrorball
