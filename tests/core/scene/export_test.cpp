#include "core/scene/export.h"

#include "core/base/error.h"
#include "core/base/version.h"
#include "core/image/builtin_probes.h"
#include "core/image/image_io.h"
#include "core/image/mip_pyramid.h"
#include "core/image/reproject.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <memory>

namespace mirrorball {
namespace {

class Export : public testing::Test {
protected:
    void SetUp() override
    {
        m_folder = std::filesystem::path(testing::TempDir()) /
                   ("mirrorball_export_" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
        std::filesystem::remove_all(m_folder);
    }
    void TearDown() override { std::filesystem::remove_all(m_folder); }

    nlohmann::json sidecar(const std::string& name) const
    {
        std::ifstream file(m_folder / (name + ".json"));
        return nlohmann::json::parse(file);
    }

    std::filesystem::path m_folder;
};

/// One of each kind, small.
Scene exportingScene()
{
    Scene scene;
    scene.probe.source = "builtin:cube-room";
    scene.probe.yawDeg = 30.0;
    scene.material.specular = {.lobe = SurfaceLobe::Phong, .exponent = 20.0};
    scene.exports = {
        {.name = "env", .kind = ExportKind::Source, .parameterization = Parameterization::Octahedral, .size = 64, .mips = true},
        {.name = "gloss", .kind = ExportKind::Specular, .parameterization = Parameterization::Paraboloid, .size = 32, .border = 2},
        {.name = "matt", .kind = ExportKind::Diffuse, .parameterization = Parameterization::Latlong, .size = 16, .file = "irradiance.hdr"},
        {.name = "chain", .kind = ExportKind::Chain, .size = 32, .half = true, .levels = 4}};
    return scene;
}

float largestDifference(const Image& a, const Image& b)
{
    EXPECT_EQ(a.width, b.width);
    EXPECT_EQ(a.height, b.height);
    float largest = a.texels.size() == b.texels.size() ? 0.0f : 1e30f;
    for (size_t i = 0; i < std::min(a.texels.size(), b.texels.size()); ++i)
        largest = std::max(largest, std::abs(a.texels[i] - b.texels[i]));
    return largest;
}

TEST_F(Export, WritesWhatDirectCallsGive)
{
    const ExportOutcome outcome = exportScene(exportingScene(), m_folder);
    FilterSource source(renderBuiltinProbe("cube-room"));
    const double yaw = 30.0 * pi / 180.0;

    const EnvironmentMap env = reproject(*source.latlong(), {.target = {Parameterization::Octahedral, 64, 0}, .yaw = yaw});
    EXPECT_EQ(largestDifference(readImage(m_folder / "env.exr"), env.image), 0.0f);
    EXPECT_EQ(largestDifference(readLevel(m_folder / "env.exr", 2), buildMipPyramid(env).levels[2].image), 0.0f);

    const auto direct = [&](const Lobe& lobe, const MapLayout& target) {
        return prefilter(source, {.lobe = lobe, .target = target, .yaw = yaw}).map.image;
    };
    EXPECT_LT(largestDifference(readImage(m_folder / "gloss.exr"), direct(phongLobe(20), {Parameterization::Paraboloid, 32, 2})), 2e-5f);
    EXPECT_LT(largestDifference(readImage(m_folder / "irradiance.hdr"), direct(diffuseLobe(), {Parameterization::Latlong, 16, 0})), 0.05f)
        << "the format keeps 8 bits of mantissa";
    for (int level = 1; level < 4; ++level) {
        const double roughness = level / 3.0;
        EXPECT_LT(largestDifference(readLevel(m_folder / "chain.exr", level),
                                    direct(ggxLobe(roughness * roughness), {Parameterization::Cube, 32 >> level, 0})),
                  0.01f)
            << "half floats, level " << level;
    }
    for (const std::filesystem::path& file : outcome.files)
        EXPECT_TRUE(std::filesystem::is_regular_file(file)) << file;
    EXPECT_EQ(outcome.files.size(), 8u);
    EXPECT_THAT(outcome.record.methods, testing::Contains("spectral"));
    EXPECT_EQ(std::count_if(outcome.record.stages.begin(), outcome.record.stages.end(),
                            [](const Stage& s) { return s.name.find("probe") != std::string::npos; }),
              1)
        << "the probe is read once for all";
    EXPECT_TRUE(std::filesystem::exists(m_folder / "export-manifest.json"));
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(m_folder), {}), 9) << "no temporary file is left";
}

TEST_F(Export, DescribesEachMapBesideIt)
{
    exportScene(exportingScene(), m_folder);
    const nlohmann::json gloss = sidecar("gloss");
    EXPECT_EQ(gloss["mirrorball_version"], version());
    EXPECT_EQ(gloss["files"], nlohmann::json({"gloss.exr"}));
    EXPECT_EQ(gloss["parameterization"], "paraboloid");
    EXPECT_EQ(gloss["width"], 64);
    EXPECT_EQ(gloss["border"], 2);
    EXPECT_EQ(gloss["indexed_by"], "reflection");
    EXPECT_EQ(gloss["handedness"], "right");
    EXPECT_EQ(gloss["up"], "+Y");
    EXPECT_EQ(gloss["lobe"]["kind"], "phong");
    EXPECT_EQ(gloss["lobe"]["exponent"], 20.0);
    EXPECT_THAT(gloss["color_space"].get<std::string>(), testing::HasSubstr("linear"));
    EXPECT_EQ(gloss["probe"]["source"], "builtin:cube-room");

    EXPECT_EQ(sidecar("matt")["indexed_by"], "normal");
    EXPECT_EQ(sidecar("matt")["files"], nlohmann::json({"irradiance.hdr"}));
    EXPECT_EQ(sidecar("env")["indexed_by"], "direction");
    EXPECT_EQ(sidecar("env")["levels"].size(), 7u);
    for (const char* name : {"env", "gloss", "chain"})
        EXPECT_EQ(openImage(m_folder / (std::string(name) + ".exr"))->info().attributes.at("mirrorball:indexed_by"),
                  sidecar(name)["indexed_by"].get<std::string>())
            << name;

    const nlohmann::json chain = sidecar("chain");
    EXPECT_EQ(chain["sample_type"], "half");
    EXPECT_THAT(chain["level_rule"].get<std::string>(), testing::HasSubstr("alpha = roughness^2"));
    ASSERT_EQ(chain["levels"].size(), 4u);
    EXPECT_EQ(chain["levels"][0]["lobe"]["kind"], "mirror");
    EXPECT_NEAR(chain["levels"][1]["lobe"]["roughness"].get<double>(), 1.0 / 3, 1e-12);
    EXPECT_EQ(chain["levels"][3]["size"], 4);
}

/// A place of a map, u to the right and v down, both in [0, 1], and the direction that a side-car's words put there.
struct NamedPlace {
    Parameterization kind;
    const char* words;
    glm::dvec2 place;
    glm::dvec3 direction;
};

// What a side-car says of its axes is held against the map: the words must be there, and the texel must look that way.
TEST_F(Export, SaysWhereTheAxesLieInEachKindOfMap)
{
    const std::vector<NamedPlace> places{{Parameterization::Latlong, "the center is +Z", {0.5, 0.5}, {0, 0, 1}},
                                         {Parameterization::Latlong, "the left quarter +X", {0.25, 0.5}, {1, 0, 0}},
                                         {Parameterization::Latlong, "the top +Y", {0.5, 0.0}, {0, 1, 0}},
                                         {Parameterization::Cube, "faces +X -X +Y -Y +Z -Z", {0.5, 0.5 / 6}, {1, 0, 0}},
                                         {Parameterization::Cube, "faces +X -X +Y -Y +Z -Z", {0.5, 4.5 / 6}, {0, 0, 1}},
                                         {Parameterization::Sphere, "the center is +Z", {0.5, 0.5}, {0, 0, 1}},
                                         {Parameterization::Sphere, "right +X, top +Y", {0.5 + 0.5 / std::sqrt(2.0), 0.5}, {1, 0, 0}},
                                         {Parameterization::Angular, "the angle from +Z over pi", {0.5, 0.5}, {0, 0, 1}},
                                         {Parameterization::Angular, "left is +X, top +Y", {0.25, 0.5}, {1, 0, 0}},
                                         {Parameterization::Paraboloid, "front half (z >= 0) on the left", {0.25, 0.5}, {0, 0, 1}},
                                         {Parameterization::Paraboloid, "back half on the right", {0.75, 0.5}, {0, 0, -1}},
                                         {Parameterization::Octahedral, "+Y at the center", {0.5, 0.5}, {0, 1, 0}},
                                         {Parameterization::Octahedral, "right is +X and down +Z", {1.0, 0.5}, {1, 0, 0}},
                                         {Parameterization::Octahedral, "right is +X and down +Z", {0.5, 1.0}, {0, 0, 1}}};
    Scene scene;
    scene.probe.source = "builtin:axes";
    constexpr int size = 64;
    for (const Parameterization kind : allParameterizations) {
        EXPECT_TRUE(std::any_of(places.begin(), places.end(), [&](const NamedPlace& place) { return place.kind == kind; })) << name(kind);
        scene.exports.push_back({.name = std::string(name(kind)), .kind = ExportKind::Source, .parameterization = kind, .size = size});
    }
    exportScene(scene, m_folder);
    for (const NamedPlace& place : places) {
        EXPECT_THAT(sidecar(std::string(name(place.kind)))["axes"].get<std::string>(), testing::HasSubstr(place.words));
        const MapLayout layout{place.kind, size, 0};
        const int x = std::clamp(static_cast<int>(place.place.x * layout.width()), 0, layout.width() - 1);
        const int y = std::clamp(static_cast<int>(place.place.y * layout.height()), 0, layout.height() - 1);
        EXPECT_GT(glm::dot(texelDirection(layout, x, y), place.direction), std::cos(0.1)) << name(place.kind) << ": " << place.words;
    }
}

TEST_F(Export, WritesOnlyWhatIsAskedForAndNamesTheKnownOnes)
{
    const ExportOutcome outcome = exportScene(exportingScene(), m_folder, {.only = {"matt"}});
    EXPECT_THAT(outcome.files, testing::ElementsAre(m_folder / "irradiance.hdr", m_folder / "matt.json"));
    try {
        exportScene(exportingScene(), m_folder, {.only = {"mat"}});
        ADD_FAILURE() << "an unknown name was accepted";
    } catch (const InvalidArgument& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr("env, gloss, matt, chain"));
    }
    EXPECT_THROW(exportScene({}, m_folder), InvalidArgument) << "a scene without exports";
}

