#include "core/image/thumbnail.h"

#include "core/base/error.h"
#include "core/image/builtin_probes.h"
#include "core/image/map_file.h"
#include "core/image/mip_pyramid.h"
#include "core/image/probe_file.h"
#include "core/image/reproject.h"

#include "support/probe_builders.h"
#include "support/shared_data.h"
#include "support/temporary_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace mirrorball {
namespace {

TEST(Thumbnail, OfAConstantProbeIsConstantInEveryParameterization)
{
    const test::TemporaryFolder folder;
    for (const Parameterization kind : allParameterizations) {
        const MapLayout layout{kind, 100, kind == Parameterization::Paraboloid ? 7 : 0}; // no multiple of the thumbnail's size
        EnvironmentMap map(layout);
        std::fill(map.image.texels.begin(), map.image.texels.end(), 3.0f);
        const std::filesystem::path file = folder / (std::string(name(kind)) + ".exr");
        writeMap(file, {map});
        const ReducedProbe reduced = reduceProbe(file.string(), {.height = 16});
        EXPECT_EQ(reduced.detection.layout, layout);
        EXPECT_LE(reduced.image.width, 200);
        for (const float value : thumbnailOf(reduced, 16).image.texels)
            EXPECT_NEAR(value, 3.0f, 1e-4f) << name(kind);
    }
}

// The mean of an image is that of its area averages, whatever the sizes: the first of the moments that a box keeps.
TEST(Thumbnail, KeepsTheMeanOfTheImage)
{
    const test::TemporaryFolder folder;
    const EnvironmentMap probe = test::noiseProbe(90, 4);
    writeMap(folder / "noise.exr", {probe});
    const ReducedProbe reduced = reduceProbe((folder / "noise.exr").string(), {.height = 16});
    EXPECT_EQ(reduced.image.width, 64);
    EXPECT_EQ(reduced.image.height, 32);
    const auto mean = [](const Image& image) {
        double sum = 0.0;
        for (const float value : image.texels)
            sum += value;
        return sum / static_cast<double>(image.texels.size());
    };
    EXPECT_NEAR(mean(reduced.image) / mean(probe.image), 1.0, 1e-6);
}

TEST(Thumbnail, ReadsAMipLevelWhereTheFileHasOne)
{
    const test::TemporaryFolder folder;
    const MipPyramid pyramid = buildMipPyramid(renderBuiltinProbe("cube-room", {Parameterization::Latlong, 256, 0}));
    writeMap(folder / "mips.exr", pyramid.levels);
    const ReducedProbe reduced = reduceProbe((folder / "mips.exr").string(), {.height = 16});
    EXPECT_TRUE(reduced.fromMip);
    EXPECT_EQ(reduced.info.width, 512);
    EXPECT_EQ(reduced.image.width, 64);
    const ReducedProbe survey = surveyProbe((folder / "mips.exr").string(), {.height = 16}).reduced;
    EXPECT_FALSE(survey.fromMip);
    for (size_t i = 0; i < survey.image.texels.size(); ++i)
        EXPECT_NEAR(reduced.image.texels[i], survey.image.texels[i], 0.2f);
}

// What is +X in the file is +X in its thumbnail: left of the center of a latlong.
TEST(Thumbnail, ShowsForeignArrangementsTheRightWayRound)
{
    const test::TemporaryFolder folder;
    const EnvironmentMap latlong =
        reproject(renderBuiltinProbe("axes", {Parameterization::Latlong, 512, 0}), {.target = {Parameterization::Latlong, 64, 0}});
    for (const Parameterization kind : allParameterizations) {
        const std::filesystem::path file = folder / (std::string(name(kind)) + ".exr");
        writeMap(file, {renderBuiltinProbe("axes", {kind, 256, 0})});
        const EnvironmentMap thumbnail = thumbnailOf(reduceProbe(file.string(), {.height = 64}), 64);
        // Beside the names, on each face's own color: a stroke of a letter is a texel wide here.
        for (const glm::dvec3& d : {glm::dvec3(1, 0.8, 0.4), {-1, 0.8, 0.4}, {0.4, 1, 0.8}, {0.4, -1, 0.8}, {0.4, 0.8, 1}, {0.4, 0.8, -1}})
            EXPECT_LT(glm::length(thumbnail.radiance(d) - latlong.radiance(d)), 0.25f) << name(kind);
    }
}

TEST(Thumbnail, OffersTheKindsThatASquareMayBe)
{
    const test::TemporaryFolder folder;
    writeImage(folder / "square.hdr", renderBuiltinProbe("studio", {Parameterization::Sphere, 64, 0}).image);
    const ReducedProbe reduced = reduceProbe((folder / "square.hdr").string(), {.height = 32});
    EXPECT_FALSE(reduced.detection.certain);
    EXPECT_THAT(possibleKinds(reduced),
                testing::UnorderedElementsAre(Parameterization::Angular, Parameterization::Sphere, Parameterization::Octahedral));
    const EnvironmentMap expected = renderBuiltinProbe("studio", {Parameterization::Latlong, 32, 0});
    const EnvironmentMap guess = thumbnailOf(reduced, 32, Parameterization::Sphere);
    const glm::dvec3 d = glm::normalize(glm::dvec3(0.3, 0.2, 1.0));
    EXPECT_NEAR(guess.radiance(d).g, expected.radiance(d).g, 0.1 * expected.radiance(d).g + 0.02);
    EXPECT_THAT(possibleKinds(reduceProbe("builtin:sky", {.height = 16})), testing::ElementsAre(Parameterization::Latlong));
}

TEST(Survey, CountsAndMeasuresLikeReadingTheProbeWhole)
{
    const test::TemporaryFolder folder;
    EnvironmentMap probe = test::sunProbe(64, 5e4f, 90, 20);
    probe.image.texel(3, 3)[0] = std::numeric_limits<float>::quiet_NaN();
    probe.image.texel(5, 9)[1] = std::numeric_limits<float>::infinity();
    probe.image.texel(7, 9)[2] = -1.0f;
    const std::string file = (folder / "sun.exr").string();
    writeMap(file, {probe});
    const Probe whole = readProbe(file);
    const ProbeStatistics expected = statistics(whole.map);
    const ProbeSurvey survey = surveyProbe(file, {.height = 16});
    EXPECT_EQ(survey.reduced.repaired, whole.repaired);
    EXPECT_EQ(survey.statistics.maxLuminance, expected.maxLuminance);
    EXPECT_EQ(survey.statistics.sunShare, expected.sunShare);
    EXPECT_EQ(survey.statistics.meanLuminance, expected.meanLuminance);
    EXPECT_EQ(survey.statistics.brightestDirection, expected.brightestDirection);
}

TEST(Survey, FindsTheSunInACross)
{
    const test::TemporaryFolder folder;
    Image cross(4 * 16, 3 * 16, 3, 0.01f);
    cross.texel(24, 24)[0] = 1000.0f; // in the middle of the front face, +Z
    writeImage(folder / "cross.hdr", cross);
    const ProbeSurvey survey = surveyProbe((folder / "cross.hdr").string(), {.height = 8});
    EXPECT_EQ(survey.reduced.detection.arrangement, Arrangement::HorizontalCross);
    EXPECT_GT(survey.statistics.brightestDirection.z, 0.99);
    EXPECT_GT(survey.statistics.sunShare, 0.5);
}

TEST(Survey, RefusesWhatIsNoProbe)
{
    const test::TemporaryFolder folder;
    test::writeBytes(folder / "broken.exr", "not an image");
    EXPECT_THROW(reduceProbe((folder / "broken.exr").string()), FileError);
    EXPECT_THROW(surveyProbe((folder / "missing.hdr").string()), FileError);
    EXPECT_THROW(reduceProbe("builtin:nowhere"), InvalidArgument);
    EXPECT_THROW(reduceProbe("builtin:sky", {.height = 0}), InvalidArgument);
}

TEST(Survey, StopsWhenAsked)
{
    const test::TemporaryFolder folder;
    writeMap(folder / "noise.exr", {test::noiseProbe(64, 4)});
    std::stop_source stop;
    stop.request_stop();
    EXPECT_THROW(surveyProbe((folder / "noise.exr").string(), {}, {.stop = stop.get_token()}), Cancelled);
}

} // namespace
} // namespace mirrorball
