#include "core/scene/surface_picture.h"

#include "plan_decisions.h"

#include "core/base/error.h"
#include "core/image/image_io.h"
#include "core/scene/live_picture.h"
#include "support/picture_builders.h"
#include "support/temporary_folder.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <chrono>
#include <cmath>

namespace mirrorball {
namespace {

using testing::HasSubstr;

struct SurfacePicture : testing::Test {
    test::TemporaryFolder folder{};
    Scene scene{.folder = folder.path()};

    PictureLevels read(const std::string& source, SurfacePictureUse use = SurfacePictureUse::Color) const
    {
        return readSurfacePicture(scene, {"diffuse picture", "material.diffuse.picture", source, use});
    }
    std::string problem(const std::string& source) const
    {
        try {
            read(source);
        } catch (const InvalidArgument& error) {
            return error.what();
        }
        return "";
    }
};

// IEC 61966-2-1: ((0.5 + 0.055) / 1.055)^2.4; PNG: light = stored^(1 / gAMA).
TEST_F(SurfacePicture, IsLinearAsItsFileSays)
{
    const Image stored(4, 2, 3, 0.5f);
    test::writePng(folder / "plain.png", stored, 16);
    test::writePng(folder / "linear.png", stored, 16, test::gammaChunk(1.0));
    test::writePng(folder / "square.png", stored, 16, test::gammaChunk(0.5));
    EXPECT_NEAR(read("plain.png")->front().texels[0], std::pow(0.555 / 1.055, 2.4), 1e-4);
    EXPECT_NEAR(read("linear.png")->front().texels[0], 0.5, 1e-4);
    EXPECT_NEAR(read("square.png")->front().texels[0], 0.25, 1e-4);
}

// ITU-R BT.709: red weighs 0.2126; no part of a surface has more than all flecks.
TEST_F(SurfacePicture, OfSharesIsItsLuminanceAtMostOne)
{
    Image colors(3, 1);
    colors.texels = {1.0f, 0.0f, 0.0f, 8.0f, 8.0f, 8.0f, -1.0f, 0.0f, 0.0f};
    writeImage(folder / "colors.exr", colors);
    const Image shares = read("colors.exr", SurfacePictureUse::Share)->front();
    ASSERT_EQ(shares.channels, 1);
    EXPECT_NEAR(shares.texels[0], 0.2126f, 1e-6f);
    EXPECT_EQ(shares.texels[1], 1.0f);
    EXPECT_EQ(shares.texels[2], 0.0f);
}

// Data, not colors: what the file says of its curve plays no part. 128 of 255 is nearest to a component of 0.
TEST_F(SurfacePicture, OfNormalsIsWhatItsFileStoresWhateverItSaysOfColors)
{
    Image stored(1, 1);
    stored.texels = {0.5f, 0.75f, 1.0f};
    test::writePng(folder / "plain.png", stored, 8);
    test::writePng(folder / "gamma.png", stored, 8, test::gammaChunk(0.5));
    for (const char* file : {"plain.png", "gamma.png"}) {
        const Image normals = read(file, SurfacePictureUse::Normal)->front();
        EXPECT_NEAR(normals.texels[0], 0.0f, 1.1f / 255.0f) << file;
        EXPECT_NEAR(normals.texels[1], 0.5f, 1.1f / 255.0f) << file;
        EXPECT_EQ(normals.texels[2], 1.0f) << file;
    }
}

// Lengths tell: (0.5, 0.5, 1) is 1 long only if it stands for (0, 0, 1), and (-0.6, 0, 0.8) only as it is.
TEST_F(SurfacePicture, OfNormalsInFloatsHoldsVectorsOrHalvesOfThem)
{
    const auto asRead = [&](const std::vector<float>& stored) {
        Image one(1, 1);
        one.texels = stored;
        writeImage(folder / "one.exr", one);
        const Image normals = read("one.exr", SurfacePictureUse::Normal)->front();
        return std::vector<float>(normals.texels.begin(), normals.texels.end());
    };
    EXPECT_EQ(asRead({0.5f, 0.5f, 1.0f}), (std::vector<float>{0.0f, 0.0f, 1.0f}));
    EXPECT_EQ(asRead({0.0f, 0.0f, 1.0f}), (std::vector<float>{0.0f, 0.0f, 1.0f}));
    EXPECT_EQ(asRead({-0.6f, 0.0f, 0.8f}), (std::vector<float>{-0.6f, 0.0f, 0.8f}));
}

TEST_F(SurfacePicture, OfNormalsIsReadWhereNormalsShowAndFlatWhileItIsMissing)
{
    const MapLayout probe{Parameterization::Latlong, 64, 0};
    scene.material.normalMap.source = "bumps.png";
    for (const Shading shading : {Shading::Material, Shading::Normals, Shading::Seams, Shading::Mips}) {
        scene.view.shading = shading;
        EXPECT_TRUE(makePlan(scene, probe).normalMap);
    }
    for (const Shading shading : {Shading::Wireframe, Shading::TexCoords, Shading::Bounds}) {
        scene.view.shading = shading;
        EXPECT_FALSE(makePlan(scene, probe).normalMap);
    }
    scene.view.shading = Shading::Material;
    scene.material.normalMap.strength = 0.0;
    EXPECT_FALSE(makePlan(scene, probe).normalMap);
    LivePicture live;
    WorkRecord record;
    const SurfacePicturePlan plan{"normal map", "material.normal_map.source", "bumps.png", SurfacePictureUse::Normal};
    const PictureLevels flat = live.update(scene, plan, {}, record);
    EXPECT_EQ(flat->front().texels[0], 0.0f);
    EXPECT_EQ(flat->front().texels[2], 1.0f);
    EXPECT_THAT(live.problem(), HasSubstr("material.normal_map.source: "));
}

TEST_F(SurfacePicture, ThatCannotBeReadIsToldInOneLineWithFieldAndFile)
{
    test::writeBytes(folder / "broken.png", "no picture");
    writeImage(folder / "wide.exr", Image(largestSurfacePicture + 1, 1));
    for (const char* file : {"missing.png", "broken.png", "wide.exr"}) {
        const std::string told = problem(file);
        EXPECT_THAT(told, HasSubstr("material.diffuse.picture: " + (folder / file).string())) << file;
        EXPECT_EQ(told.find('\n'), std::string::npos) << told;
    }
}

TEST_F(SurfacePicture, IsReadOnlyWhereTheMaterialShowsIt)
{
    const MapLayout probe{Parameterization::Latlong, 64, 0};
    EXPECT_EQ(test::findStage(makePlan(scene, probe), "read diffuse picture"), nullptr) << "none is named";
    scene.material.diffuse.picture = "checker.png";
    scene.material.sphereMap.flecks.pattern = "stripes.png";
    const auto leftOut = [&](const std::string& name, Because because) {
        const Plan plan = makePlan(scene, probe);
        test::expectLeftOut(plan, name, because);
        EXPECT_FALSE(name == "read diffuse picture" ? plan.diffusePicture : plan.fleckPattern);
    };
    leftOut("read diffuse picture", Because::DiffuseWeightIsZero);
    leftOut("read fleck pattern", Because::NoSphereMapForFlecks);
    scene.material.diffuse.weight = 1.0;
    scene.material.sphereMap.source = "jade";
    leftOut("read diffuse picture", Because::SphereMapReplaces);
    leftOut("read fleck pattern", Because::FleckDensityIsZero);
    scene.material.sphereMap.use = SphereMapUse::Add;
    scene.material.sphereMap.flecks.cells.density = 0.5;
    const Plan plan = makePlan(scene, probe);
    ASSERT_TRUE(plan.diffusePicture && plan.fleckPattern);
    EXPECT_EQ(test::needed<ReadsSurfacePicture>(plan, "read diffuse picture").source, "checker.png");
    EXPECT_EQ(plan.fleckPattern->source, "stripes.png");
    scene.view.shading = Shading::Normals;
    for (const char* name : {"read diffuse picture", "read fleck pattern"})
        EXPECT_EQ(test::leftOut<ShowsDebugView>(makePlan(scene, probe), name).shading, Shading::Normals);
    scene.view.shading = Shading::Material;
    scene.view.geometry = "window";
    leftOut("read diffuse picture", Because::RoomHasNoMaterial);
    leftOut("read fleck pattern", Because::RoomHasNoMaterial);
}

TEST_F(SurfacePicture, IsReadAgainOnceItsFileIsAnotherAndStaysWhenThatBreaks)
{
    const std::string file = (folder / "a.exr").string();
    const SurfacePicturePlan plan{"diffuse picture", "material.diffuse.picture", "a.exr", SurfacePictureUse::Color};
    LivePicture live;
    WorkRecord record;
    const auto update = [&] { return live.update(scene, plan, {}, record); };
    EXPECT_EQ(update()->front().texels[0], 1.0f) << "white: the object is shown without it";
    EXPECT_THAT(live.problem(), HasSubstr(file));
    EXPECT_EQ(live.keptFile(), "");

    writeImage(file, Image(2, 2, 3, 0.5f));
    const PictureLevels first = update();
    EXPECT_EQ(first->front().texels[0], 0.5f);
    EXPECT_EQ(live.problem(), "");
    EXPECT_EQ(update(), first) << "nothing has changed";

    writeImage(file, Image(2, 2, 3, 0.25f));
    std::filesystem::last_write_time(file, std::filesystem::last_write_time(file) + std::chrono::seconds(2));
    EXPECT_EQ(update()->front().texels[0], 0.25f);

    std::filesystem::remove(file);
    EXPECT_EQ(update()->front().texels[0], 0.25f);
    EXPECT_EQ(live.keptFile(), file);
    EXPECT_THAT(live.problem(), HasSubstr(file));
    EXPECT_EQ(live.update(scene, {}, {}, record), nullptr);
    EXPECT_EQ(live.problem(), "");
}

} // namespace
} // namespace mirrorball