TEST_F(Export, ReplacesOlderFilesAndRefusesAFolderThatIsAFile)
{
    Scene scene = exportingScene();
    exportScene(scene, m_folder, {.only = {"matt"}});
    scene.exports[2].size = 8;
    exportScene(scene, m_folder, {.only = {"matt"}});
    EXPECT_EQ(readImage(m_folder / "irradiance.hdr").height, 8);
    EXPECT_THROW(exportScene(scene, m_folder / "irradiance.hdr", {.only = {"matt"}}), WorkError);
}

TEST_F(Export, AFormatThatCannotBeWrittenLeavesNothing)
{
    Scene scene = exportingScene();
    scene.exports[2].file = "irradiance.xyz";
    EXPECT_THROW(exportScene(scene, m_folder, {.only = {"matt"}}), InvalidArgument);
    EXPECT_TRUE(!std::filesystem::exists(m_folder) || std::filesystem::is_empty(m_folder));
}

TEST_F(Export, ExposureScalesTheRadiance)
{
    Scene scene = exportingScene();
    scene.exports = {{.name = "plain", .kind = ExportKind::Specular, .size = 8}};
    exportScene(scene, m_folder);
    const Image plain = readImage(m_folder / "plain.exr");
    scene.probe.exposure = 2.0;
    exportScene(scene, m_folder);
    const Image brighter = readImage(m_folder / "plain.exr");
    for (size_t i = 0; i < plain.texels.size(); ++i)
        EXPECT_FLOAT_EQ(brighter.texels[i], 4.0f * plain.texels[i]);
}

