#include "core/scene/live_maps.h"

#include "core/base/error.h"
#include "core/image/image_io.h"
#include "core/spheremap/document/presets.h"
#include "core/spheremap/evaluation/evaluate.h"
#include "support/temporary_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <fstream>
#include <functional>

namespace mirrorball {
namespace {

using testing::HasSubstr;

constexpr MapDetail coarse = coarseDetail;

Scene glossyScene(double exponent)
{
    Scene scene;
    scene.probe.source = "builtin:cube-room";
    scene.map.size = 256;
    scene.material.specular = {.lobe = SurfaceLobe::Phong, .exponent = exponent};
    scene.material.diffuse.weight = 0.5;
    return scene;
}

Scene paintedScene(const SphereMapDocument& map)
{
    Scene scene;
    scene.material.sphereMap.use = SphereMapUse::Replace;
    scene.material.sphereMap.size = 128;
    scene.material.sphereMap.document.document = std::make_shared<const SphereMapDocument>(map);
    return scene;
}

MapLevels commandLineMap(const Scene& scene) { return buildMaps(planScene(scene)).specular; }

void expectSame(const MapLevels& a, const MapLevels& b)
{
    ASSERT_TRUE(a && b);
    ASSERT_EQ(a->size(), b->size());
    for (size_t i = 0; i < a->size(); ++i) {
        EXPECT_TRUE(a->at(i).layout == b->at(i).layout);
        EXPECT_EQ(a->at(i).image.texels, b->at(i).image.texels);
    }
}

// Resampling builds on the probe as it is and not on what a filter keeps of it: the one thing that order could change.
TEST(LiveMaps, InFullAreThoseOfTheCommandLineWhateverCameBefore)
{
    LiveMaps live;
    for (const double exponent : {20.0, 3.0, 400.0}) {
        live.update(glossyScene(exponent), coarse);
        expectSame(live.update(glossyScene(exponent), {}).maps.specular, commandLineMap(glossyScene(exponent)));
    }
    Scene mirror = glossyScene(20.0);
    mirror.material.specular = {};
    mirror.material.diffuse.weight = 0.0;
    live.update(mirror, coarse);
    expectSame(live.update(mirror, {}).maps.specular, commandLineMap(mirror));
}

TEST(LiveMaps, KeepWhatAnEditDidNotTouch)
{
    LiveMaps live;
    const SceneMaps before = live.update(glossyScene(20.0), {}).maps, after = live.update(glossyScene(40.0), {}).maps;
    EXPECT_NE(before.specular, after.specular);
    EXPECT_EQ(before.diffuse, after.diffuse);
    EXPECT_EQ(before.background, after.background);
}

// Whatever came before: a layer that changed, one that went, another size.
TEST(LiveMaps, OfASphereMapThatIsEditedAreThoseOfTheCommandLine)
{
    LiveMaps live;
    Scene scene = paintedScene(findSphereMapPreset("jade")->document);
    const auto expectCommandLines = [&] {
        const std::vector<SphereMapChain> expected = buildMaps(planScene(scene)).sphereMaps;
        const std::vector<SphereMapChain> made = live.update(scene, {}).maps.sphereMaps;
        ASSERT_EQ(made.size(), 1u);
        EXPECT_EQ(made[0]->levels, expected[0]->levels);
        EXPECT_EQ(made[0]->hasAuthoredLevels, expected[0]->hasAuthoredLevels);
    };
    const auto edit = [&](auto&& change) {
        SphereMapDocument map = *scene.material.sphereMap.document.document;
        change(map);
        scene.material.sphereMap.document.document = std::make_shared<const SphereMapDocument>(std::move(map));
        expectCommandLines();
    };
    expectCommandLines();
    edit([](SphereMapDocument& map) { map.layers.front().opacity = 0.5; });
    edit([](SphereMapDocument& map) { map.layers.front().opacity = 0.6; });
    edit([](SphereMapDocument& map) { map.layers.push_back({.content = SilhouetteLayer{.unit = WidthUnit::Pixels}}); });
    edit([](SphereMapDocument& map) { map.layers.erase(map.layers.begin()); });
    scene.material.sphereMap.size = 64;
    expectCommandLines();
}

// A slider moves: the map is made as large as it is seen, with the lines of the whole map; a finer one that is at hand serves as well.
TEST(LiveMaps, MakeASphereMapInHasteNoFinerThanItIsSeen)
{
    LiveMaps live;
    Scene scene = paintedScene(findSphereMapPreset("jade")->document);
    const auto change = [&](const std::function<void(SphereMapDocument&)>& step) {
        SphereMapDocument map = *scene.material.sphereMap.document.document;
        step(map);
        scene.material.sphereMap.document.document = std::make_shared<const SphereMapDocument>(std::move(map));
    };
    const auto document = [&]() -> const SphereMapDocument& { return *scene.material.sphereMap.document.document; };
    MapDetail haste = coarse;
    haste.discPixels = 50;
    const SphereMapChain full = live.update(scene, {}).maps.sphereMaps.at(0);
    scene.material.specular.roughness = 0.4; // another slider
    EXPECT_EQ(live.update(scene, haste).maps.sphereMaps.at(0), full);
    for (const double opacity : {0.5, 0.6, 0.7}) {
        change([&](SphereMapDocument& map) { map.layers.front().opacity = opacity; });
        const SphereMapChain seen = live.update(scene, haste).maps.sphereMaps.at(0);
        ASSERT_EQ(seen->levels.front().width, 64);
        EXPECT_EQ(seen->levels.front(), evaluate(document(), {.size = 64, .levelSize = 128}));
        EXPECT_EQ(seen->levels, plainChain(seen->levels.front()));
    }
    haste.discPixels = 65; // it is seen larger
    EXPECT_EQ(live.update(scene, haste).maps.sphereMaps.at(0)->levels, buildMaps(planScene(scene)).sphereMaps.at(0)->levels);
    haste.discPixels = 30;
    EXPECT_EQ(live.update(scene, haste).maps.sphereMaps.at(0)->levels.front().width, 128);
    change([](SphereMapDocument& map) { map.layers.push_back({.content = SilhouetteLayer{.unit = WidthUnit::Pixels}}); });
    EXPECT_EQ(live.update(scene, haste).maps.sphereMaps.at(0)->levels, buildMaps(planScene(scene)).sphereMaps.at(0)->levels)
        << "levels made by hand have no coarser picture";
}

TEST(LiveMaps, ShowASphereMapWithoutLayersOfUnknownKindAndNameThem)
{
    LiveMaps live;
    SphereMapDocument map;
    map.layers = {{.content = FillLayer{.color = {0.25, 0.5, 0.75}}},
                  {.name = "Fur", .content = UnknownLayer{.name = "fur", .text = "{}"}}};
    const MadeScene made = live.update(paintedScene(map), {});
    EXPECT_THAT(made.problem, HasSubstr("without layer 2 \"Fur\""));
    ASSERT_EQ(made.maps.sphereMaps.size(), 1u);
    EXPECT_FLOAT_EQ(made.maps.sphereMaps[0]->levels[0].texel(7, 9)[2], 0.75f);
    map.layers.pop_back();
    EXPECT_EQ(live.update(paintedScene(map), {}).problem, "");
}

// From 1e6 on the lobe is narrower than 1.5 texels of a probe 1024 wide, and the map is the same lookup for all.
TEST(LiveMaps, MakeOneMapForAllLobesThatTheProbeDoesNotResolve)
{
    LiveMaps live;
    const MapLevels one = live.update(glossyScene(1e6), {}).maps.specular;
    EXPECT_EQ(live.update(glossyScene(3e6), {}).maps.specular, one);
    expectSame(one, commandLineMap(glossyScene(3e6)));
}

// Phong 20000 is 2 acos(2^(-1/n)) = 0.0167 rad wide, 3.4 texels of mean size; 5000 is 6.8.
TEST(LiveMaps, ShowTheProbeItselfInHasteWhereTheLobeSpansFewOfItsTexels)
{
    LiveMaps live;
    const MadeScene made = live.update(glossyScene(1e6), coarse);
    EXPECT_EQ(made.maps.specular, made.maps.background); // one texture
    EXPECT_TRUE(made.maps.specular->front().layout == made.probeLayout);
    EXPECT_EQ(&made.maps.specular->front(), made.environment.get()); // no copy
    EXPECT_EQ(live.update(glossyScene(20000.0), coarse).maps.specular, made.maps.background);
    EXPECT_NE(live.update(glossyScene(5000.0), coarse).maps.specular, made.maps.background);
    EXPECT_FALSE(live.update(glossyScene(1e6), {}).maps.specular->front().layout == made.probeLayout);

    Scene brighter = glossyScene(1e6);
    brighter.probe.exposure = 1.0; // the probe's texels are not those
    EXPECT_TRUE((live.update(brighter, coarse).maps.specular->front().layout == MapLayout{Parameterization::Cube, 128, 0}));
}

// A lobe 2 acos(2^(-1/n)) wide at half its peak: 13.5 degrees for n = 100, 10 texels of a cube of 64 and 5 of one of 32.
TEST(LiveMaps, AreSmallInHasteOnlyWhereTheLobeIsWide)
{
    LiveMaps live;
    const auto size = [&](double exponent) { return live.update(glossyScene(exponent), coarse).maps.specular->front().layout.size; };
    EXPECT_EQ(size(1.0), 32);
    EXPECT_EQ(size(100.0), 64);
    EXPECT_EQ(size(1000.0), 128);
    EXPECT_EQ(size(5000.0), 128);
}

TEST(LiveMaps, StandInForAProbeThatIsMissingAndSayWhich)
{
    LiveMaps live;
    Scene scene = glossyScene(20.0);
    scene.probe.source = "/nowhere/lost.hdr";
    const MadeScene made = live.update(scene, {});
    EXPECT_THAT(made.problem, HasSubstr("/nowhere/lost.hdr"));
    EXPECT_EQ(made.environment->image.texels, placeholderProbe().image.texels);
    scene.probe.source = "builtin:cube-room";
    EXPECT_EQ(live.update(scene, {}).problem, "");
}

TEST(LiveMaps, ReadAProbeAgainOnceItsFileIsAnother)
{
    const test::TemporaryFolder folder;
    const std::string file = (folder / "probe.exr").string();
    const auto write = [&](float radiance, int height) { writeImage(file, Image(2 * height, height, 3, radiance)); };
    Scene scene;
    scene.probe.source = file;
    LiveMaps live;
    write(1.0f, 16);
    EXPECT_EQ(live.update(scene, {}).environment->image.texels.front(), 1.0f);
    const auto kept = live.update(scene, {}).environment;
    EXPECT_EQ(live.update(scene, {}).environment, kept) << "nothing has changed";
    write(2.0f, 16); // as large as before: its time alone tells
    std::filesystem::last_write_time(file, std::filesystem::last_write_time(file) + std::chrono::seconds(2));
    EXPECT_EQ(live.update(scene, {}).environment->image.texels.front(), 2.0f);
    write(3.0f, 8);
    const MadeScene made = live.update(scene, {});
    EXPECT_EQ(made.environment->image.texels.front(), 3.0f);
    EXPECT_EQ(made.probeLayout, (MapLayout{Parameterization::Latlong, 8, 0}));
}

TEST(LiveMaps, ShowWhatAFileHeldBeforeWhenItVanishesOrBreaks)
{
    const test::TemporaryFolder folder;
    const std::string file = (folder / "probe.exr").string();
    writeImage(file, Image(32, 16, 3, 2.0f));
    Scene scene = glossyScene(20.0);
    scene.probe.source = file;
    LiveMaps live;
    const MadeScene good = live.update(scene, {});
    EXPECT_TRUE(good.keptFiles.empty());

    std::filesystem::rename(file, folder / "elsewhere.exr");
    const MadeScene gone = live.update(scene, {});
    EXPECT_THAT(gone.problem, HasSubstr(file));
    EXPECT_EQ(gone.keptFiles, std::vector<std::string>{file});
    EXPECT_EQ(gone.maps.specular, good.maps.specular); // made of it, and not again
    EXPECT_EQ(gone.environment, good.environment);
    scene.material.specular.exponent = 3.0; // and what is edited is made of it, too
    EXPECT_NEAR(live.update(scene, {}).maps.specular->front().image.texels.front(), 2.0f, 1e-4f);

    std::ofstream(file) << "no picture";
    EXPECT_EQ(live.update(scene, {}).keptFiles, std::vector<std::string>{file});
    const std::string whole = test::readBytes(folder / "elsewhere.exr");
    std::ofstream(file, std::ios::binary) << whole.substr(0, whole.size() - 40); // its header is whole
    const MadeScene broken = live.update(scene, {});
    if (!broken.problem.empty()) { // a reader may take such a file, and say what it lacks
        EXPECT_EQ(broken.environment->image.texels.front(), 2.0f);
        EXPECT_EQ(broken.keptFiles, std::vector<std::string>{file});
    }

    writeImage(file, Image(32, 16, 3, 5.0f));
    const MadeScene back = live.update(scene, {});
    EXPECT_EQ(back.problem, "");
    EXPECT_TRUE(back.keptFiles.empty());
    EXPECT_EQ(back.environment->image.texels.front(), 5.0f);

    scene.probe.source = "/nowhere/lost.hdr"; // was never there
    EXPECT_TRUE(live.update(scene, {}).keptFiles.empty());
    EXPECT_EQ(live.update(scene, {}).environment->image.texels, placeholderProbe().image.texels);
}

TEST(LiveMaps, ShowWhatALinkedSphereMapHeldBefore)
{
    const test::TemporaryFolder folder;
    const std::string file = (folder / "ball.exr").string();
    writeImage(file, Image(16, 16, 3, 0.5f));
    Scene scene;
    scene.material.sphereMap.source = file;
    LiveMaps live;
    const MadeScene good = live.update(scene, {});
    ASSERT_EQ(good.maps.sphereMaps.size(), 1u);
    std::filesystem::remove(file);
    const MadeScene gone = live.update(scene, {});
    EXPECT_EQ(gone.maps.sphereMaps.front(), good.maps.sphereMaps.front());
    EXPECT_EQ(gone.keptFiles, std::vector<std::string>{file});
    EXPECT_THAT(gone.problem, HasSubstr("ball.exr"));
}

TEST(LiveMaps, FitNoLookupsAnewWhileAnotherControlIsDragged)
{
    Scene scene;
    scene.material.brdf = {.model = "ggx:roughness=0.6", .lookups = 1};
    LiveMaps live;
    const auto full = live.update(scene, {}).maps.brdfLookups;
    ASSERT_TRUE(full);
    scene.material.diffuse.weight = 0.5;
    EXPECT_EQ(live.update(scene, coarseDetail).maps.brdfLookups, full);
    scene.material.brdf.model = "ggx:roughness=0.7";
    const auto rough = live.update(scene, coarseDetail).maps.brdfLookups;
    EXPECT_NE(rough, full);
    EXPECT_NE(live.update(scene, {}).maps.brdfLookups, rough) << "at rest as the command line has it";
}

TEST(LiveMaps, KeepTheExactMapsOfABrdf)
{
    Scene scene;
    scene.material.brdf = {.model = "ggx:roughness=0.6", .kind = LookupKind::Exact};
    LiveMaps live;
    const MadeScene made = live.update(scene, {});
    ASSERT_TRUE(made.maps.viewStack);
    EXPECT_FALSE(made.maps.specular || made.maps.brdfLookups);
    const auto full = made.maps.viewStack;
    scene.material.diffuse.weight = 0.5;
    EXPECT_EQ(live.update(scene, coarseDetail).maps.viewStack, full) << "finer than is asked for";
    scene.material.brdf.kind = LookupKind::Fitted;
    EXPECT_FALSE(live.update(scene, {}).maps.viewStack);
    scene.material.brdf.kind = LookupKind::Exact;
    EXPECT_EQ(live.update(scene, {}).maps.viewStack, full) << "for who compares the two";
    scene.probe.exposure = 1.0;
    const auto brighter = live.update(scene, coarseDetail).maps.viewStack;
    ASSERT_NE(brighter, full);
    EXPECT_NEAR(brighter->layers[0].texels[0], 2.0f * full->layers[0].texels[0], 0.2f * full->layers[0].texels[0]);
    EXPECT_NE(live.update(scene, {}).maps.viewStack, brighter) << "at rest as the command line has it";
    scene.material.brdf.model = "/nowhere/lost.binary";
    const MadeScene lost = live.update(scene, {});
    EXPECT_THAT(lost.problem, HasSubstr("lost.binary"));
    EXPECT_TRUE(lost.maps.viewStack);
}

TEST(LiveMaps, NameAMeasurementThatIsNotThere)
{
    Scene scene;
    scene.material.brdf.model = "/nowhere/lost.binary";
    LiveMaps live;
    const MadeScene made = live.update(scene, {});
    EXPECT_THAT(made.problem, HasSubstr("lost.binary"));
    ASSERT_TRUE(made.maps.brdfLookups);
    EXPECT_EQ(made.maps.brdfLookups->height, 2) << "one lookup: as many are drawn as the table has";
}

} // namespace
} // namespace mirrorball
