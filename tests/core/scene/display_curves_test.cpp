#include "core/scene/display_curves.h"

#include <gtest/gtest.h>

namespace mirrorball {
namespace {

Scene painted(SphereMapUse use)
{
    Scene scene;
    scene.material.sphereMap = {.source = "jade", .use = use};
    return scene;
}

TEST(DisplayCurves, ShowPaintThatReplacesTheMaterialAsItIs)
{
    EXPECT_EQ(displayCurves(painted(SphereMapUse::Replace)), (DisplayCurves{ToneCurve::None, ToneCurve::Filmic}));
    EXPECT_EQ(displayCurves(Scene{}), (DisplayCurves{ToneCurve::Filmic, ToneCurve::Filmic}));
    for (const SphereMapUse use : {SphereMapUse::Multiply, SphereMapUse::Over, SphereMapUse::Tint, SphereMapUse::Add})
        EXPECT_EQ(displayCurves(painted(use)), displayCurves(Scene{}));
}

TEST(DisplayCurves, AreThoseThatASceneNames)
{
    for (const auto& [tone, curve] : {std::pair{ToneChoice::None, ToneCurve::None},
                                      {ToneChoice::Reinhard, ToneCurve::Reinhard},
                                      {ToneChoice::Filmic, ToneCurve::Filmic}})
        for (Scene scene : {Scene{}, painted(SphereMapUse::Replace)}) {
            scene.view.tone = tone;
            EXPECT_EQ(displayCurves(scene), (DisplayCurves{curve, curve}));
        }
}

TEST(DisplayCurves, KnowNoPaintInADebugView)
{
    Scene scene = painted(SphereMapUse::Replace);
    EXPECT_TRUE(showsPaint(scene));
    scene.view.shading = Shading::Normals;
    EXPECT_FALSE(showsPaint(scene));
}

} // namespace
} // namespace mirrorball