TEST_F(Export, ReadsBackAnExportedMapAsTheProbeItIs)
{
    Scene scene = exportingScene();
    scene.exports = {{.name = "cube", .kind = ExportKind::Source, .size = 32}};
    exportScene(scene, m_folder);
    scene.folder = m_folder;
    scene.probe = {.source = "cube.exr"};
    EXPECT_EQ(probeLayout(scene), (MapLayout{Parameterization::Cube, 32, 0}));
    scene.exports[0].file = "again.exr";
    exportScene(scene, m_folder);
    EXPECT_EQ(readImage(m_folder / "again.exr"), readImage(m_folder / "cube.exr")) << "the same layout is not resampled";
}

/// Two fills, the upper one in all levels but the largest.
EmbeddedSphereMap mapWithLevels()
{
    SphereMapDocument map;
    map.title = "Two colors";
    map.index = SphereMapIndex::Reflection;
    map.layers = {{.name = "Fine", .content = FillLayer{.color = {1, 0, 0}}},
                  {.name = "Coarse", .content = FillLayer{.color = {0, 1, 0}}, .firstLevel = 1}};
    return {std::make_shared<const SphereMapDocument>(map)};
}

TEST_F(Export, WritesTheLevelsOfAPaintedMapAsTheSceneShowsThem)
{
    Scene scene;
    scene.probe.source = "gone.exr"; // it is not asked for
    scene.material.sphereMap.document = mapWithLevels();
    scene.exports = {{.name = "map", .kind = ExportKind::Painted, .size = 8, .mips = true}};
    const ExportOutcome outcome = exportScene(scene, m_folder);
    EXPECT_THAT(outcome.files, testing::ElementsAre(m_folder / "map.exr", m_folder / "map.json"));
    EXPECT_THAT(outcome.record.methods, testing::ElementsAre("paint"));
    EXPECT_EQ(readLevel(m_folder / "map.exr", 0).texel(4, 4)[0], 1.0f);
    EXPECT_EQ(readLevel(m_folder / "map.exr", 1).texel(2, 2)[1], 1.0f);
    EXPECT_EQ(sidecar("map")["indexed_by"], "reflection");
    EXPECT_EQ(sidecar("map")["levels"].size(), 4u);
    EXPECT_EQ(sidecar("map")["sphere_map"]["title"], "Two colors");
    EXPECT_THAT(sidecar("map")["level_rule"].get<std::string>(), testing::StartsWith("authored"));

    scene.material.sphereMap.levels = SphereMapLevels::Plain;
    exportScene(scene, m_folder);
    EXPECT_EQ(readLevel(m_folder / "map.exr", 1).texel(2, 2)[0], 1.0f);
    EXPECT_THAT(sidecar("map")["level_rule"].get<std::string>(), testing::StartsWith("averages"));
}

