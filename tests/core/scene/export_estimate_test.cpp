#include "core/scene/export_estimate.h"

#include "core/base/error.h"
#include "core/scene/export.h"
#include "core/scene/export_command.h"
#include "core/scene/scene_maps.h"

#include "support/temporary_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

namespace mirrorball {
namespace {

/// Every kind of target and file that behaves differently.
Scene manyTargets()
{
    Scene scene;
    scene.probe.source = "builtin:studio";
    scene.material.specular = {.lobe = SurfaceLobe::Phong, .exponent = 20.0};
    scene.exports = {
        {.name = "env", .kind = ExportKind::Source, .parameterization = Parameterization::Octahedral, .size = 128, .mips = true},
        {.name = "gloss",
         .kind = ExportKind::Specular,
         .parameterization = Parameterization::Paraboloid,
         .size = 64,
         .border = 2,
         .half = true},
        {.name = "faces", .kind = ExportKind::Specular, .size = 64, .file = "face_%s.hdr"},
        {.name = "matt", .kind = ExportKind::Diffuse, .parameterization = Parameterization::Latlong, .size = 32, .file = "irradiance.hdr"},
        {.name = "picture", .kind = ExportKind::Source, .parameterization = Parameterization::Latlong, .size = 64, .file = "picture.png"},
        {.name = "chain", .kind = ExportKind::Chain, .size = 32, .levels = 3},
        {.name = "odd",
         .kind = ExportKind::Chain,
         .parameterization = Parameterization::Sphere,
         .size = 26,
         .file = "odd.hdr",
         .levels = 3},
        {.name = "numbered", .kind = ExportKind::Chain, .size = 32, .file = "c_%s.%d.exr", .levels = 3},
        {.name = "matcap", .kind = ExportKind::Painted, .size = 256, .border = 1, .file = "matcap.png"},
        {.name = "levels", .kind = ExportKind::Painted, .size = 128, .half = true, .mips = true},
        {.name = "tiff", .kind = ExportKind::Painted, .size = 128, .file = "tiff_%d.tif", .mips = true},
        {.name = "pictures", .kind = ExportKind::Painted, .size = 128, .file = "pictures.png", .mips = true}};
    scene.material.sphereMap.source = "jade";
    return scene;
}

std::vector<ExportEstimate> estimates(const Scene& scene)
{
    return estimateExports(makePlan(scene, probeLayout(scene), {.picture = false, .exports = std::vector<std::string>{}}));
}

// Sizes: the promise of the header, a factor of two, even of maps as small as these, whose headers weigh much.
TEST(ExportEstimate, NamesTheFilesThatAreWrittenAndTheirSizesWithinAFactorOfTwo)
{
    const test::TemporaryFolder folder;
    const Scene scene = manyTargets();
    std::vector<std::string> expected, written;
    for (const std::filesystem::path& file : exportScene(scene, folder.path()).files)
        written.push_back(file.filename().string());
    for (const ExportEstimate& estimate : estimates(scene)) {
        std::int64_t bytes = 0;
        for (const std::string& file : estimate.files) {
            expected.push_back(file);
            bytes += static_cast<std::int64_t>(std::filesystem::file_size(folder / file));
        }
        const double ratio = static_cast<double>(estimate.fileBytes) / static_cast<double>(bytes);
        EXPECT_GT(ratio, 0.5) << estimate.name << ": " << estimate.fileBytes << " against " << bytes;
        EXPECT_LT(ratio, 2.0) << estimate.name << ": " << estimate.fileBytes << " against " << bytes;
    }
    EXPECT_EQ(expected, written);
}

TEST(ExportEstimate, CountsTexelsOfAllLevels)
{
    const std::vector<ExportEstimate> all = estimates(manyTargets());
    EXPECT_EQ(all[0].levels, 8);
    EXPECT_EQ(all[0].texelBytes, 12 * (4 * 128 * 128 - 1) / 3); // 1 + 4 + ... + 128^2
    EXPECT_EQ(all[1].texelBytes, 6 * 128 * 64);
    EXPECT_EQ(all[2].texelBytes, 4 * 6 * 64 * 64);
    EXPECT_EQ(all[5].texelBytes, 12 * 6 * (32 * 32 + 16 * 16 + 8 * 8));
    EXPECT_EQ(all[9].levels, 8);
    EXPECT_EQ(all[8].texelBytes, 3 * 256 * 256);
    EXPECT_EQ(all[9].texelBytes, 6 * (4 * 128 * 128 - 1) / 3);
}

/// The times: everything that the plan expects to be done is in one export's or in what they share, once. (How near they come to what is
/// taken, build/ci/bin/export_table shows.)
TEST(ExportEstimate, TimesAddUpToThePlans)
{
    const Scene scene = manyTargets();
    const Plan plan = makePlan(scene, probeLayout(scene), {.picture = false, .exports = std::vector<std::string>{}});
    double stages = 0.0, exports = plan.sharedSeconds;
    for (const PlannedStage& stage : plan.decisions)
        stages += stage.expected.seconds;
    for (const ExportEstimate& estimate : estimateExports(plan)) {
        EXPECT_GT(estimate.seconds, 0.0) << estimate.name; // saving, if nothing else
        exports += estimate.seconds;
    }
    EXPECT_GT(plan.sharedSeconds, 0.0);
    EXPECT_NEAR(exports, stages, 1e-9 * stages);
}

TEST(ExportEstimate, TimesGrowWithLevelsTexelsAndWhatCompressionTakes)
{
    const auto seconds = [](const ExportTarget& target) {
        Scene scene = manyTargets();
        scene.exports = {target};
        return estimates(scene).front().seconds;
    };
    const ExportTarget plain{.name = "x", .kind = ExportKind::Source, .size = 256, .file = "x.exr"};
    ExportTarget levels = plain, tiff = plain, large = plain;
    levels.mips = true;
    tiff.file = "x.tif"; // deflated floats
    large.size = 512;
    EXPECT_GT(seconds(levels), 1.3 * seconds(plain));
    EXPECT_GT(seconds(tiff), 3.0 * seconds(plain));
    EXPECT_GT(seconds(large), 2.0 * seconds(plain));
}

TEST(ExportEstimate, RefusesFacesOfAMapThatIsNoCube)
{
    Scene scene = manyTargets();
    scene.exports = {{.name = "x", .parameterization = Parameterization::Latlong, .size = 8, .file = "a_%s.exr"}};
    EXPECT_THROW(estimates(scene), InvalidArgument);
}

TEST(ExportEstimate, WritesSizesForPeople)
{
    EXPECT_EQ(byteText(0), "0 bytes");
    EXPECT_EQ(byteText(999), "999 bytes");
    EXPECT_EQ(byteText(1000), "1.0 kB");
    EXPECT_EQ(byteText(312'400), "312 kB");
    EXPECT_EQ(byteText(999'999), "1.0 MB");
    EXPECT_EQ(byteText(1'440'000), "1.4 MB");
    EXPECT_EQ(byteText(50'300'000'000), "50 GB");
}

TEST(ExportCommand, NamesSceneFolderAndExports)
{
    EXPECT_EQ(exportCommand("/a/show room.mirrorball", "/b"), "mirrorball export '/a/show room.mirrorball' -o /b");
    EXPECT_EQ(exportCommand("-s.mirrorball", "-d", {"gloss", "-x"}), "mirrorball export ./-s.mirrorball -o ./-d --only=gloss --only=-x");
}

} // namespace
} // namespace mirrorball
