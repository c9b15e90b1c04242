#include "core/report/seam_ratio.h"
#include "support/directions.h"
#include "support/probe_builders.h"

#include <gtest/gtest.h>

#include <cmath>

namespace mirrorball {
namespace {

EnvironmentMap mapOf(const MapLayout& layout, double (*radiance)(const glm::dvec3&))
{
    EnvironmentMap map(layout);
    for (int y = 0; y < map.image.height; ++y)
        for (int x = 0; x < map.image.width; ++x)
            for (int c = 0; c < 3; ++c)
                map.image.texel(x, y)[c] = static_cast<float>(radiance(texelDirection(layout, x, y)));
    return map;
}

TEST(SeamRatio, OfASmoothFunctionOfDirectionIsAboutOne)
{
    for (const MapLayout& layout : test::layoutsOfSize(48)) {
        const EnvironmentMap map = mapOf(layout, [](const glm::dvec3& d) { return 1.0 + 0.5 * d.x - 0.3 * d.y + 0.2 * d.z; });
        EXPECT_NEAR(seamSteps(map).ratio(), 1.0, 0.35) << test::describe(layout);
    }
}

TEST(SeamRatio, ShowsAStepThatSitsOnTheSeamOnly)
{
    EnvironmentMap map = mapOf({Parameterization::Cube, 16, 0}, [](const glm::dvec3& d) { return 1.0 + 0.5 * d.y; });
    const double before = seamSteps(map).ratio();
    for (int y = 16; y < 32; ++y) // -X brighter by a tenth, edge to edge
        for (int x = 0; x < 16; ++x)
            for (int c = 0; c < 3; ++c)
                map.image.texel(x, y)[c] += 0.1f;
    EXPECT_GT(seamSteps(map).ratio(), 2.0 * before);
}

TEST(SeamRatio, OfAConstantIsZeroAndOfOneTexelUndefinedAsZero)
{
    EXPECT_EQ(seamSteps(test::constantProbe(8)).ratio(), 0.0);
    EXPECT_EQ(seamSteps(test::constantProbe(1)).ratio(), 0.0);
}

} // namespace
} // namespace mirrorball