TEST_F(Export, WritesAChainAsOneFileALevelAndFaceWhereTheNameAsksForIt)
{
    Scene scene = exportingScene();
    scene.exports = {{.name = "whole", .kind = ExportKind::Chain, .size = 8},
                     {.name = "parts", .kind = ExportKind::Chain, .size = 8, .file = "%s-%d.exr"},
                     {.name = "mips", .kind = ExportKind::Source, .size = 4, .file = "mips.%d.hdr", .mips = true}};
    exportScene(scene, m_folder);
    for (int level = 0; level < 4; ++level) {
        const Image whole = readLevel(m_folder / "whole.exr", level);
        const Image top = readImage(m_folder / ("py-" + std::to_string(level) + ".exr"));
        ASSERT_EQ(top.width, 8 >> level);
        EXPECT_TRUE(std::equal(top.texels.begin(), top.texels.end(), whole.row(2 * whole.width))) << level;
    }
    EXPECT_EQ(sidecar("parts")["files"].size(), 24u);
    EXPECT_EQ(sidecar("mips")["files"], nlohmann::json({"mips.0.hdr", "mips.1.hdr", "mips.2.hdr"}));
}

TEST(SceneMaps, AreBuiltOnlyWhereThePlanNeedsThem)
{
    Scene scene;
    scene.map.size = 32;
    scene.view.background.kind = Backdrop::None;
    scene.material.lambda = 1.0;
    SceneMaps maps = buildMaps(planScene(scene));
    ASSERT_TRUE(maps.specular);
    EXPECT_EQ(maps.specular->size(), 6u);
    EXPECT_FALSE(maps.diffuse);
    EXPECT_FALSE(maps.background);

    scene.material.specular.weight = 0.0;
    maps = buildMaps(planScene(scene));
    EXPECT_FALSE(maps.specular);
    EXPECT_TRUE(maps.record.stages.empty()) << "nothing was opened";
}

} // namespace
} // namespace mirrorball
