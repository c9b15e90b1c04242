#include "core/spheremap/strokes/stroke_tiles.h"

#include "support/stroke_builders.h"

#include <gtest/gtest.h>

#include <cstring>

namespace mirrorball {
namespace {

TEST(StrokeTiles, HoldTheBytesOfTheRaster)
{
    for (const int size : {1, 70, 256}) {
        const std::vector<Stroke> strokes = handDrawnStrokes(30, 3, 0.06); // some erase
        const Image raster = paintStrokes(strokes, size);
        const StrokeTiles tiles(strokes, size);
        constexpr float nothing[4] = {};
        for (int y = size - 1; y >= 0; --y)
            for (int x = 0; x < size; ++x) {
                const float* texel = tiles.texel(x, y);
                ASSERT_EQ(std::memcmp(texel ? texel : nothing, raster.texel(x, y), sizeof nothing), 0) << size << ": " << x << ' ' << y;
            }
    }
}

TEST(StrokeTiles, DoNotExistWhereNoStrokeComes)
{
    const std::vector<Stroke> strokes{dab({-0.75, 0.75}, {.radius = 0.1})}; // texels 19 to 45 of 256
    const StrokeTiles tiles(strokes, 256);
    EXPECT_NE(tiles.texel(0, 0), nullptr);
    EXPECT_NE(tiles.texel(32, 32), nullptr);
    EXPECT_EQ(tiles.texel(64, 0), nullptr);
    EXPECT_EQ(tiles.texel(200, 200), nullptr);
}

TEST(StrokeTiles, LeaveSmudgesToTheRaster)
{
    EXPECT_TRUE(StrokeTiles::canPaint(handDrawnStrokes(20, 1)));
    EXPECT_FALSE(StrokeTiles::canPaint(std::vector<Stroke>{dab({0, 0}, {.mode = BrushMode::Smudge})}));
}

} // namespace
} // namespace mirrorball
