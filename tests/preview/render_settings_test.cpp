#include "core/preview/render_settings.h"

#include "core/base/error.h"

#include <gtest/gtest.h>

using namespace mirrorball;
using namespace mirrorball::preview;

TEST(RenderSettings, NeedOnlyTheMapsThatCanBeSeen)
{
    RenderSettings settings;
    EXPECT_EQ(neededMaps(settings), (NeededMaps{true, false, true}));
    settings.background.kind = Backdrop::Color;
    settings.material.specular = glm::vec3(0.0f);
    settings.material.diffuse = glm::vec3(1.0f);
    EXPECT_EQ(neededMaps(settings), (NeededMaps{false, true, false}));
}

TEST(RenderSettings, ABlurredBackgroundIsAMapAsTheEnvironmentIs)
{
    RenderSettings settings;
    settings.background.kind = Backdrop::Blurred;
    EXPECT_TRUE(neededMaps(settings).background);
}

TEST(RenderSettings, ACoatThatReflectsEverythingHidesTheDiffusePart)
{
    RenderSettings settings;
    settings.material.diffuse = glm::vec3(1.0f);
    settings.material.combine = Combine::Coat;
    EXPECT_FALSE(neededMaps(settings).diffuse);
    settings.material.fresnel.kind = FresnelKind::Dielectric;
    EXPECT_TRUE(neededMaps(settings).diffuse);
}

TEST(RenderSettings, OutOfRangeAreRefusedByName)
{
    const auto messageOf = [](auto change) {
        RenderSettings settings;
        change(settings);
        try {
            validate(settings);
        } catch (const InvalidArgument& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    EXPECT_NE(messageOf([](RenderSettings& s) { s.width = 0; }).find("width"), std::string::npos);
    EXPECT_NE(messageOf([](RenderSettings& s) { s.samples = 3; }).find("samples"), std::string::npos);
    EXPECT_NE(messageOf([](RenderSettings& s) { s.material.lambda = -1.0f; }).find("lambda"), std::string::npos);
    EXPECT_NE(messageOf([](RenderSettings& s) { s.camera.distance = 0.0f; }).find("distance"), std::string::npos);
    EXPECT_NE(messageOf([](RenderSettings& s) { s.exposure = 1e9f; }).find("exposure"), std::string::npos);
    EXPECT_NE(messageOf([](RenderSettings& s) { s.geometry.level = 0; }).find("level"), std::string::npos);
    EXPECT_NE(messageOf([](RenderSettings& s) { s.material.paint.anisotropy = 17; }).find("sphere map.anisotropy"), std::string::npos);
    EXPECT_NE(messageOf([](RenderSettings& s) { s.material.paint.flecks.density = 1.5; }).find("flecks.density"), std::string::npos);
    EXPECT_NE(messageOf([](RenderSettings& s) { s.windowDepths.y = -1.0f; }).find("middle_depth"), std::string::npos);
    EXPECT_EQ(messageOf([](RenderSettings&) {}), "");
}
