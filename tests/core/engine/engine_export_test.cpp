#include "core/engine/engine_export.h"

#include "core/base/error.h"
#include "core/engine/engine_snippets.h"
#include "core/filter/prefilter.h"
#include "core/image/builtin_probes.h"
#include "core/image/container/container_file.h"
#include "core/image/container/play_canvas_atlas.h"
#include "core/image/map_file.h"
#include "core/image/probe_file.h"
#include "support/probe_builders.h"
#include "support/temporary_folder.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <map>

namespace mirrorball {
namespace {

using testing::HasSubstr;

constexpr double step = 0.02; ///< tolerance of the colors that were read off in the engines

const EnvironmentMap& axes()
{
    static const EnvironmentMap map = renderBuiltinProbe("axes", {Parameterization::Latlong, 512, 0});
    return map;
}

EngineExport exported(const std::string& engine, const std::filesystem::path& folder, int size = 0)
{
    FilterSource source(axes());
    return exportForEngine(source, engineProfile(engine), {.size = size, .name = "light"}, folder);
}

glm::vec3 texel(const Image& stacked, int face, int x, int y)
{
    const float* t = stacked.texel(x, face * stacked.width + y);
    return {t[0], t[1], t[2]};
}

void expectColor(const glm::vec3& seen, float r, float g, float b)
{
    EXPECT_LT(glm::distance(seen, glm::vec3(r, g, b)), 2.0 * step) << seen.r << ' ' << seen.g << ' ' << seen.b;
}

// The corner triangles and faces of builtin:axes as Filament, three.js, PlayCanvas and Babylon.js showed them the right way round.
TEST(EngineExport, FilamentsFacesAreOursAndItsFileHasTheSizeOfItsLevels)
{
    const test::TemporaryFolder folder;
    exported("filament", folder.path());
    const Texture ibl = readContainer(folder / "light_ibl.ktx").texture;
    ASSERT_EQ(ibl.levels.size(), 5u);
    EXPECT_EQ(ibl.levels.back().width, 16);
    for (int face = 0; face < 6; ++face)
        expectColor(texel(ibl.levels[0], face, 8, 8), .95f, .95f, .95f);
    expectColor(texel(ibl.levels[0], 0, 247, 8), .58f, .05f, .04f);
    expectColor(texel(ibl.levels[0], 4, 247, 8), .05f, .10f, .58f);
    EXPECT_EQ(readContainer(folder / "light_skybox.ktx").texture.levels.size(), 1u);
    const std::string& sh = ibl.metadata.at("sh");
    EXPECT_THAT(sh, testing::StartsWith("0.37"));
    EXPECT_EQ(std::count(sh.begin(), sh.end(), '\n'), 9);
}

TEST(EngineExport, ThreesAndPlayCanvasFacesAreMirroredInX)
{
    const test::TemporaryFolder folder;
    exported("three", folder / "three");
    exported("playcanvas", folder / "playcanvas");
    const Texture cubes[] = {readContainer(folder / "three/light_pmrem.ktx2").texture,
                             readContainer(folder / "playcanvas/light_skybox.dds").texture};
    EXPECT_EQ(cubes[0].levels.size(), 6u);
    EXPECT_EQ(cubes[0].levels.back().width, 8);
    for (const Texture& cube : cubes) {
        for (int face = 0; face < 6; ++face)
            expectColor(texel(cube.levels[0], face, 247, 8), .95f, .95f, .95f);
        expectColor(texel(cube.levels[0], 0, 8, 8), .04f, .39f, .43f);
        expectColor(texel(cube.levels[0], 1, 8, 8), .58f, .05f, .04f);
        expectColor(texel(cube.levels[0], 5, 8, 8), .68f, .47f, .04f);
    }
}

TEST(EngineExport, BabylonsFacesAreMirroredInXAndStandBottomUp)
{
    const test::TemporaryFolder folder;
    exported("babylon", folder.path());
    const Texture stored = readContainer(folder / "light.env").texture;
    ASSERT_EQ(stored.levels.size(), 9u);
    for (int face = 0; face < 6; ++face)
        expectColor(texel(stored.levels[0], face, 247, 247), .95f, .95f, .95f);
    expectColor(texel(stored.levels[0], 0, 8, 247), .04f, .39f, .43f);
    const Probe probe = readProbe((folder / "light.env").string());
    EXPECT_LT(glm::distance(probe.map.radiance({1.0, 0.1, 0.2}), axes().radiance({1.0, 0.1, 0.2})), step) << "as a probe it stands upright";
}

TEST(EngineExport, LatlongsAreTurnedAsTheEngineLooksThemUp)
{
    const test::TemporaryFolder folder;
    const EnvironmentMap& ours = axes();
    // What the center of the picture shows, as a direction of ours.
    const std::map<std::string, glm::dvec3> centers{{"three", {1, 0, 0}},   {"model-viewer", {1, 0, 0}}, {"blender", {1, 0, 0}},
                                                    {"godot", {0, 0, 1}},   {"usd", {0, 0, 1}},          {"unity", {-1, 0, 0}},
                                                    {"unreal", {0, 0, -1}}, {"materialx", {0, 0, -1}}};
    for (const auto& [engine, center] : centers) {
        const EngineExport done = exported(engine, folder / engine);
        std::filesystem::path picture;
        for (const auto& file : done.files)
            if (file.extension() == ".hdr" || file.extension() == ".exr")
                picture = file;
        const EnvironmentMap map = readProbe(picture.string()).map;
        const glm::dvec3 aside = glm::normalize(center + 0.3 * glm::cross(center, glm::dvec3(0, 1, 0)) + glm::dvec3(0, 0.2, 0));
        const double turn = std::atan2(center.x, center.z);
        EXPECT_LT(glm::distance(map.radiance(yawed(aside, -turn)), ours.radiance(aside)), step) << engine;
    }
}

TEST(EngineExport, LevelsAreTheProbeFilteredByTheLawOfTheEngine)
{
    FilterSource source(test::noiseProbe(64, 2));
    const test::TemporaryFolder folder;
    exportForEngine(source, engineProfile("bevy"), {.size = 32, .name = "light"}, folder.path());
    const Texture specular = readContainer(folder / "light_specular.ktx2").texture;
    ASSERT_EQ(specular.levels.size(), 6u);
    const EnvironmentMap exact = prefilter(source, {.lobe = ggxLobe(0.6 * 0.6), .target = {Parameterization::Cube, 4, 0}}).map;
    const Image ours = fromStored(specular.levels[3], mirroredInZ()); // level 3 of 6: roughness 0.6
    for (size_t i = 0; i < ours.texels.size(); ++i)
        EXPECT_NEAR(ours.texels[i], exact.image.texels[i], 2e-3 * exact.image.texels[i]);
    const Texture diffuse = readContainer(folder / "light_diffuse.ktx2").texture;
    const EnvironmentMap irradiance = prefilter(source, {.lobe = diffuseLobe(), .target = {Parameterization::Cube, 32, 0}}).map;
    EXPECT_NEAR(fromStored(diffuse.levels[0], mirroredInZ()).texel(5, 70)[1], irradiance.image.texel(5, 70)[1], 2e-3);
}

TEST(EngineExport, PlanNamesTheFilesThatAreWrittenAndTheirBytes)
{
    for (const EngineProfile& profile : engineProfiles()) {
        const test::TemporaryFolder folder;
        FilterSource source(test::noiseProbe(64, 2));
        const EngineExportOptions options{.size = profile.law ? 64 : 0, .name = "light"};
        const std::vector<EngineFilePlan> plan = planEngineExport(profile, options, {Parameterization::Latlong, 64, 0});
        const EngineExport done = exportForEngine(source, profile, options, folder.path());
        ASSERT_EQ(done.files.size(), plan.size()) << profile.word;
        for (size_t i = 0; i < plan.size(); ++i) {
            EXPECT_EQ(done.files[i], folder.path() / plan[i].file);
            const auto bytes = static_cast<double>(std::filesystem::file_size(done.files[i]));
            if (const std::string extension = done.files[i].extension().string(); extension.starts_with(".ktx") || extension == ".dds") {
                EXPECT_NEAR(bytes, static_cast<double>(plan[i].bytes), 900.0) << plan[i].file;
            }
            EXPECT_GT(bytes, 100.0) << plan[i].file;
        }
        EXPECT_THAT(engineSnippet(profile.word, "light"), testing::AllOf(HasSubstr("light"), testing::Not(HasSubstr("{name}"))));
    }
}

TEST(EngineExport, BytesDoNotDependOnTheNumberOfThreads)
{
    for (const std::string engine : {"babylon", "playcanvas", "three"}) {
        const test::TemporaryFolder one, four;
        for (const auto& [threads, folder] : {std::pair{1, &one}, std::pair{4, &four}}) {
            FilterSource source(test::noiseProbe(64, 2));
            exportForEngine(source, engineProfile(engine), {.size = 32, .name = "light"}, folder->path(), {.threads = threads});
        }
        for (const auto& entry : std::filesystem::directory_iterator(one.path()))
            EXPECT_EQ(test::readBytes(entry.path()), test::readBytes(four / entry.path().filename().string())) << entry.path();
    }
}

TEST(EngineExport, RefusesWhatAnEngineDoesNotTake)
{
    EXPECT_THROW(engineProfile("quake"), InvalidArgument);
    EXPECT_THROW(checkedSize(engineProfile("filament"), 100), InvalidArgument) << "no power of two";
    EXPECT_THROW(checkedSize(engineProfile("filament"), 16), InvalidArgument) << "no level would be rough";
    EXPECT_THROW(checkedSize(engineProfile("babylon"), 4096), InvalidArgument);
    EXPECT_THROW(checkedSize(engineProfile("godot"), 100000), InvalidArgument);
    const MapLayout probe{Parameterization::Latlong, 64, 0};
    for (const std::string name : {"", "a/b", "-x", "a b", "..", "%s"})
        EXPECT_THROW(planEngineExport(engineProfile("three"), {.name = name}, probe), InvalidArgument) << name;
}

TEST(EngineExport, WarnsOfLightThatTheFilesClip)
{
    ProbeStatistics bright;
    bright.largestValue = 1e5;
    bright.sunShare = 0.6;
    EXPECT_EQ(engineWarnings(engineProfile("filament"), bright).size(), 2u);
    EXPECT_THAT(engineWarnings(engineProfile("babylon"), bright).front(), HasSubstr("255"));
    EXPECT_EQ(engineWarnings(engineProfile("godot"), bright).size(), 1u) << "RGBE holds it";
    EXPECT_TRUE(engineWarnings(engineProfile("three"), {}).empty());
}

TEST(EngineExport, TheAtlasHoldsTheSourceAndTheDiffuseLight)
{
    FilterSource source(axes());
    const Image atlas = playCanvasAtlas(source, {});
    for (const auto& r : play_canvas_atlas::rectangles)
        if (r.content == play_canvas_atlas::Content::Diffuse) {
            const glm::dvec3 d = play_canvas_atlas::direction(r, 17, 9);
            const EnvironmentMap exact = prefilter(source, {.lobe = diffuseLobe(), .target = {Parameterization::Latlong, 128, 0}}).map;
            const float* t = atlas.texel(r.x + 17, r.y + 9);
            EXPECT_LT(glm::distance(glm::vec3(t[0], t[1], t[2]), exact.radiance(d)), 1e-3f);
        }
}

} // namespace
} // namespace mirrorball
