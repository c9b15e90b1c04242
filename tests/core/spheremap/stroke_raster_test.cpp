#include "core/spheremap/strokes/stroke_raster.h"

#include "core/base/error.h"
#include "core/sphere/direction.h"
#include "support/stroke_builders.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace mirrorball {
namespace {

const Brush hard{.color = {1.0, 0.5, 0.25}, .radius = 0.3, .hardness = 1.0, .flow = 1.0, .spacing = 0.1};

glm::vec4 at(const Image& image, const glm::dvec2& q)
{
    const double n = image.width;
    const float* texel = image.texel(static_cast<int>((q.x + 1.0) * 0.5 * n), static_cast<int>((1.0 - q.y) * 0.5 * n));
    return {texel[0], texel[1], texel[2], texel[3]};
}

Image halved(const Image& image)
{
    Image half(image.width / 2, image.height / 2, image.channels);
    for (int y = 0; y < half.height; ++y)
        for (int x = 0; x < half.width; ++x)
            for (int c = 0; c < image.channels; ++c)
                half.texel(x, y)[c] = 0.25f * (image.texel(2 * x, 2 * y)[c] + image.texel(2 * x + 1, 2 * y)[c] +
                                               image.texel(2 * x, 2 * y + 1)[c] + image.texel(2 * x + 1, 2 * y + 1)[c]);
    return half;
}

double rms(const Image& a, const Image& b)
{
    double sum = 0.0;
    for (size_t i = 0; i < a.texels.size(); ++i)
        sum += std::pow(static_cast<double>(a.texels[i]) - static_cast<double>(b.texels[i]), 2);
    return std::sqrt(sum / static_cast<double>(a.texels.size()));
}

double farthest(const Image& a, const Image& b)
{
    double most = 0.0;
    for (size_t i = 0; i < a.texels.size(); ++i)
        most = std::max(most, std::abs(static_cast<double>(a.texels[i]) - static_cast<double>(b.texels[i])));
    return most;
}

TEST(StrokeRaster, IsPremultipliedAndTransparentWhereNothingWasPainted)
{
    Brush brush = hard;
    brush.flow = 0.5;
    const std::vector<Stroke> strokes{dab({0.25, 0.5}, brush)};
    const Image image = paintStrokes(strokes, 128);
    EXPECT_EQ(at(image, {0.25, 0.5}), glm::vec4(0.5f, 0.25f, 0.125f, 0.5f));
    EXPECT_EQ(at(image, {0.25, 0.0}), glm::vec4(0.0f));
    EXPECT_EQ(at(image, {0.25, -0.5}), glm::vec4(0.0f)); // y is up
}

TEST(StrokeRaster, AHardTipCoversACircleOfItsRadiusWithinTheEdgesTexel)
{
    const std::vector<Stroke> strokes{dab({0.1, -0.2}, hard)};
    const int n = 200;
    const Image image = paintStrokes(strokes, n);
    for (int y = 0; y < n; ++y)
        for (int x = 0; x < n; ++x) {
            const glm::dvec2 q{(x + 0.5) / n * 2.0 - 1.0, 1.0 - (y + 0.5) / n * 2.0};
            const double d = (glm::distance(q, glm::dvec2(0.1, -0.2)) - 0.3) * n / 2.0; // texels beyond the circle
            if (d < -0.51) {
                EXPECT_EQ(image.texel(x, y)[3], 1.0f);
            } else if (d > 0.51) {
                EXPECT_EQ(image.texel(x, y)[3], 0.0f);
            }
        }
}

TEST(StrokeRaster, ATiltedPensTipIsAnEllipseAlongTheWayItLeansAndSoAreItsCopies)
{
    Brush brush = hard;
    brush.radius = 0.12;
    brush.tilt = 1.0;
    Stroke stroke = dab({0.3, -0.4}, brush);
    stroke.points[0].tilt = {50.0, 30.0}; // to the right and up
    stroke.symmetry.mirror = true;
    const glm::dvec2 slope(std::tan(50.0 * pi / 180.0), std::tan(30.0 * pi / 180.0));
    const double length = std::sqrt(1.0 + glm::dot(slope, slope));
    const int n = 256;
    const Image image = paintStrokes(std::vector<Stroke>{stroke}, n);
    double painted = 0.0;
    for (int y = 0; y < n; ++y)
        for (int x = 0; x < n; ++x) {
            glm::dvec2 q{(x + 0.5) / n * 2.0 - 1.0, 1.0 - (y + 0.5) / n * 2.0};
            q.x = std::abs(q.x); // the copy is the mirror image
            const glm::dvec2 along = glm::normalize(slope), across(-along.y, along.x), d = q - glm::dvec2(0.3, -0.4);
            const double from = std::hypot(glm::dot(d, along) / length, glm::dot(d, across));
            const double texels = (from - 0.12) * n / 2.0; // beyond the ellipse, across
            painted += static_cast<double>(image.texel(x, y)[3]);
            if (texels < -0.51) {
                EXPECT_EQ(image.texel(x, y)[3], 1.0f);
            } else if (texels > 0.51) {
                EXPECT_EQ(image.texel(x, y)[3], 0.0f);
            }
        }
    // As much paint as the ellipses' areas; their edges fall on texels as they fall.
    EXPECT_NEAR(painted / (2.0 * pi * std::pow(0.12 * n / 2.0, 2) * length), 1.0, 0.005);
}

TEST(StrokeRaster, AnUprightPenDrawsTheSameBytesWithABrushThatHeedsTilt)
{
    std::vector<Stroke> strokes = handDrawnStrokes(12, 3, 0.05, 0.5, 30);
    const Image image = paintStrokes(strokes, 256);
    for (Stroke& stroke : strokes)
        stroke.brush.tilt = 1.0;
    EXPECT_EQ(paintStrokes(strokes, 256), image);
}

TEST(StrokeRaster, DabsOfOneStrokeCoverWhatTheOthersLeftUpToTheOpacity)
{
    Brush brush = hard;
    brush.flow = 0.3;
    brush.opacity = 0.8;
    brush.spacing = 0.1; // steps of 0.06: the middle of a long stroke lies under the dabs within 0.3, eleven of them
    const std::vector<Stroke> strokes{straightStroke({-0.6, 0.0}, {0.6, 0.0}, brush)};
    const float cover = at(paintStrokes(strokes, 512), {0.001, 0.001})[3];
    EXPECT_NEAR(cover, 0.8 * (1.0 - std::pow(0.7, 10)), 0.8 * 0.3 * std::pow(0.7, 10)); // ten or eleven
}

TEST(StrokeRaster, ErasingFullyLeavesNothingAndHalfLeavesHalf)
{
    Brush eraser = hard;
    eraser.mode = BrushMode::Erase;
    std::vector<Stroke> strokes{dab({0, 0}, hard), dab({0, 0}, eraser)};
    EXPECT_EQ(at(paintStrokes(strokes, 64), {0.01, 0.01}), glm::vec4(0.0f));
    strokes[1].brush.opacity = 0.5;
    EXPECT_EQ(at(paintStrokes(strokes, 64), {0.01, 0.01}), glm::vec4(0.5f, 0.25f, 0.125f, 0.5f));
}

TEST(StrokeRaster, LaterStrokesLieOverEarlierOnes)
{
    Brush over = hard;
    over.color = {0, 0, 1};
    over.opacity = 0.25;
    const std::vector<Stroke> strokes{dab({0, 0}, hard), dab({0.1, 0}, over)};
    EXPECT_EQ(at(paintStrokes(strokes, 64), {0.05, 0.01}), glm::vec4(0.75f, 0.375f, 0.1875f + 0.25f, 1.0f));
}

TEST(StrokeRaster, LooksTheSameAtEverySize)
{
    // Box-filtered from 2048 texels. Soft strokes: what differs is a smooth function against its mean over a texel.
    std::vector<Stroke> strokes = handDrawnStrokes(40, 3, 0.08, 0.6, 15);
    for (Stroke& stroke : strokes)
        stroke.brush.hardness *= 0.6;
    const Image fine = paintStrokes(strokes, 2048);
    Image coarse = fine;
    for (const int size : {1024, 512, 256}) {
        coarse = halved(coarse);
        EXPECT_LT(rms(coarse, paintStrokes(strokes, size)), size == 256 ? 0.005 : 0.002) << size;
    }
}

TEST(StrokeRaster, ThinHardLinesKeepTheirWeightOnCoarseGrids)
{
    // A line of radius 0.004 is half a texel at 256; the paint on it must be what it is at 2048.
    Brush pen = hard;
    pen.radius = 0.004;
    pen.flow = 0.05;
    const std::vector<Stroke> strokes{straightStroke({-0.7, -0.31}, {0.6, 0.42}, pen)};
    const auto paint = [&](int size) {
        const Image image = paintStrokes(strokes, size);
        double sum = 0.0;
        for (size_t i = 3; i < image.texels.size(); i += 4)
            sum += static_cast<double>(image.texels[i]);
        return sum / (static_cast<double>(size) * size);
    };
    const double fine = paint(2048);
    // A wider and weaker line saturates later: cover is 1 - exp(-x), and x is about 0.7 in the middle at 2048.
    EXPECT_NEAR(paint(512) / fine, 1.0, 0.02);
    EXPECT_NEAR(paint(256) / fine, 1.0, 0.1);
}

TEST(StrokeRaster, GivesTheSameBytesOnAnyNumberOfThreads)
{
    const std::vector<Stroke> strokes = handDrawnStrokes(60, 11, 0.06, 0.6, 20);
    const Image one = paintStrokes(strokes, 300, {.threads = 1});
    for (const int threads : {2, 3, 7})
        EXPECT_EQ(one, paintStrokes(strokes, 300, {.threads = threads})) << threads;
}

TEST(StrokeRaster, MirroredStrokesMakeAMirroredPicture)
{
    std::vector<Stroke> strokes = handDrawnStrokes(20, 5, 0.06, 0.6, 30);
    for (Stroke& stroke : strokes)
        stroke.symmetry.mirror = true;
    const int n = 256;
    const Image image = paintStrokes(strokes, n);
    Image mirrored(n, n, 4);
    for (int y = 0; y < n; ++y)
        for (int x = 0; x < n; ++x)
            std::copy_n(image.texel(x, y), 4, mirrored.texel(n - 1 - x, y));
    EXPECT_LT(farthest(image, mirrored), 1e-4); // rounding of positions on edges
    EXPECT_GT(rms(image, Image(n, n, 4)), 0.1);
}

TEST(StrokeRaster, RadialStrokesLookTheSameAfterATurn)
{
    std::vector<Stroke> strokes = handDrawnStrokes(12, 9, 0.05, 0.5, 30);
    for (Stroke& stroke : strokes)
        stroke.symmetry.radial = 4;
    const int n = 256;
    const Image image = paintStrokes(strokes, n);
    Image turned(n, n, 4);
    for (int y = 0; y < n; ++y)
        for (int x = 0; x < n; ++x)
            std::copy_n(image.texel(x, y), 4, turned.texel(n - 1 - y, x));
    EXPECT_LT(farthest(image, turned), 1e-4);
}

TEST(Smudge, CarriesColorFromWhereItBeganToWhereItEnds)
{
    // In the tip's hard core every step moves all of it: q_n came from q_(n-1), and so on to the first dab.
    std::vector<Stroke> strokes{dab({-0.4, 0.0}, hard)};
    strokes.push_back(straightStroke({-0.4, 0.0}, {0.4, 0.0}, {.mode = BrushMode::Smudge, .radius = 0.15, .hardness = 0.6, .flow = 1.0}));
    const Image image = paintStrokes(strokes, 256);
    const glm::vec4 end = at(image, {0.385, 0.0});
    EXPECT_NEAR(end.r, 1.0f, 1e-6);
    EXPECT_NEAR(end.g, 0.5f, 1e-6);
    EXPECT_EQ(at(image, {0.4, 0.25}), glm::vec4(0.0f)); // beside the tip nothing moves
}

TEST(Smudge, LeavesAnEvenColorEven)
{
    std::vector<Stroke> strokes{dab({0, 0}, {.color = {0.25, 0.5, 0.75}, .radius = 2.0, .hardness = 1.0, .flow = 1.0})};
    const Image even = paintStrokes(strokes, 128);
    for (Stroke& stroke : handDrawnStrokes(10, 2, 0.1, 0.8, 100))
        strokes.push_back(stroke);
    EXPECT_LT(farthest(even, paintStrokes(strokes, 128)), 1e-6);
}

TEST(Smudge, WithoutFlowOrMotionChangesNothing)
{
    std::vector<Stroke> strokes = handDrawnStrokes(10, 2);
    const Image before = paintStrokes(strokes, 128);
    strokes.push_back(dab({0, 0}, {.mode = BrushMode::Smudge, .radius = 0.5, .flow = 1.0}));
    strokes.push_back(straightStroke({-0.5, 0}, {0.5, 0}, {.mode = BrushMode::Smudge, .radius = 0.5, .flow = 0.0}));
    EXPECT_EQ(before, paintStrokes(strokes, 128));
}

TEST(StrokeRaster, StopsWhenAskedTo)
{
    std::stop_source stop;
    stop.request_stop();
    const std::vector<Stroke> strokes = handDrawnStrokes(10, 1);
    EXPECT_THROW(paintStrokes(strokes, 256, {.stop = stop.get_token()}), Cancelled);
}

TEST(StrokeRaster, StrokesOutsideTheMapCostNothingAndHurtNothing)
{
    const std::vector<Stroke> strokes{dab({3.9, 3.9}, hard), straightStroke({-3, 2}, {3, 2}, hard),
                                      straightStroke({2, -3}, {2, 3}, {.mode = BrushMode::Smudge, .flow = 1.0})};
    EXPECT_EQ(paintStrokes(strokes, 64), Image(64, 64, 4));
    EXPECT_EQ(paintStrokes({}, 1), Image(1, 1, 4));
    EXPECT_THROW(paintStrokes({}, 0), InvalidArgument);
}

} // namespace
} // namespace mirrorball
