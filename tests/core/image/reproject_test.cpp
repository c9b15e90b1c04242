#include "core/image/reproject.h"

#include "core/base/error.h"
#include "support/directions.h"

#include <gtest/gtest.h>

namespace mirrorball {
namespace {

using test::describe;
using test::layoutsOfSize;

template <class Radiance>
EnvironmentMap fill(const MapLayout& layout, const Radiance& radiance)
{
    EnvironmentMap map(layout);
    for (int y = 0; y < map.image.height; ++y)
        for (int x = 0; x < map.image.width; ++x) {
            const glm::dvec3 value = radiance(texelDirection(layout, x, y));
            for (int c = 0; c < 3; ++c)
                map.image.texel(x, y)[c] = static_cast<float>(value[c]);
        }
    return map;
}

EnvironmentMap colouredByDirection(const MapLayout& layout)
{
    return fill(layout, [](const glm::dvec3& d) { return 0.5 * d + 0.5; });
}

glm::dvec3 texel(const Image& image, int x, int y)
{
    const float* t = image.texel(x, y);
    return {t[0], t[1], t[2]};
}

TEST(Reproject, TheSameLayoutWithoutYawIsTheSameMap)
{
    for (const MapLayout& layout : layoutsOfSize(8)) {
        const EnvironmentMap map = colouredByDirection(layout);
        EXPECT_EQ(reproject(map, {layout, 0.0}).image, map.image) << describe(layout);
    }
}

TEST(Reproject, AConstantMapStaysConstantFromAnyToAny)
{
    for (const int from : {1, 2, 5, 48})
        for (const int to : {1, 3, 16})
            for (const MapLayout& source : layoutsOfSize(from)) {
                const EnvironmentMap map = fill(source, [](const glm::dvec3&) { return glm::dvec3(2.0); });
                for (const MapLayout& target : layoutsOfSize(to))
                    for (const float t : reproject(map, {target, 0.4}).image.texels)
                        ASSERT_NEAR(t, 2.0f, 4e-6f) << describe(source) << " to " << describe(target);
            }
}

TEST(Reproject, EveryTexelShowsWhatLiesInItsDirectionFromAnyToAny)
{
    // Radiance linear in d, smaller and larger targets. The worst is the rim of the sphere map, whose texels are drawn out to
    // theta = 2 sqrt(2 * 2/N) either side of -Z; everywhere else a texel or two of the coarser map, squared or as a kink at a fold.
    for (const int to : {24, 64, 150})
        for (const MapLayout& source : layoutsOfSize(64)) {
            const EnvironmentMap map = colouredByDirection(source);
            for (const MapLayout& target : layoutsOfSize(to)) {
                const EnvironmentMap result = reproject(map, {target, 0.0});
                const double angle = 2.0 * pi / std::min(to, 64);
                for (int y = 0; y < target.height(); ++y)
                    for (int x = 0; x < target.width(); ++x) {
                        if (!isInside(target, x, y))
                            continue;
                        const glm::dvec3 d = texelDirection(target, x, y);
                        double bound = 0.35 * angle;
                        if (d.z < -0.8 && (source.kind == Parameterization::Sphere || target.kind == Parameterization::Sphere))
                            bound = 2.0 * std::sqrt(2.0 / std::min(to, 64));
                        const glm::dvec3 error = glm::abs(0.5 * d + 0.5 - texel(result.image, x, y));
                        ASSERT_LT(std::max({error.x, error.y, error.z}), bound)
                            << describe(source) << " to " << describe(target) << " at " << x << " " << y;
                    }
            }
        }
}

TEST(Reproject, YawTurnsTheEnvironmentFromPlusZTowardsPlusX)
{
    const EnvironmentMap map = fill({Parameterization::Latlong, 32, 0}, [](const glm::dvec3& d) { return glm::dvec3(std::max(0.0, d.z)); });
    for (const MapLayout& target : layoutsOfSize(33)) {
        const EnvironmentMap turned = reproject(map, {target, pi / 2});
        EXPECT_GT(turned.radiance({1, 0, 0}).x, 0.95f) << describe(target);
        EXPECT_LT(turned.radiance({0, 0, 1}).x, 0.1f) << describe(target);
    }
}

TEST(Reproject, AQuarterTurnOfALatlongMovesItsColumnsUnchanged)
{
    const MapLayout layout{Parameterization::Latlong, 16, 0};
    EnvironmentMap map(layout);
    for (size_t i = 0; i < map.image.texels.size(); ++i)
        map.image.texels[i] = static_cast<float>(i % 97);
    const EnvironmentMap turned = reproject(map, {layout, pi / 2});
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 32; ++x) // what was at the centre (+Z, column 16) is now at the left quarter (+X, column 8)
            EXPECT_LT(glm::distance(texel(turned.image, x, y), texel(map.image, (x + 8) % 32, y)), 1e-4);
}

TEST(Reproject, ASingleTexelSunOfA4kLatlongKeepsItsEnergyInASmallCube)
{
    // Three suns at a time, one per channel: at a pole, beside it, on the seam, on a cube corner and edge, anywhere.
    const MapLayout layout{Parameterization::Latlong, 2048, 0};
    const Texel suns[2][3] = {{{1234, 0}, {4095, 1000}, {700, 2}}, {{512, 1447}, {1536, 1024}, {3000, 411}}};
    for (const auto& group : suns) {
        EnvironmentMap map(layout);
        for (int c = 0; c < 3; ++c)
            map.image.texel(group[c].x, group[c].y)[c] = 1e6f;
        const glm::dvec3 before = meanRadiance(map);
        const glm::dvec3 after = meanRadiance(reproject(map, {{Parameterization::Cube, 64, 0}, 0.0}));
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(after[c] / before[c], 1.0, 1e-3) << "sun at " << group[c].x << " " << group[c].y;
    }
}

TEST(Reproject, SunsKeepTheirEnergyInEveryKindOfSmallerMap)
{
    // Many suns over the sphere: what one loses at a rim another does not gain. Point sampling would be off by half.
    EnvironmentMap map({Parameterization::Latlong, 256, 0});
    for (const auto& d : test::randomDirections(40, 11)) {
        const glm::dvec2 p = coordinate(map.layout, d);
        std::fill_n(map.image.texel(static_cast<int>(p.x), static_cast<int>(p.y)), 3, 1e5f);
    }
    const double before = meanRadiance(map).x;
    for (const int size : {8, 20, 33})
        for (const MapLayout& target : layoutsOfSize(size)) {
            // A paraboloid's border continues the other half past the rim, so its clipped texels stand for a little more than their part.
            const double tolerance = target.border > 0 ? 2e-2 : 4e-3;
            EXPECT_NEAR(meanRadiance(reproject(map, {target, 0.0})).x / before, 1.0, tolerance) << describe(target);
        }
}

TEST(Reproject, CornersOfADiscContinueTheMap)
{
    const EnvironmentMap map = colouredByDirection({Parameterization::Latlong, 64, 0});
    for (const auto kind : {Parameterization::Sphere, Parameterization::Angular, Parameterization::Paraboloid}) {
        const MapLayout target{kind, 32, 0};
        const EnvironmentMap result = reproject(map, {target, 0.0});
        for (const Texel& t : {Texel{0, 0}, Texel{31, 0}, Texel{0, 31}, Texel{31, 31}}) {
            ASSERT_FALSE(isInside(target, t.x, t.y));
            EXPECT_LT(glm::distance(texel(result.image, t.x, t.y), 0.5 * texelDirection(target, t.x, t.y) + 0.5), 0.1) << describe(target);
        }
    }
}

TEST(Reproject, ResultsDoNotDependOnTheNumberOfThreads)
{
    const EnvironmentMap map = colouredByDirection({Parameterization::Latlong, 64, 0});
    for (const MapLayout& target : layoutsOfSize(12))
        EXPECT_EQ(reproject(map, {target, 0.1}, {.threads = 1}).image, reproject(map, {target, 0.1}, {.threads = 3}).image);
}

TEST(Reproject, RefusesALayoutOutOfRangeAndStopsWhenAsked)
{
    const EnvironmentMap map = colouredByDirection({Parameterization::Latlong, 16, 0});
    EXPECT_THROW(reproject(map, {{Parameterization::Cube, 0, 0}, 0.0}), InvalidArgument);
    std::stop_source source;
    source.request_stop();
    EXPECT_THROW(reproject(map, {{Parameterization::Cube, 16, 0}, 0.0}, {.stop = source.get_token()}), Cancelled);
}

TEST(EdgeSampledLatlong, ReadsEveryDirectionWhereOpenExrPutsIt)
{
    // ImfEnvmap.cpp: latitude = -pi (y/(H-1) - 1/2), longitude = -2 pi (x/(W-1) - 1/2).
    constexpr int width = 129, height = 65;
    Image image(width, height, 3);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const glm::dvec3 d = directionFromLonLat(-2.0 * pi * (x / (width - 1.0) - 0.5), -pi * (y / (height - 1.0) - 0.5));
            for (int c = 0; c < 3; ++c)
                image.texel(x, y)[c] = static_cast<float>(0.5 * d[c] + 0.5);
        }
    const EnvironmentMap map = fromEdgeSampledLatlong(image);
    EXPECT_EQ(map.layout, (MapLayout{Parameterization::Latlong, height, 0}));
    for (const auto& d : test::randomDirections(1000))
        EXPECT_LT(glm::distance(glm::dvec3(map.radiance(d)), 0.5 * d + 0.5), 2e-3);
    EXPECT_THROW(fromEdgeSampledLatlong(Image(1, 1, 3)), InvalidArgument);
}

