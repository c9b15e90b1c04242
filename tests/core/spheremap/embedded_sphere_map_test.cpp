#include "core/error.h"
#include "core/scene/scene_file.h"
#include "support/stroke_builders.h"
#include "support/temporary_folder.h"

#include <gtest/gtest.h>

#include <fstream>

namespace mirrorball {
namespace {

Scene painted()
{
    SphereMapDocument document;
    document.layers = {{.content = GradientLayer{}}, {.content = PaintLayer{.strokes = handDrawnStrokes(5, 3)}}};
    Scene scene;
    scene.material.sphereMap.document.document = std::make_shared<const SphereMapDocument>(std::move(document));
    return scene;
}

TEST(EmbeddedSphereMap, SurvivesARoundTripInsideAScene)
{
    const test::TemporaryFolder folder;
    const Scene scene = painted();
    saveScene(scene, folder / "a.mirrorball");
    const Scene loaded = loadScene(folder / "a.mirrorball");
    ASSERT_TRUE(loaded.material.sphereMap.document);
    EXPECT_EQ(loaded.material.sphereMap.document.document->layers, scene.material.sphereMap.document.document->layers);
    EXPECT_EQ(loaded.material.sphereMap.document.document->folder, folder.path());
    saveScene(Scene{}, folder / "b.mirrorball");
    EXPECT_FALSE(loadScene(folder / "b.mirrorball").material.sphereMap.document);
}

TEST(EmbeddedSphereMap, ComparesByWhatItHolds)
{
    EXPECT_EQ(painted(), painted());
    EXPECT_NE(painted(), Scene{});
}

TEST(EmbeddedSphereMap, WhatIsWrongInsideIsNamedFromTheSceneOn)
{
    const test::TemporaryFolder folder;
    std::ofstream(folder / "a.mirrorball") << R"({"version": 1, "material": {"sphere_map": {"document":
        {"version": 1, "layers": [{"content": {"kind": "paint", "strokes": [{"points": "0 0 9"}]}}]}}}})";
    try {
        loadScene(folder / "a.mirrorball");
        FAIL();
    } catch (const FileError& error) {
        EXPECT_EQ(std::string(error.what()).substr((folder / "a.mirrorball").string().size()),
                  ": material.sphere_map.document.layers[0].content.strokes[0].points[0]: has a pressure outside [0, 1]; pressure is the third "
                  "number of a point");
    }
}

} // namespace
} // namespace mirrorball
