#include "core/image/reproject.h"

#include "core/base/error.h"
#include "support/directions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

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

EnvironmentMap coloredByDirection(const MapLayout& layout)
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
        const EnvironmentMap map = coloredByDirection(layout);
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
            const EnvironmentMap map = coloredByDirection(source);
            for (const MapLayout& target : layoutsOfSize(to)) {
                const EnvironmentMap result = reproject(map, {target, 0.0});
                const double angle = 2.0 * pi / std::min(to, 64);
                for (int y = 0; y < target.height(); ++y)
                    for (int x = 0; x < target.width(); ++x) {
                        if (!isInside(target, x, y))
                            continue;
                        const glm::dvec3 d = texelDirection(target, x, y);
                        double bound = 0.4 * angle;
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
        for (int x = 0; x < 32; ++x) // what was at the center (+Z, column 16) is now at the left quarter (+X, column 8)
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

/// The size at which a kind has about that many texels on the sphere.
MapLayout withTexels(Parameterization kind, double texels)
{
    const double perSquare = kind == Parameterization::Latlong      ? 2.0
                             : kind == Parameterization::Cube       ? 6.0
                             : kind == Parameterization::Paraboloid ? 0.5 * pi
                             : kind == Parameterization::Octahedral ? 1.0
                                                                    : 0.25 * pi;
    return {kind, static_cast<int>(std::lround(std::sqrt(texels / perSquare))), 0};
}

bool hasDisc(Parameterization kind)
{
    return kind == Parameterization::Sphere || kind == Parameterization::Angular || kind == Parameterization::Paraboloid;
}

/// At a disc's rim only texels whose centers it holds are read: the others get their values, so that both agree about the mean.
void agreeAtTheRim(EnvironmentMap& map)
{
    if (!hasDisc(map.layout.kind))
        return;
    for (int y = 0; y < map.image.height; ++y)
        for (int x = 0; x < map.image.width; ++x)
            if (isInside(map.layout, x, y)) {
                const Texel t = acrossSeam(map.layout, {x, y}, x, y);
                std::copy_n(map.image.texel(t.x, t.y), 3, map.image.texel(x, y));
            }
}

/// The definition, by brute force: the mean by solid angle of the source's texels under fine samples of the target texel.
glm::dvec3 meanUnderSamples(const EnvironmentMap& source, const MapLayout& target, int x, int y)
{
    constexpr int samples = 32;
    glm::dvec3 sum(0.0);
    double total = 0.0;
    for (int j = 0; j < samples; ++j)
        for (int i = 0; i < samples; ++i) {
            const glm::dvec2 p{x + (i + 0.5) / samples, y + (j + 0.5) / samples};
            const double w = density(target, p);
            if (w <= 0.0)
                continue;
            const glm::dvec2 c = coordinate(source.layout, direction(target, p));
            const int cx = std::min(static_cast<int>(c.x), source.image.width - 1),
                      cy = std::min(static_cast<int>(c.y), source.image.height - 1);
            const Texel t = hasDisc(source.layout.kind) ? acrossSeam(source.layout, {cx, cy}, cx, cy) : Texel{cx, cy};
            sum += w * texel(source.image, t.x, t.y);
            total += w;
        }
    return sum / total;
}

// Texels of noise, so that every one counts. Of 32 x 32 samples a few per cent of the source texels that the outline cuts are misjudged,
// which leaves 4e-3; sums through a spline of a mip level were off by 1e-2 to 9e-2 here, from any to any.
TEST(Reproject, MinifyingIsTheMeanOverTheTexelFromAnyToAny)
{
    for (const auto from : allParameterizations)
        for (const double ratio : {2.0, 4.0, 8.0}) {
            EnvironmentMap map(withTexels(from, 384.0 * ratio * ratio));
            std::mt19937 engine(7);
            std::uniform_real_distribution<float> noise(0.2f, 1.8f);
            for (float& value : map.image.texels)
                value = noise(engine);
            agreeAtTheRim(map);
            const double mean = meanRadiance(map).x;
            for (const auto to : allParameterizations) {
                const MapLayout target = withTexels(to, 384.0);
                const EnvironmentMap result = reproject(map, {target});
                const SolidAngles weights(target);
                double error = 0.0, power = 0.0;
                for (int y = 0; y < target.height(); ++y)
                    for (int x = 0; x < target.width(); ++x) {
                        if (weights.at(x, y) < 0.01 * 4.0 * pi / 384.0) // a sliver at a rim may lie between the samples
                            continue;
                        const glm::dvec3 truth = meanUnderSamples(map, target, x, y), off = texel(result.image, x, y) - truth;
                        error += weights.at(x, y) * glm::dot(off, off);
                        power += weights.at(x, y) * glm::dot(truth, truth);
                    }
                const std::string which = describe(map.layout) + " to " + describe(target);
                // At ratio 2 an octahedron of the same count has texels smaller than some of the source's: those are lookups.
                const bool lookups = ratio == 2.0;
                EXPECT_LT(std::sqrt(error / power), lookups ? 0.05 : 9e-3) << which;
                EXPECT_NEAR(meanRadiance(result).x / mean, 1.0, lookups ? 2e-3 : 1e-4) << which;
            }
        }
}

// What is left is how the source's density changes within the one texel where an outline cuts it: much at a sphere map's rim and at an
// octahedron's folds.
TEST(Reproject, OneTexelOfSunKeepsItsEnergyFromAnyToAny)
{
    for (const auto from : allParameterizations) {
        const MapLayout layout = withTexels(from, 2e5);
        EnvironmentMap map(layout);
        const glm::dvec3 suns[3] = {glm::normalize(glm::dvec3(0.3, 0.5, 0.7)), glm::normalize(glm::dvec3(1, 1, 1.01)),
                                    glm::normalize(glm::dvec3(-0.02, 0.99, -0.03))};
        for (int c = 0; c < 3; ++c) {
            const glm::dvec2 p = coordinate(layout, suns[c]);
            map.image.texel(static_cast<int>(p.x), static_cast<int>(p.y))[c] = 1e6f;
        }
        const glm::dvec3 before = meanRadiance(map);
        const bool even = from == Parameterization::Latlong || from == Parameterization::Cube || from == Parameterization::Paraboloid;
        for (const auto to : allParameterizations)
            for (const double ratio : {4.0, 7.0, 30.0}) {
                const EnvironmentMap result = reproject(map, {withTexels(to, 2e5 / (ratio * ratio))});
                const glm::dvec3 after = meanRadiance(result);
                for (int c = 0; c < 3; ++c)
                    EXPECT_NEAR(after[c] / before[c], 1.0, even ? 1e-4 : 6e-4)
                        << describe(layout) << " to " << name(to) << ", ratio " << ratio << " " << c;
                EXPECT_GE(*std::min_element(result.image.texels.begin(), result.image.texels.end()), 0.0f);
            }
    }
}

TEST(Reproject, RowsThatAreReadOnceMakeTheSameMap)
{
    // Large enough for several bands; rows are refused when asked for twice or out of order.
    for (const MapLayout& source : {MapLayout{Parameterization::Latlong, 700, 0}, {Parameterization::Cube, 450, 0}}) {
        const EnvironmentMap map = coloredByDirection(source);
        for (const MapLayout& target :
             {MapLayout{Parameterization::Cube, 40, 0}, {Parameterization::Sphere, 30, 0}, {Parameterization::Latlong, 90, 0}}) {
            int next = 0;
            const auto readRows = [&](int first, int rows, float* rgb) {
                ASSERT_EQ(first, next);
                next += rows;
                std::copy_n(map.image.row(first), static_cast<size_t>(rows) * static_cast<size_t>(map.image.width) * 3, rgb);
            };
            ASSERT_TRUE(canReprojectRows(source, {target, 0.3}));
            EXPECT_EQ(reprojectRows(source, readRows, {target, 0.3}).image, reproject(map, {target, 0.3}).image) << describe(target);
            EXPECT_EQ(next, source.height());
        }
    }
    EXPECT_FALSE(canReprojectRows({Parameterization::Latlong, 64, 0}, {{Parameterization::Cube, 64, 0}}));
    EXPECT_FALSE(canReprojectRows({Parameterization::Angular, 512, 0}, {{Parameterization::Cube, 16, 0}}));
    EXPECT_THROW(reprojectRows({Parameterization::Latlong, 64, 0}, {}, {{Parameterization::Cube, 64, 0}}), InvalidArgument);
}

TEST(Reproject, CubicLookupsFollowACurveCloserThanLinearOnesAndDoNotRing)
{
    const auto wave = [](const glm::dvec3& d) { return glm::dvec3(2.0 + std::sin(6.0 * d.x) * std::cos(5.0 * d.y)); };
    for (const MapLayout& layout : layoutsOfSize(32)) {
        const EnvironmentMap map = fill(layout, wave);
        const MapLayout target{Parameterization::Cube, 96, 0};
        const auto error = [&](Resample resample) {
            const EnvironmentMap result = reproject(map, {.target = target, .resample = resample});
            double sum = 0.0;
            for (int y = 0; y < target.height(); ++y)
                for (int x = 0; x < target.width(); ++x) {
                    const glm::dvec3 d = texelDirection(target, x, y);
                    if (d.z > -0.5) // the sphere map's rim is too coarse for either
                        sum += std::pow(wave(d).x - result.image.texel(x, y)[0], 2.0);
                }
            return sum;
        };
        EXPECT_LT(error(Resample::Cubic), 0.6 * error(Resample::Linear)) << describe(layout);
        EnvironmentMap sun(layout);
        std::fill_n(sun.image.texel(layout.size / 2, layout.size / 2), 3, 1e4f);
        for (const float value : reproject(sun, {.target = target, .resample = Resample::Cubic}).image.texels)
            ASSERT_GE(value, 0.0f);
    }
}

TEST(Reproject, CornersOfADiscContinueTheMap)
{
    const EnvironmentMap map = coloredByDirection({Parameterization::Latlong, 64, 0});
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
    const EnvironmentMap map = coloredByDirection({Parameterization::Latlong, 64, 0});
    for (const MapLayout& target : layoutsOfSize(12))
        EXPECT_EQ(reproject(map, {target, 0.1}, {.threads = 1}).image, reproject(map, {target, 0.1}, {.threads = 3}).image);
}

TEST(Reproject, RefusesALayoutOutOfRangeAndStopsWhenAsked)
{
    const EnvironmentMap map = coloredByDirection({Parameterization::Latlong, 16, 0});
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
