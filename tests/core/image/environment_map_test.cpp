#include "core/image/environment_map.h"

#include "support/directions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

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

double worst(const glm::vec3& a, const glm::dvec3& b)
{
    const glm::dvec3 d = glm::abs(glm::dvec3(a) - b);
    return std::max({d.x, d.y, d.z});
}

TEST(EnvironmentMap, AConstantMapIsConstantInEveryDirection)
{
    for (const int size : {1, 2, 3, 16, 17})
        for (const MapLayout& layout : layoutsOfSize(size)) {
            const EnvironmentMap map = fill(layout, [](const glm::dvec3&) { return glm::dvec3(1.0, 2.0, 3.0); });
            auto directions = test::randomDirections(500);
            for (const auto& d : test::specialDirections())
                directions.push_back(d);
            for (const auto& d : directions)
                EXPECT_LT(worst(map.radiance(d), {1, 2, 3}), 1e-6) << describe(layout);
        }
}

TEST(EnvironmentMap, NothingBeyondADiscsRimLeaksIn)
{
    // A foreign file: black or broken beyond the disc.
    for (const int size : {1, 2, 3, 16, 17, 64})
        for (const auto kind : {Parameterization::Sphere, Parameterization::Angular, Parameterization::Paraboloid}) {
            const MapLayout layout{kind, size, 0};
            EnvironmentMap map = fill(layout, [](const glm::dvec3&) { return glm::dvec3(1.0); });
            for (int y = 0; y < map.image.height; ++y)
                for (int x = 0; x < map.image.width; ++x)
                    if (acrossSeam(layout, {x, y}, x, y) != Texel{x, y})
                        std::fill_n(map.image.texel(x, y), 3, std::numeric_limits<float>::quiet_NaN());
            for (const auto& d : test::randomDirections(5000))
                EXPECT_LT(worst(map.radiance(d), glm::dvec3(1.0)), 1e-6) << describe(layout);
            EXPECT_LT(worst(map.radiance({0, 0, -1}), glm::dvec3(1.0)), 1e-6) << describe(layout);
        }
}

TEST(EnvironmentMap, ASmoothMapIsReadBackEverywhere)
{
    // Radiance linear in d: bilinear interpolation is off by the curvature of the mapping, a fraction of the texel's angle squared.
    // The sphere map's radial stretch at the rim, theta = pi - 2 sqrt(2 (1 - rho)), costs the root of the texel instead.
    for (const int size : {32, 33, 128})
        for (const MapLayout& layout : layoutsOfSize(size)) {
            const EnvironmentMap map = fill(layout, [](const glm::dvec3& d) { return 0.5 * d + 0.5; });
            const double texel = 2.0 * pi / size;
            auto directions = test::randomDirections(20000);
            for (const auto& d : test::specialDirections())
                directions.push_back(d);
            for (const auto& d : directions) {
                double bound = 0.5 * texel * texel;
                if (layout.kind == Parameterization::Sphere)
                    bound = std::min(3.0 * std::sqrt(1.0 / size), 4.0 / (size * size) / std::pow(0.5 * (1.0 + d.z) + 1e-9, 1.5) + bound);
                if (layout.kind == Parameterization::Paraboloid && layout.border == 0)
                    bound += 0.3 * texel * std::max(0.0, 1.0 - std::abs(d.z) / (2.0 * texel)); // taps dropped at the rim
                if (layout.kind == Parameterization::Angular && d.z < -0.9)
                    bound += 0.3 * texel;
                if (layout.kind == Parameterization::Octahedral || layout.kind == Parameterization::Cube)
                    bound += 0.2 * texel; // the fold lines are kinks
                EXPECT_LT(worst(map.radiance(d), 0.5 * d + 0.5), bound) << describe(layout) << " at " << d.x << " " << d.y << " " << d.z;
            }
        }
}

TEST(EnvironmentMap, LookupsAreContinuousAcrossSeams)
{
    // Random texels; pairs of directions 1e-7 apart, spread and right on both sides of the seams. What a lookup may change over so small
    // a step is the steepest slope inside, (texel difference 1 per texel angle), not a jump.
    for (const auto kind : {Parameterization::Latlong, Parameterization::Cube, Parameterization::Octahedral}) {
        const MapLayout layout{kind, 16, 0};
        EnvironmentMap map(layout);
        unsigned state = 1;
        for (float& t : map.image.texels)
            t = static_cast<float>((state = state * 1664525u + 1013904223u) >> 8) / static_cast<float>(1 << 24);
        for (const auto& d : test::randomDirections(3000)) {
            for (glm::dvec3 seam :
                 {glm::dvec3(d.x, d.y, 0), glm::dvec3(0, d.y, d.z), glm::dvec3(d.x, 0, d.z), glm::dvec3(d.x, d.y, d.x),
                  glm::dvec3(d.x, d.y, -d.x), glm::dvec3(d.x, d.x, d.z), glm::dvec3(d.x, -d.x, d.z), glm::dvec3(d.x, d.z, d.z)}) {
                seam = glm::normalize(seam);
                const glm::vec3 a = map.radiance(seam + 1e-7 * d), b = map.radiance(seam - 1e-7 * d);
                const double polar = kind == Parameterization::Latlong ? 1.0 / std::max(1e-6, std::hypot(seam.x, seam.z)) : 1.0;
                EXPECT_LT(worst(a, glm::dvec3(b)), 1e-5 * polar) << describe(layout) << " at " << seam.x << " " << seam.y << " " << seam.z;
            }
        }
    }
}

TEST(EnvironmentMap, MeanOfAKnownRadianceIsItsIntegral)
{
    // The mean over the sphere of d_i^2 is 1/3; texel centers stand for their texels to second order.
    for (const MapLayout& layout : layoutsOfSize(128)) {
        const EnvironmentMap map = fill(layout, [](const glm::dvec3& d) { return d * d; });
        EXPECT_LT(glm::distance(meanRadiance(map), glm::dvec3(1.0 / 3.0)), 1e-3) << describe(layout);
    }
}

TEST(EnvironmentMap, MeanIgnoresWhatLiesOutsideADisc)
{
    const MapLayout layout{Parameterization::Paraboloid, 32, 2};
    EnvironmentMap map(layout);
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 64; ++x)
            std::fill_n(map.image.texel(x, y), 3, isInside(layout, x, y) ? 2.0f : std::numeric_limits<float>::infinity());
    EXPECT_LT(glm::distance(meanRadiance(map), glm::dvec3(2.0)), 1e-12);
}

} // namespace
} // namespace mirrorball
