#include "core/scene/plan.h"

#include <gtest/gtest.h>

namespace mirrorball {
namespace {

const MapLayout probe{Parameterization::Latlong, 1024, 0};

TEST(Plan, TheYawIsInTheMapsOfEyeSpaceAndInNoneOfWorldSpace)
{
    Scene scene;
    scene.probe.yawDeg = 90.0;
    scene.material.specular = {.lobe = SurfaceLobe::Phong, .exponent = 50.0};
    scene.material.diffuse.weight = 1.0;
    for (const MapSpace space : {MapSpace::World, MapSpace::Eye}) {
        scene.map.space = space;
        const Plan plan = makePlan(scene, probe);
        const double yaw = space == MapSpace::Eye ? pi / 2 : 0.0;
        EXPECT_DOUBLE_EQ(plan.specular->filters.front().options.yaw, yaw);
        EXPECT_DOUBLE_EQ(plan.diffuse->filters.front().options.yaw, yaw);
        EXPECT_EQ(plan.background->filters.front().options.yaw, 0.0) << "the picture turns what stands behind the object";
    }
}

TEST(Plan, ADragAsksForLessOfTheSameMaps)
{
    Scene scene;
    scene.material.specular = {.lobe = SurfaceLobe::Ggx, .roughness = 0.3};
    const PlannedFilter whole = makePlan(scene, probe).specular->filters.front();
    const PlannedFilter dragged = makePlan(scene, probe, {.detail = coarseDetail}).specular->filters.front();
    EXPECT_LT(dragged.options.target.size, whole.options.target.size);
    EXPECT_EQ(dragged.options.tolerance, coarseDetail.tolerance);
    EXPECT_LE(dragged.plan.predictedSeconds, whole.plan.predictedSeconds);
    EXPECT_EQ(dragged.options.lobe, whole.options.lobe);
}

// A spectrum that is followed far takes longer than a picture.
TEST(Plan, ADragAsksForLessStillWhereASpectrumIsLong)
{
    Scene scene;
    for (const auto& [exponent, tolerance] :
         {std::pair{0.1, coarseDetail.longTolerance}, {30.0, coarseDetail.tolerance}, {5000.0, coarseDetail.longTolerance}}) {
        scene.material.specular = {.lobe = SurfaceLobe::Phong, .exponent = exponent};
        EXPECT_EQ(makePlan(scene, probe, {.detail = coarseDetail}).specular->filters.front().options.tolerance, tolerance) << exponent;
        EXPECT_EQ(makePlan(scene, probe).specular->filters.front().options.tolerance, MapDetail{}.tolerance) << exponent;
    }
}

TEST(Plan, OfFiltersWithoutASceneTellsWhatWillBeReadFilteredAndSaved)
{
    std::vector<PrefilterOptions> levels;
    for (const double alpha : {0.0, 0.25, 1.0})
        levels.push_back({.lobe = ggxLobe(alpha), .target = {Parameterization::Cube, 16, 0}});
    const Plan plan = planFilters("sky.hdr", probe, levels, "out.exr");
    ASSERT_EQ(plan.exports.size(), 1u);
    EXPECT_EQ(plan.filters(), levels);
    EXPECT_TRUE(plan.needsProbe() && plan.filtersAny());
    EXPECT_EQ(plan.decisions.front().name, "read probe");
    EXPECT_EQ(plan.decisions.back().name, "save map");
    EXPECT_EQ(std::get<SavesFile>(plan.decisions.back().why).file, "out.exr");
}

} // namespace
} // namespace mirrorball
