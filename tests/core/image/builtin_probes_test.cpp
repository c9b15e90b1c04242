#include "core/image/builtin_probes.h"

#include "core/base/error.h"
#include "core/image/color.h"
#include "core/image/daylight.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

using namespace mirrorball;
using glm::dvec3;

namespace {

constexpr std::array axisDirections{dvec3(1, 0, 0), dvec3(-1, 0, 0), dvec3(0, 1, 0), dvec3(0, -1, 0), dvec3(0, 0, 1), dvec3(0, 0, -1)};

double brightness(std::string_view probe, const dvec3& d) { return luminance(builtinProbe(probe).radiance(glm::normalize(d))); }

dvec3 texelAt(const EnvironmentMap& map, int x, int y)
{
    const float* t = map.image.texel(x, y);
    return {t[0], t[1], t[2]};
}

/// The sum of radiance times solid angle over the texels whose centers lie within `angle` of `center`.
dvec3 energyAround(const EnvironmentMap& map, const dvec3& center, double angle)
{
    dvec3 sum(0.0);
    for (int y = 0; y < map.image.height; ++y)
        for (int x = 0; x < map.image.width; ++x)
            if (const double w = texelSolidAngle(map.layout, x, y); w > 0.0)
                if (angle >= pi || glm::dot(texelDirection(map.layout, x, y), center) > std::cos(angle))
                    sum += w * texelAt(map, x, y);
    return sum;
}

/// What an observer at the center sees when he looks along `forward` with `up` above: right and up in [-1, 1] to a direction.
struct View {
    dvec3 forward, up;
    dvec3 at(double right, double above) const { return forward + right * glm::cross(forward, up) + above * up; }
};

constexpr std::array views{View{{1, 0, 0}, {0, 1, 0}},  View{{-1, 0, 0}, {0, 1, 0}}, View{{0, 1, 0}, {0, 0, -1}},
                           View{{0, -1, 0}, {0, 0, 1}}, View{{0, 0, 1}, {0, 1, 0}},  View{{0, 0, -1}, {0, 1, 0}}};

/// Whether `axes` shows white there: on a stroke.
bool isStroke(const View& view, double right, double above)
{
    const dvec3 c = builtinProbe("axes").radiance(glm::normalize(view.at(right, above)));
    return std::min({c.r, c.g, c.b}) > 0.9;
}

} // namespace

TEST(BuiltinProbes, AreFourWithASentenceEach)
{
    ASSERT_EQ(builtinProbes().size(), 4u);
    EXPECT_EQ(builtinProbes()[0].name, "studio");
    EXPECT_EQ(builtinProbes()[3].name, "axes");
    for (const BuiltinProbe& probe : builtinProbes()) {
        EXPECT_EQ(probe.description.back(), '.');
        EXPECT_EQ(&builtinProbe(probe.name), &probe);
    }
}

TEST(BuiltinProbes, AnUnknownNameIsAnsweredWithTheKnownOnes)
{
    try {
        renderBuiltinProbe("moon", {Parameterization::Latlong, 8, 0});
        FAIL() << "no exception";
    } catch (const InvalidArgument& error) {
        EXPECT_NE(std::string(error.what()).find("'moon'"), std::string::npos);
        EXPECT_NE(std::string(error.what()).find("studio, sky, cube-room, axes"), std::string::npos);
    }
}

TEST(BuiltinProbes, AreFiniteAndNotNegativeInEveryDirection)
{
    for (const BuiltinProbe& probe : builtinProbes()) {
        for (int i = 0; i <= 180; ++i)
            for (int j = 0; j < 360; j += 3) {
                const dvec3 c = probe.radiance(directionFromLonLat(j * pi / 180, pi / 2 - i * pi / 180));
                ASSERT_TRUE(std::isfinite(c.r + c.g + c.b) && std::min({c.r, c.g, c.b}) >= 0.0) << probe.name << " " << i << " " << j;
            }
        for (const dvec3& a : axisDirections) {
            const dvec3 c = probe.radiance(a);
            EXPECT_TRUE(std::isfinite(c.r + c.g + c.b) && std::min({c.r, c.g, c.b}) >= 0.0) << probe.name;
        }
    }
}

TEST(BuiltinProbes, MapsAreFiniteInEveryParameterizationAndSize)
{
    for (const BuiltinProbe& probe : builtinProbes())
        for (const Parameterization kind : allParameterizations)
            for (const int size : {1, 7, 64}) {
                const EnvironmentMap map = renderBuiltinProbe(probe.name, {kind, size, 0});
                for (const float t : map.image.texels)
                    ASSERT_TRUE(std::isfinite(t) && t >= 0.0f) << probe.name << " " << name(kind) << " " << size;
            }
}

