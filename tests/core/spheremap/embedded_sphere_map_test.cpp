#include "core/base/error.h"
#include "core/image/image_io.h"
#include "core/scene/scene_file.h"
#include "core/spheremap/evaluation/evaluate.h"
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
        EXPECT_EQ(
            std::string(error.what()).substr((folder / "a.mirrorball").string().size()),
            ": material.sphere_map.document.layers[0].content.strokes[0].points[0]: has a pressure outside [0, 1]; pressure is the third "
            "number of a point");
    }
}

/// A folder with a picture and a probe, and a map that uses each in a layer and in a mask.
SphereMapDocument withPictures(const std::filesystem::path& folder)
{
    std::filesystem::create_directories(folder / "light");
    Image picture(4, 4, 3), probe(8, 4, 3);
    for (size_t i = 0; i < picture.texels.size(); ++i)
        picture.texels[i] = 0.01f * static_cast<float>(i);
    for (size_t i = 0; i < probe.texels.size(); ++i)
        probe.texels[i] = 0.02f * static_cast<float>(i % 40);
    writeImage(folder / "ball.exr", picture);
    writeImage(folder / "light" / "sky.exr", probe);
    const std::string ball = (folder / "ball.exr").string(), sky = (folder / "light" / "sky.exr").string();
    SphereMapDocument map;
    map.layers = {{.content = ImageLayer{.source = ball}},
                  {.content = ProbeLayer{.source = sky}, .mask = Mask{.content = ImageLayer{.source = ball}}},
                  {.opacity = 0.5, .content = ImageLayer{.source = ball}, .mask = Mask{.content = ProbeLayer{.source = sky}}}};
    return map;
}

Scene showing(SphereMapDocument map)
{
    Scene scene;
    scene.material.sphereMap.document.document = std::make_shared<const SphereMapDocument>(std::move(map));
    return scene;
}

Image picture(const Scene& scene) { return evaluate(*scene.material.sphereMap.document.document, {.size = 8}); }

TEST(EmbeddedSphereMap, FindsWhatLiesBesideTheSceneAfterTheFolderMoved)
{
    const test::TemporaryFolder folder;
    const Scene scene = showing(withPictures(folder / "project")); // as the studio's file dialog gives them: absolute
    const Image before = picture(scene);
    saveScene(scene, folder / "project" / "a.mirrorball");
    std::filesystem::rename(folder / "project", folder / "elsewhere");
    const Scene loaded = loadScene(folder / "elsewhere" / "a.mirrorball");
    const std::vector<Layer>& layers = loaded.material.sphereMap.document.document->layers;
    EXPECT_EQ(std::get<ImageLayer>(layers[0].content).source, "ball.exr");
    EXPECT_EQ(std::get<ProbeLayer>(layers[1].content).source, "light/sky.exr");
    EXPECT_EQ(std::get<ImageLayer>(layers[1].mask->content).source, "ball.exr");
    EXPECT_EQ(picture(loaded), before);
    saveScene(loaded, folder / "elsewhere" / "b.mirrorball");
    EXPECT_EQ(loadScene(folder / "elsewhere" / "b.mirrorball"), loaded);
}

TEST(EmbeddedSphereMap, IsFoundWhenTheSceneIsSavedInAnotherFolder)
{
    const test::TemporaryFolder folder;
    std::filesystem::create_directories(folder / "far" / "away");
    saveScene(showing(withPictures(folder / "project")), folder / "project" / "a.mirrorball");
    const Scene scene = loadScene(folder / "project" / "a.mirrorball");
    saveScene(scene, folder / "far" / "away" / "b.mirrorball");
    const Scene far = loadScene(folder / "far" / "away" / "b.mirrorball");
    EXPECT_EQ(std::get<ImageLayer>(far.material.sphereMap.document.document->layers[0].content).source, "../../project/ball.exr");
    EXPECT_EQ(picture(far), picture(scene));
    saveScene(showing(withPictures(folder / "project")), folder / "far" / "c.mirrorball"); // from a scene without a file
    EXPECT_EQ(picture(loadScene(folder / "far" / "c.mirrorball")), picture(scene));
}

// Where a folder is a link, ".." leads to the folder above its target.
TEST(EmbeddedSphereMap, IsFoundThroughFoldersThatAreLinks)
{
    const test::TemporaryFolder folder;
    std::filesystem::create_directories(folder / "deep" / "er" / "store");
    std::filesystem::create_directory_symlink(folder / "deep" / "er" / "store", folder / "link");
    saveScene(showing(withPictures(folder / "project")), folder / "project" / "a.mirrorball");
    const Scene scene = loadScene(folder / "project" / "a.mirrorball");
    saveScene(scene, folder / "link" / "b.mirrorball");
    EXPECT_EQ(picture(loadScene(folder / "link" / "b.mirrorball")), picture(scene));
    saveScene(loadScene(folder / "link" / "b.mirrorball"), folder / "project" / "c.mirrorball");
    EXPECT_EQ(picture(loadScene(folder / "project" / "c.mirrorball")), picture(scene));
}

TEST(EmbeddedSphereMap, KeepsItsFolderWhenAFieldOfTheSceneIsSet)
{
    const test::TemporaryFolder folder;
    saveScene(showing(withPictures(folder / "project")), folder / "project" / "a.mirrorball");
    Scene scene = loadScene(folder / "project" / "a.mirrorball");
    const Image before = picture(scene);
    setField(scene, "view.exposure", "1");
    EXPECT_EQ(picture(scene), before);
}

TEST(EmbeddedSphereMap, IsFoundInAMaterialFile)
{
    const test::TemporaryFolder folder;
    Scene scene = showing(withPictures(folder / "project"));
    const Image before = picture(scene);
    scene.material.sphereMap.source = (folder / "project" / "own.spheremap").string();
    saveMaterial(scene, folder / "project" / "m.material");
    std::filesystem::rename(folder / "project", folder / "elsewhere");
    Scene other;
    other.material = loadMaterial(folder / "elsewhere" / "m.material");
    EXPECT_EQ(picture(other), before);
    EXPECT_EQ(other.material.sphereMap.source, (folder / "elsewhere" / "own.spheremap").string());
}

} // namespace
} // namespace mirrorball
