#include "core/spheremap/strokes/stroke_canvas.h"

#include "core/base/error.h"
#include "support/stroke_builders.h"

#include <gtest/gtest.h>

#include <random>

namespace mirrorball {
namespace {

/// Whether two rasters are the same outside a rectangle.
bool equalOutside(const TexelRect& rect, const Image& a, const Image& b)
{
    for (int y = 0; y < a.height; ++y)
        for (int x = 0; x < a.width; ++x) {
            if (x >= rect.x0 && x < rect.x1 && y >= rect.y0 && y < rect.y1)
                continue;
            if (!std::equal(a.texel(x, y), a.texel(x, y) + 4, b.texel(x, y)))
                return false;
        }
    return true;
}

TEST(StrokeCanvas, GivesTheBytesOfAFullEvaluationAfterEveryKindOfChange)
{
    const std::vector<Stroke> pool = handDrawnStrokes(60, 21, 0.06, 0.6, 25);
    std::mt19937 random(4);
    StrokeCanvas canvas(300);
    std::vector<Stroke> strokes;
    for (int step = 0; step < 60; ++step) {
        const Image before = canvas.image();
        const unsigned choice = random() % 8u;
        if (choice < 3 || strokes.empty()) {
            strokes.push_back(pool[random() % pool.size()]);
            strokes.back().points.resize(1 + random() % 8u);
        } else if (choice < 6) { // the pen goes on
            const Stroke& whole = pool[random() % pool.size()];
            strokes.back().points.insert(strokes.back().points.end(), whole.points.begin(), whole.points.begin() + 3);
        } else if (choice == 6) { // undo, once or several times
            strokes.resize(strokes.size() - std::min(strokes.size(), size_t{1} + random() % 3u));
        } else { // a change in the middle
            Stroke& stroke = strokes[random() % strokes.size()];
            stroke.brush.radius *= 1.3;
            stroke.symmetry.mirror = !stroke.symmetry.mirror;
        }
        const TexelRect dirty = canvas.update(strokes, {.threads = 1 + step % 2});
        ASSERT_EQ(canvas.image(), paintStrokes(strokes, 300)) << "step " << step << " choice " << choice;
        ASSERT_TRUE(equalOutside(dirty, before, canvas.image())) << "step " << step << " choice " << choice;
        ASSERT_TRUE(equalOutside(canvas.bounds(), Image(300, 300, 4), canvas.image()));
    }
}

TEST(StrokeCanvas, NothingIsDirtyWhenNothingChanges)
{
    const std::vector<Stroke> strokes = handDrawnStrokes(5, 1);
    StrokeCanvas canvas(128);
    EXPECT_FALSE(canvas.update(strokes).empty());
    EXPECT_TRUE(canvas.update(strokes).empty());
}

TEST(StrokeCanvas, ThePensNextPointsDirtyOnlyTheTilesTheyReach)
{
    std::vector<Stroke> strokes = handDrawnStrokes(20, 1);
    strokes.push_back(straightStroke({-0.9, -0.9}, {0.5, 0.5}, {.radius = 0.02}));
    StrokeCanvas canvas(1024);
    canvas.update(strokes);
    strokes.back().points.push_back({{0.53, 0.5}, 1.0});
    const TexelRect dirty = canvas.update(strokes);
    // 0.5 is texel 768; the tip is 10 texels wide and went on by 15: tiles of 64 around it.
    EXPECT_EQ(dirty.united({704, 192, 832, 320}), (TexelRect{704, 192, 832, 320}));
    EXPECT_FALSE(dirty.empty());
}

TEST(StrokeCanvas, ABadListChangesNothing)
{
    std::vector<Stroke> strokes = handDrawnStrokes(5, 1);
    StrokeCanvas canvas(128);
    canvas.update(strokes);
    const Image before = canvas.image();
    strokes[2].brush.radius = 0.0;
    EXPECT_THROW(canvas.update(strokes), InvalidArgument);
    EXPECT_EQ(canvas.image(), before);
}

TEST(StrokeCanvas, StartsAfreshAfterItWasStopped)
{
    const std::vector<Stroke> strokes = handDrawnStrokes(5, 1);
    std::stop_source stop;
    stop.request_stop();
    StrokeCanvas canvas(128);
    EXPECT_THROW(canvas.update(strokes, {.stop = stop.get_token()}), Cancelled);
    canvas.update(strokes);
    EXPECT_EQ(canvas.image(), paintStrokes(strokes, 128));
}

} // namespace
} // namespace mirrorball