TEST(OpenExrCube, ReadsEveryDirectionWhereOpenExrPutsIt)
{
    // ImfEnvmap.cpp, faceAndPixelPosition() and pixelPosition(), for the texels themselves.
    constexpr int n = 33;
    const auto openExrDirection = [](int face, int column, int row) {
        const auto pos = [](int i) { return 2.0 * i / (n - 1) - 1.0; };
        switch (face) {
        case 0:
            return glm::dvec3(1.0, -pos(row), pos(column));
        case 1:
            return glm::dvec3(-1.0, -pos(row), -pos(column));
        case 2:
            return glm::dvec3(pos(column), 1.0, -pos(row));
        case 3:
            return glm::dvec3(pos(column), -1.0, pos(row));
        case 4:
            return glm::dvec3(-pos(column), -pos(row), 1.0);
        default:
            return glm::dvec3(pos(column), -pos(row), -1.0);
        }
    };
    Image image(n, 6 * n, 3);
    for (int y = 0; y < 6 * n; ++y)
        for (int x = 0; x < n; ++x) {
            const glm::dvec3 d = glm::normalize(openExrDirection(y / n, x, y % n));
            for (int c = 0; c < 3; ++c)
                image.texel(x, y)[c] = static_cast<float>(0.5 * d[c] + 0.5);
        }
    const EnvironmentMap map = fromOpenExrCube(image);
    for (int y = 0; y < 6 * n; ++y)
        for (int x = 0; x < n; ++x)
            EXPECT_LT(glm::distance(texel(map.image, x, y), 0.5 * texelDirection(map.layout, x, y) + 0.5), 2e-3);
    EXPECT_THROW(fromOpenExrCube(Image(4, 12, 3)), InvalidArgument);
}

} // namespace
} // namespace mirrorball
