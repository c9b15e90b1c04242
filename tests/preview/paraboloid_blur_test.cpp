#include "core/preview/paraboloid_blur.h"

#include "gl_fixture.h"
#include "test_environments.h"

#include "core/base/error.h"
#include "core/filter/reference.h"
#include "support/probe_builders.h"

#include <cmath>
#include <thread>

using namespace mirrorball;
using namespace mirrorball::preview;
using namespace mirrorball::test;

using ParaboloidBlurTest = mirrorball::test::GlTest;

namespace {

struct Case {
    const char* name;
    Lobe lobe;
    ParaboloidKnobs knobs;
    double tolerance = 2e-5; // of the brightest value
};

std::vector<Case> cases()
{
    constexpr ParaboloidKernel blended = ParaboloidKernel::Blended;
    return {{"published, wide", phongLobe(10), {.kernel = blended, .half = 128}},
            {"published, narrow", phongLobe(500), {.kernel = blended, .half = 256}},
            {"published, with less border than the kernel needs", phongLobe(30), {.kernel = blended, .half = 128, .border = 8}},
            {"published, unshrunk", phongLobe(2000), {.kernel = blended, .half = 128}},
            {"exact, wide", phongLobe(10), {}},
            {"exact, narrow", phongLobe(500), {}},
            {"exact, to the horizon", diffuseLobe(), {.clamp = 1e-4, .largestKernel = 31}},
            {"exact, ggx", ggxLobe(0.05), {}},
            {"exact, tabulated", tabulatedLobe({0.0, 0.0, 0.2, 1.0, 0.7}), {}, 2e-4}}; // has kinks, which fall between samples
}

} // namespace

// Single precision against double, on the same halves; a sun in the dark makes differences visible.
TEST_F(ParaboloidBlurTest, SumsAreTheTwinsOnTheCpu)
{
    ParaboloidBlur blur;
    const EnvironmentMap probe = sunProbe(48, 1e3f, 70, 12);
    const std::vector<glm::dvec3> directions = manyDirections(3000);
    for (const Case& c : cases()) {
        const ParaboloidHalves halves = layOutHalves(probe, c.lobe, resolved(c.knobs, 48));
        const std::vector<glm::dvec3> expected = paraboloidSum(halves, directions);
        const std::vector<glm::vec3> values = blur.sum(halves, directions, {});
        double peak = 0.0;
        for (const glm::dvec3& value : expected)
            peak = std::max(peak, value.x);
        ASSERT_EQ(values.size(), expected.size());
        for (size_t i = 0; i < values.size(); ++i)
            ASSERT_LT(glm::distance(glm::dvec3(values[i]), expected[i]), c.tolerance * peak)
                << c.name << " at " << directions[i].x << ' ' << directions[i].y << ' ' << directions[i].z;
    }
}

TEST_F(ParaboloidBlurTest, AConstantEnvironmentStaysConstant)
{
    ParaboloidBlur blur;
    const EnvironmentMap furnace = constantProbe(32, 0.7f);
    const std::vector<glm::dvec3> directions = manyDirections(1000);
    std::vector<Case> all = cases();
    all.push_back({"exact, a hemisphere", phongLobe(0), {}});
    for (const Case& c : all)
        for (const glm::vec3& value : blur.sum(layOutHalves(furnace, c.lobe, resolved(c.knobs, 32)), directions, {}))
            ASSERT_NEAR(value.x, 0.7f, 1e-6f) << c.name;
}

// More directions than are drawn at a time: the last chunk is not whole.
TEST_F(ParaboloidBlurTest, ChunksAreJoinedSeamlessly)
{
    ParaboloidBlur blur;
    const ParaboloidHalves halves = layOutHalves(noiseProbe(32, 2), phongLobe(10), resolved({.largestKernel = 63}, 32));
    const std::vector<glm::dvec3> few = manyDirections(7);
    std::vector<glm::dvec3> many;
    while (many.size() < 10'001)
        many.push_back(few[many.size() % few.size()]);
    std::vector<float> fractions;
    const std::vector<glm::vec3> values = blur.sum(halves, many, {.progress = [&](float fraction) { fractions.push_back(fraction); }});
    for (size_t i = few.size(); i < values.size(); ++i)
        ASSERT_EQ(values[i], values[i - few.size()]);
    EXPECT_GT(fractions.size(), 1u);
    EXPECT_EQ(fractions.back(), 1.0f);
}

TEST_F(ParaboloidBlurTest, WorksOnAnyThreadAndLeavesTheCurrentContextAlone)
{
    const GlObject mine = makeTexture(GL_TEXTURE_2D);
    ParaboloidBlur blur;
    const ParaboloidHalves halves = layOutHalves(noiseProbe(16, 2), phongLobe(10), resolved({}, 16));
    const std::vector<glm::dvec3> directions = manyDirections(100);
    const std::vector<glm::vec3> here = blur.sum(halves, directions, {});
    EXPECT_EQ(glIsTexture(mine), GL_TRUE);
    std::vector<glm::vec3> there;
    std::thread([&] { there = blur.sum(halves, directions, {}); }).join();
    EXPECT_EQ(here, there);
}

TEST_F(ParaboloidBlurTest, StopsWhenAsked)
{
    ParaboloidBlur blur;
    std::stop_source stop;
    stop.request_stop();
    const ParaboloidHalves halves = layOutHalves(noiseProbe(16, 2), phongLobe(10), resolved({}, 16));
    EXPECT_THROW(blur.sum(halves, manyDirections(10), {.stop = stop.get_token()}), Cancelled);
}
