#include "core/report/resized_rows.h"

#include "core/base/error.h"
#include "support/probe_builders.h"

#include <gtest/gtest.h>

namespace mirrorball {
namespace {

/// Beside the poles and the seam too, in a wider map, a narrower one and one of the same width.
TEST(ResizedRows, AreTheBilinearLookupsAtTheTexelsCenters)
{
    const EnvironmentMap probe = test::noiseProbe(16, 3);
    for (const int width : {128, 20, 32}) {
        const MapLayout layout{Parameterization::Latlong, width / 2, 0};
        constexpr int firstRow = 1;
        const int rows = layout.height() - firstRow;
        const std::vector<float> rgb = resizedRows(probe, width, firstRow, rows);
        ASSERT_EQ(rgb.size(), static_cast<size_t>(3 * rows * width));
        for (int y = 0; y < rows; ++y)
            for (int x = 0; x < width; ++x) {
                const glm::vec3 truth = probe.radiance(texelDirection(layout, x, firstRow + y));
                for (int c = 0; c < 3; ++c)
                    ASSERT_NEAR(rgb[static_cast<size_t>(3 * (y * width + x) + c)], truth[c], 1e-4f * (1.0f + truth[c]))
                        << width << ' ' << x << ' ' << y;
            }
        const std::vector<float> top = resizedRows(probe, width, 0, 1);
        for (int x = 0; x < width; ++x)
            ASSERT_NEAR(top[static_cast<size_t>(3 * x)], probe.radiance(texelDirection(layout, x, 0)).r, 1e-3f) << "beside the pole";
    }
}

TEST(ResizedRows, RefuseOtherParameterizations)
{
    EXPECT_THROW(resizedRows(EnvironmentMap({Parameterization::Cube, 8, 0}), 64, 0, 1), InvalidArgument);
}

} // namespace
} // namespace mirrorball