TEST(BuiltinProbes, DoNotDependOnTheNumberOfThreads)
{
    JobControl one, three;
    one.threads = 1;
    three.threads = 3;
    for (const BuiltinProbe& probe : builtinProbes())
        EXPECT_EQ(renderBuiltinProbe(probe.name, {Parameterization::Latlong, 200, 0}, one).image,
                  renderBuiltinProbe(probe.name, {Parameterization::Latlong, 200, 0}, three).image)
            << probe.name;
}

TEST(BuiltinProbes, ReportProgressUpToTheEndAndStop)
{
    float last = 0.0f;
    bool rises = true;
    JobControl job;
    job.progress = [&](float f) {
        rises = rises && f >= last;
        last = f;
    };
    renderBuiltinProbe("axes", {Parameterization::Latlong, 512, 0}, job);
    EXPECT_TRUE(rises);
    EXPECT_FLOAT_EQ(last, 1.0f);

    std::stop_source source;
    source.request_stop();
    JobControl stopped;
    stopped.stop = source.get_token();
    EXPECT_THROW(renderBuiltinProbe("studio", builtinProbeLayout, stopped), Cancelled);
}

// Every probe's mean over the sphere, by a fine quadrature of its function, is what its maps of any kind hold.
TEST(BuiltinProbes, MapsKeepTheMeanRadiance)
{
    for (const BuiltinProbe& probe : builtinProbes()) {
        if (probe.name == "sky")
            continue; // its sun needs the test below
        dvec3 mean(0.0);
        constexpr int rows = 1500, columns = 3001; // odd, so that no column of samples runs along a cube edge
        for (int i = 0; i < rows; ++i)
            for (int j = 0; j < columns; ++j)
                mean += probe.radiance(directionFromLonLat(2 * pi * (j + 0.5) / columns, std::asin(2 * (i + 0.5) / rows - 1)));
        mean /= rows * columns;
        // The thin lines of a cube's faces line up with the samples of a small cube map, which is worth up to 0.4 percent.
        for (const Parameterization kind : allParameterizations)
            for (const int size : {32, 256}) {
                const dvec3 found = energyAround(renderBuiltinProbe(probe.name, {kind, size, 0}), {0, 0, 1}, pi) / (4 * pi);
                for (int c = 0; c < 3; ++c)
                    EXPECT_NEAR(found[c] / mean[c], 1.0, 5e-3) << probe.name << " " << name(kind) << " " << size;
            }
    }
}

TEST(Studio, HasAKeyLightSomeHundredTimesTheRoom)
{
    const double key = brightness("studio", directionFromLonLat(-46 * pi / 180, 38 * pi / 180));
    const double room = brightness("studio", directionFromLonLat(0, 0));
    EXPECT_GT(key, 200);
    EXPECT_LT(key, 1000);
    EXPECT_GT(room, 0.05);
    EXPECT_LT(room, 0.5);
}

TEST(Studio, HasItsKeyLightAtTheCamerasLeft)
{
    // The camera is at +Z and looks along -Z, so its left is -X.
    EXPECT_GT(brightness("studio", {-0.57, 0.62, 0.55}), 5.0);
    EXPECT_LT(brightness("studio", {0.57, 0.62, 0.55}), 1.0);
}

TEST(Sky, HasItsSunWhereItIsSaidToBe)
{
    const dvec3 sun = skySunDirection();
    EXPECT_NEAR(std::asin(sun.y) * 180 / pi, 35, 1e-9);
    EXPECT_GT(sun.x, 0.0); // left of +Z for an observer who looks along +Z
    EXPECT_GT(sun.z, 0.0);
    for (const int size : {64, 512}) {
        const EnvironmentMap map = renderBuiltinProbe("sky", {Parameterization::Latlong, size, 0});
        Texel best;
        for (int y = 0; y < map.image.height; ++y)
            for (int x = 0; x < map.image.width; ++x)
                if (map.image.texel(x, y)[1] > map.image.texel(best.x, best.y)[1])
                    best = {x, y};
        EXPECT_GT(glm::dot(texelDirection(map.layout, best.x, best.y), sun), std::cos(pi / size));
        EXPECT_LT(best.x, size);
    }
}

