#include "core/shading/reflectance_map.h"

#include "core/base/error.h"
#include "core/sphere/direction.h"

#include <gtest/gtest.h>

#include <cmath>

namespace mirrorball {
namespace {

/// The texel of a disc whose middle lies next to a place on its right.
const float* rightOf(const Image& disc, double radius)
{
    return disc.texel(static_cast<int>((1.0 + radius) * 0.5 * disc.width), disc.height / 2);
}

// 003 eqs. 6 to 8: with h = n, D is that of the peak and G = 1, so that the map is F/(n.v)^2 over that at 80 degrees.
TEST(MirrorReflectanceMap, OfCookTorranceIsTheFresnelTermOverTheCosineSquared)
{
    const Image map = mirrorReflectanceMap(brdfFromText("cook-torrance:m=0.3,ior=1.5"), 401);
    const auto fresnel = [](double c) { return fresnelRgb({.kind = BrdfFresnelKind::Dielectric, .index = 1.5}, c).g; };
    const double c80 = std::cos(80.0 * pi / 180.0), most = fresnel(c80) / (c80 * c80);
    for (const double radius : {0.0, 0.5, 0.8, 0.95}) {
        const int x = static_cast<int>((1.0 + radius) * 0.5 * 401);
        const double r = 2.0 * (x + 0.5) / 401 - 1.0, c = std::sqrt(1.0 - r * r);
        EXPECT_NEAR(rightOf(map, radius)[1], fresnel(c) / (c * c) / most, 2e-3) << radius;
    }
    EXPECT_EQ(map.texel(0, 0)[0], 0.0f) << "outside the disc";
}

// "The surface properties can favor certain wavelengths": copper is red in front and loses its color towards the rim.
TEST(MirrorReflectanceMap, OfCopperIsDarkAndRedInFrontAndBrightAtGrazing)
{
    const Image map = mirrorReflectanceMap(brdfFromText("cook-torrance:m=0.3,metal=copper"), 201);
    const float *front = rightOf(map, 0.0), *rim = rightOf(map, 0.985);
    EXPECT_LT(front[0], 0.05f);
    EXPECT_NEAR(rim[0], 1.0f, 0.02f);
    EXPECT_LT(front[2] / front[0], rim[2] / rim[0]) << "the color shifts";
}

TEST(HemisphereMap, HasTheHighlightOppositeOfTheLight)
{
    const Image map = hemisphereMap(brdfFromText("phong:exponent=80"), 50.0 * pi / 180.0, 101);
    int bestX = 0, bestY = 0;
    for (int y = 0; y < 101; ++y)
        for (int x = 0; x < 101; ++x)
            if (map.texel(x, y)[1] > map.texel(bestX, bestY)[1]) {
                bestX = x;
                bestY = y;
            }
    EXPECT_NEAR(2.0 * (bestX + 0.5) / 101 - 1.0, std::sin(50.0 * pi / 180.0), 0.02);
    EXPECT_EQ(bestY, 50);
    EXPECT_EQ(falseColored(map).texel(0, 0)[0], 1.0f) << "white outside";
    EXPECT_THROW(hemisphereMap(Brdf{}, 0.3, 0), InvalidArgument);
}

} // namespace
} // namespace mirrorball
