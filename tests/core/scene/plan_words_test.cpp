#include "plan_decisions.h"

#include "core/scene/material_presets.h"
#include "core/scene/plan_words.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

namespace mirrorball {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

constexpr MapLayout probe{Parameterization::Latlong, 512, 0};

/// Every stage of every preset, needed or left out, is said in a line, and no two reasons without numbers in the same one.
TEST(PlanWords, SayEveryDecisionInALineOfItsOwn)
{
    for (const MaterialPreset& preset : materialPresets()) {
        Scene scene;
        scene.material = preset.material;
        for (const Stage& stage : makePlan(scene, probe).stages()) {
            EXPECT_FALSE(stage.why.empty()) << stage.name;
            EXPECT_EQ(stage.why.find('\n'), std::string::npos) << stage.name;
        }
    }
    std::set<std::string> said;
    for (int i = 0; i <= static_cast<int>(Because::BackdropIsNone); ++i) {
        const std::string words = inWords(static_cast<Because>(i));
        EXPECT_FALSE(words.empty()) << i;
        EXPECT_TRUE(said.insert(words).second) << words;
    }
}

TEST(PlanWords, GiveTheNumbersOfADecision)
{
    const auto said = [](const Decision& decision) { return inWords(decision); };
    EXPECT_EQ(said(ReadsProbe{.source = "a.hdr", .layout = probe}), "a.hdr, latlong 1024 x 512");
    EXPECT_THAT(said(ReadsProbe{.source = "a.hdr", .layout = probe, .streamedBandLimit = 96}), HasSubstr("truncated to band limit 96"));
    EXPECT_THAT(said(ReadsProbe{.source = "a.hdr", .layout = probe, .isLargeAndWhole = true}), HasSubstr("held whole"));
    EXPECT_EQ(said(TransformsOnce{2}), "one forward transform for 2 lobes");
    EXPECT_EQ(said(HalvesForPicture{.lambda = 2.5, .levels = 10}), "lambda 2.5: 10 levels, halved across seams");
    EXPECT_THAT(said(HalvesForPicture{.lodBias = 1.5, .levels = 1, .perFace = true}), HasSubstr("LOD bias 1.5: 1 level, each face"));
    EXPECT_THAT(said(FileHoldsNoLevels{"flat.hdr"}), StartsWith("flat.hdr holds none"));
    EXPECT_EQ(said(ShowsDebugView{Shading::Normals}), "the view shows normals and not the material");
    EXPECT_EQ(said(ReadsOneParameterization{Parameterization::Cube}),
              "the picture reads cube: no latlong, sphere, angular, paraboloid, octahedral is built");
    EXPECT_EQ(said(IsProbeAlready{probe}), "the probe already is latlong 1024 x 512");
    EXPECT_EQ(said(Draws{"teapot", 640, 480}), "teapot, 640 x 480");
    const PlannedFilter phong =
        planFilter({.lobe = phongLobe(50.0), .target = {Parameterization::Cube, 128, 0}, .tolerance = 1e-3}, probe.width());
    EXPECT_THAT(said(FiltersLevel{phong, {.asked = Method::Sh9, .refusal = "diffuse only", .askedSize = 512}}),
                testing::AllOf(StartsWith("phong:50 into cube 128 x 768"), HasSubstr("a tolerance of 0.001 is promised"),
                               HasSubstr("sh9 was asked for but cannot do this: diffuse only"), HasSubstr("512 is left out")));
    const PlannedFilter narrow = planFilter({.lobe = phongLobe(1e7), .target = {Parameterization::Cube, 128, 0}}, probe.width());
    EXPECT_THAT(said(LooksUp{narrow.plan}), HasSubstr("texels wide at half maximum, under 1.5"));
}

TEST(PlanWords, SayHowTheLevelsOfASphereMapAreMade)
{
    Scene scene;
    SphereMapSettings& map = scene.material.sphereMap;
    const auto why = [&] {
        for (const Stage& stage : makePlan(scene, probe).stages())
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

} // namespace
} // namespace mirrorball
