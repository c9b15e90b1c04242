#include "core/image/mip_pyramid.h"

#include "core/base/error.h"
#include "support/directions.h"

#include <gtest/gtest.h>

namespace mirrorball {
namespace {

using test::describe;
using test::layoutsOfSize;

EnvironmentMap constantMap(const MapLayout& layout, float value)
{
    EnvironmentMap map(layout);
    std::fill(map.image.texels.begin(), map.image.texels.end(), value);
    return map;
}

/// Dim noise with suns on it: on seams, poles, corners and at random.
EnvironmentMap noiseWithSuns(const MapLayout& layout, unsigned seed)
{
    EnvironmentMap map(layout);
    unsigned state = seed;
    for (float& t : map.image.texels)
        t = static_cast<float>((state = state * 1664525u + 1013904223u) >> 8) / static_cast<float>(1 << 24);
    for (const auto& d : test::specialDirections()) {
        const glm::dvec2 p = glm::min(coordinate(layout, d), glm::dvec2(layout.width() - 1, layout.height() - 1));
        std::fill_n(map.image.texel(static_cast<int>(p.x), static_cast<int>(p.y)), 3, 1e4f);
    }
    return map;
}

TEST(MipPyramid, HalvesDownToOneTexelAChart)
{
    const MipPyramid pyramid = buildMipPyramid(constantMap({Parameterization::Cube, 20, 0}, 1.0f));
    std::vector<int> sizes;
    for (const auto& level : pyramid.levels) {
        sizes.push_back(level.layout.size);
        EXPECT_EQ(level.image.width, level.layout.width());
        EXPECT_EQ(level.image.height, level.layout.height());
    }
    EXPECT_EQ(sizes, (std::vector<int>{20, 10, 5, 2, 1}));
}

TEST(MipPyramid, AConstantMapStaysConstant)
{
    for (const int size : {1, 2, 3, 7, 16, 25, 64})
        for (const MapLayout& layout : layoutsOfSize(size))
            for (const auto& level : buildMipPyramid(constantMap(layout, 3.0f)).levels)
                for (const float t : level.image.texels)
                    ASSERT_NEAR(t, 3.0f, 3e-6f) << describe(level.layout) << " from " << size;
}

TEST(MipPyramid, EveryLevelHasTheMeanOfTheMapEvenWithSunsOnTheSeams)
{
    for (const int size : {2, 3, 7, 16, 25, 64, 101})
        for (const MapLayout& layout : layoutsOfSize(size)) {
            const EnvironmentMap map = noiseWithSuns(layout, 7);
            const glm::dvec3 mean = meanRadiance(map);
            for (const auto& level : buildMipPyramid(map).levels)
                EXPECT_LT(glm::length(meanRadiance(level) - mean) / glm::length(mean), 1e-5) << describe(level.layout) << " from " << size;
        }
}

TEST(MipPyramid, NothingTurnsNegativeBesideASun)
{
    for (const int size : {7, 16, 33})
        for (const MapLayout& layout : layoutsOfSize(size))
            for (const auto& level : buildMipPyramid(noiseWithSuns(layout, 3)).levels)
                for (const float t : level.image.texels)
                    ASSERT_GE(t, 0.0f) << describe(level.layout);
}

TEST(MipPyramid, ASunBesideASeamShinesOnBothSides)
{
    // One bright texel on the +Z face at its edge to +X: the next level has light on +X as well, a third of what is on +Z ([1 3]).
    EnvironmentMap map = constantMap({Parameterization::Cube, 16, 0}, 0.0f);
    const glm::dvec2 p = coordinate(map.layout, {0.95, 0.05, 1.0});
    std::fill_n(map.image.texel(15, static_cast<int>(p.y)), 3, 1.0f);
    const EnvironmentMap level = buildMipPyramid(map).levels[1];
    double posX = 0.0, posZ = 0.0;
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 8; ++x) {
            posX += level.image.texel(x, y)[0];
            posZ += level.image.texel(x, 32 + y)[0];
        }
    EXPECT_NEAR(posX / posZ, 1.0 / 3.0, 0.02);
}

TEST(MipPyramid, SeamsAreNoStrongerThanWhatIsInside)
{
    // The seam test of stride3d/stride#3328: mean square difference of neighbors over a seam against that of neighbors inside, for noise
    // that knows nothing of charts. The texels of the two kinds of pairs lie equally far apart near a cube's edge.
    const MapLayout layout{Parameterization::Cube, 64, 0};
    double ratioSum = 0.0;
    constexpr int trials = 8;
    for (unsigned seed = 1; seed <= trials; ++seed) {
        EnvironmentMap map(layout);
        unsigned state = seed * 77u;
        for (float& t : map.image.texels)
            t = static_cast<float>((state = state * 1664525u + 1013904223u) >> 8) / static_cast<float>(1 << 24);
        const MipPyramid pyramid = buildMipPyramid(map);
        for (size_t i = 1; i <= 3; ++i) {
            const EnvironmentMap& level = pyramid.levels[i];
            const int n = level.layout.size;
            double seam = 0.0, inside = 0.0;
            int seams = 0, insides = 0;
            for (int y = 0; y < 6 * n; ++y)
                for (int x = 0; x < n; ++x)
                    for (const Texel& to : {Texel{x + 1, y}, Texel{x, y + 1}, Texel{x - 1, y}, Texel{x, y - 1}}) {
                        const Texel t = acrossSeam(level.layout, {x, y}, to.x, to.y);
                        const double d = level.image.texel(x, y)[0] - level.image.texel(t.x, t.y)[0];
                        const bool over = t.y / n != y / n;
                        (over ? seam : inside) += d * d;
                        ++(over ? seams : insides);
                    }
            ratioSum += std::sqrt(seam / seams / (inside / insides));
        }
    }
    EXPECT_NEAR(ratioSum / (3 * trials), 1.0, 0.06);
}

TEST(MipPyramid, TrilinearLookupMeetsTheLevelsAndIsClamped)
{
    const MipPyramid pyramid = buildMipPyramid(noiseWithSuns({Parameterization::Latlong, 32, 0}, 5));
    for (const auto& d : test::randomDirections(50)) {
        EXPECT_EQ(radiance(pyramid, d, 2.0), pyramid.levels[2].radiance(d));
        EXPECT_EQ(radiance(pyramid, d, -3.0), pyramid.levels[0].radiance(d));
        EXPECT_EQ(radiance(pyramid, d, 1e9), pyramid.levels.back().radiance(d));
        const glm::vec3 between = radiance(pyramid, d, 1.25);
        const glm::vec3 expected = 0.75f * pyramid.levels[1].radiance(d) + 0.25f * pyramid.levels[2].radiance(d);
        EXPECT_LT(glm::distance(between, expected), 1e-5f * (1.0f + glm::length(expected)));
    }
}

/// 002 section 3: hardware of 2002 filters "mipmaps separately for each of the cube faces which produces noticeable seams".
TEST(FacePyramid, KeepsEachFaceToItselfAndSoShowsTheSeams)
{
    const MapLayout layout{Parameterization::Cube, 64, 0};
    EnvironmentMap cube(layout);
    for (int y = 0; y < cube.image.height; ++y) // face by face another constant
        std::fill_n(cube.image.row(y), 3 * 64, static_cast<float>(y / 64));
    const MipPyramid faces = buildFacePyramid(cube);
    ASSERT_EQ(faces.levels.size(), buildMipPyramid(cube).levels.size());
    for (const auto& level : faces.levels)
        for (int y = 0; y < level.image.height; ++y)
            ASSERT_EQ(level.image.texel(0, y)[0], static_cast<float>(y / level.layout.size)) << "nothing crosses an edge";

    // A sun beside the edge between +X and +Z: across seams it shines over the edge on every level, by face on none.
    EnvironmentMap sun = constantMap(layout, 0.0f);
    std::fill_n(sun.image.texel(0, 32), 3, 1000.0f);
    const Texel over = acrossSeam(layout, {0, 32}, -1, 32);
    ASSERT_NE(over.y / 64, 0);
    const MipPyramid byFace = buildFacePyramid(sun), across = buildMipPyramid(sun);
    for (size_t level = 1; level < 6; ++level) {
        const int size = byFace.levels[level].layout.size;
        const int x = over.x >> level, y = over.y / 64 * size + (over.y % 64 >> level);
        EXPECT_EQ(byFace.levels[level].image.texel(x, y)[0], 0.0f);
        EXPECT_GT(across.levels[level].image.texel(x, y)[0], 0.0f);
    }
}

TEST(FacePyramid, KeepsAConstantAndTakesOnlyCubes)
{
    for (const int size : {1, 5, 16})
        for (const auto& level : buildFacePyramid(constantMap({Parameterization::Cube, size, 0}, 3.0f)).levels)
            for (const float t : level.image.texels)
                ASSERT_EQ(t, 3.0f);
    EXPECT_THROW(buildFacePyramid(constantMap({Parameterization::Latlong, 8, 0}, 1.0f)), InvalidArgument);
}

TEST(MipPyramid, StopsWhenAsked)
{
    std::stop_source source;
    source.request_stop();
    EXPECT_THROW(buildMipPyramid(constantMap({Parameterization::Latlong, 64, 0}, 1.0f), {.stop = source.get_token()}), Cancelled);
}

} // namespace
} // namespace mirrorball