TEST(Sky, HasTheSunsPublishedBrightnessRelativeToTheZenith)
{
    const double zenith = brightness("sky", {0, 1, 0});
    EXPECT_NEAR(zenith, 0.481, 0.005); // 4.81 kcd/m^2: appendix A.2 of Preetham 1999 for T = 2.5, theta_s = 55 degrees
    const double sun = luminance(skySunRadiance());
    EXPECT_GT(sun, 1.0e5);
    EXPECT_LT(sun, 1.4e5);
    // 82 klx on a plane that faces it; one unit is 10 kcd/m^2
    EXPECT_NEAR(sun * 10.0 * 2 * pi * (1 - std::cos(skySunRadius)), 82.0, 1.0);
    // inside the disc and just outside
    const dvec3 aside = glm::normalize(glm::cross(skySunDirection(), dvec3(0, 1, 0)));
    const auto off = [&](double factor) { return skySunDirection() + std::tan(factor * skySunRadius) * aside; };
    EXPECT_GT(brightness("sky", off(0.99)), 1.0e5);
    EXPECT_LT(brightness("sky", off(1.01)), 20.0);
}

TEST(Sky, IsBlueAwayFromTheSunAndMeetsTheGroundSoftly)
{
    const dvec3 away = builtinProbe("sky").radiance(glm::normalize(dvec3(-0.5, 0.6, -0.6)));
    EXPECT_GT(away.b, 1.5 * away.r);
    for (double lon = 0; lon < 2 * pi; lon += 0.1) {
        const double above = brightness("sky", directionFromLonLat(lon, 1e-4)), below = brightness("sky", directionFromLonLat(lon, -1e-4));
        EXPECT_NEAR(below / above, 1.0, 0.01);
        EXPECT_NEAR(brightness("sky", directionFromLonLat(lon, -1.0)), brightness("sky", {0, -1, 0}), 1e-9);
    }
}

// The sun is smaller than a texel of most maps; its energy must not depend on where it falls between them.
TEST(Sky, KeepsTheSunsEnergyAtEverySizeAndInEveryParameterization)
{
    const dvec3 sun = skySunRadiance() * 2.0 * pi * (1.0 - std::cos(skySunRadius));
    dvec3 rest(0.0); // the sky's and the ground's own radiance: midpoints that step over the disc
    constexpr int rows = 1000, columns = 1000;
    for (int i = 0; i < rows; ++i)
        for (int j = 0; j < columns; ++j) {
            const dvec3 d = directionFromLonLat(2 * pi * (j + 0.5) / columns, std::asin(2 * (i + 0.5) / rows - 1));
            const dvec3 c = builtinProbe("sky").radiance(d);
            rest += c.g > 1e4 ? c - skySunRadiance() : c;
        }
    const dvec3 total = sun + rest * (4 * pi / (rows * columns));
    for (const Parameterization kind : allParameterizations)
        for (const int size : {64, 100, 256, 1024}) {
            if (size == 1024 && kind != Parameterization::Latlong && kind != Parameterization::Octahedral)
                continue; // a matter of time only
            const dvec3 found = energyAround(renderBuiltinProbe("sky", {kind, size, 0}), {0, 0, 1}, pi);
            for (int c = 0; c < 3; ++c)
                EXPECT_NEAR(found[c] / total[c], 1.0, 1e-3) << name(kind) << " " << size;
        }
}

TEST(Sky, KeepsTheSunsDiscAtItsOwnRadianceInALargeMap)
{
    const EnvironmentMap map = renderBuiltinProbe("sky", {Parameterization::Octahedral, 1536, 0});
    const glm::dvec2 p = coordinate(map.layout, skySunDirection());
    const dvec3 center = texelAt(map, static_cast<int>(p.x), static_cast<int>(p.y));
    EXPECT_NEAR(center.g / skySunRadiance().g, 1.0, 0.02);
}

TEST(CubeRoom, HasSixWallsOfRisingLuminance)
{
    // Two squares of the checker together, beside the center of each wall.
    const auto wall = [](const View& v) {
        return 0.5 * luminance(builtinProbe("cube-room").radiance(glm::normalize(v.at(0.1, 0.1)))) +
               0.5 * luminance(builtinProbe("cube-room").radiance(glm::normalize(v.at(-0.1, 0.1))));
    };
    double previous = 0.03;
    for (const size_t face : {3u, 5u, 0u, 1u, 4u, 2u}) { // -Y -Z +X -X +Z +Y
        EXPECT_GT(wall(views[face]), 1.6 * previous);
        previous = wall(views[face]);
    }
}

TEST(CubeRoom, HasDarkEdges)
{
    for (const dvec3 edge : {dvec3(1, 1, 0.3), dvec3(-1, 0.2, 1), dvec3(0, -1, -1), dvec3(1, 1, 1)})
        EXPECT_LT(brightness("cube-room", edge), 0.02);
}

TEST(Axes, HasSixColors)
{
    std::vector<dvec3> colors;
    for (const View& v : views)
        colors.push_back(builtinProbe("axes").radiance(glm::normalize(v.at(-0.7, 0.7))));
    for (size_t i = 0; i < 6; ++i)
        for (size_t j = 0; j < i; ++j)
            EXPECT_GT(glm::distance(colors[i], colors[j]), 0.3) << i << " " << j;
    EXPECT_GT(colors[0].r, 4 * colors[0].g); // +X red, +Y green, +Z blue
    EXPECT_GT(colors[2].g, 3 * colors[2].r);
    EXPECT_GT(colors[4].b, 4 * colors[4].r);
}

// The sign stands left of the letter; the letter's place at the right holds no horizontal bar at mid-height for X and Y.
TEST(Axes, NamesReadFromLeftToRightForAnObserverInside)
{
    for (size_t face = 0; face < 6; ++face) {
        const View& v = views[face];
        EXPECT_TRUE(isStroke(v, -0.50, 0.0)) << face; // the bar of the sign
        EXPECT_TRUE(isStroke(v, -0.30, 0.0)) << face;
        EXPECT_FALSE(isStroke(v, 0.52, 0.0)) << face; // mirrored, it would be here
        const bool isPlus = face % 2 == 0;
        EXPECT_EQ(isStroke(v, -0.385, 0.15), isPlus) << face;
        EXPECT_EQ(isStroke(v, -0.385, -0.15), isPlus) << face;
        EXPECT_TRUE(isStroke(v, 0.03, 0.36)) << face; // the upper left end of X, Y and Z
        EXPECT_TRUE(isStroke(v, 0.52, 0.36)) << face;
    }
}

TEST(Axes, LettersAreNeitherMirroredNorUpsideDown)
{
    for (const size_t face : {2u, 3u}) { // Y has its stem below
        EXPECT_TRUE(isStroke(views[face], 0.274, -0.30));
        EXPECT_FALSE(isStroke(views[face], 0.274, 0.30));
    }
    for (const size_t face : {4u, 5u}) { // the diagonal of Z rises to the right
        EXPECT_TRUE(isStroke(views[face], 0.274 + 0.12, 0.17));
        EXPECT_FALSE(isStroke(views[face], 0.274 - 0.12, 0.17));
        EXPECT_TRUE(isStroke(views[face], 0.274, 0.37));
        EXPECT_TRUE(isStroke(views[face], 0.274, -0.37));
    }
}

TEST(Axes, MarksTheUpperRightCornerAndTheWayUp)
{
    for (const View& v : views) {
        EXPECT_TRUE(isStroke(v, 0.93, 0.93));
        EXPECT_FALSE(isStroke(v, -0.93, 0.93));
        EXPECT_FALSE(isStroke(v, 0.93, -0.93));
        EXPECT_FALSE(isStroke(v, -0.93, -0.93));
        EXPECT_TRUE(isStroke(v, 0.0, 0.60));
        EXPECT_TRUE(isStroke(v, 0.05, 0.635)); // the head is at the upper end of the arrow
        EXPECT_FALSE(isStroke(v, 0.05, 0.565));
        EXPECT_FALSE(isStroke(v, 0.0, -0.60));
    }
}

TEST(Axes, NamesItsNeighborsInsideTheEdges)
{
    // On +Z the right edge adjoins -X and the left one +X: the vertical bar of the plus tells them apart.
    const View& plusZ = views[4];
    EXPECT_TRUE(isStroke(plusZ, -0.84 - 0.0728, 0.025));
    EXPECT_FALSE(isStroke(plusZ, 0.84 - 0.0728, 0.025));
    EXPECT_TRUE(isStroke(plusZ, 0.84 - 0.0728, 0.0));
    EXPECT_TRUE(isStroke(plusZ, -0.0728, 0.87 + 0.025));   // +Y above
    EXPECT_FALSE(isStroke(plusZ, -0.0728, -0.87 + 0.025)); // -Y below
    EXPECT_TRUE(isStroke(plusZ, -0.0728, -0.87));
}

// The picture of a latlong map shows the environment from inside: +X is in the left half and its sign left of its letter.
TEST(Axes, ReadsCorrectlyInALatlongPicture)
{
    const EnvironmentMap map = renderBuiltinProbe("axes");
    const auto white = [&](int x, int y) {
        const dvec3 c = texelAt(map, x, y);
        return std::min({c.r, c.g, c.b}) > 0.85;
    };
    EXPECT_EQ(map.image.width, 1024);
    const auto columnAt = [](int center, double right) { return center + static_cast<int>(std::lround(std::atan(right) / pi * 512)); };
    for (const int center : {256, 512, 768}) { // +X, +Z, -X
        EXPECT_TRUE(white(columnAt(center, -0.50), 256));
        EXPECT_FALSE(white(columnAt(center, 0.52), 256));
        EXPECT_EQ(white(columnAt(center, -0.385), 256 - 22), center != 768); // the plus
    }
}
