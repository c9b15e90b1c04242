#include "core/sphere/direction.h"
#include "core/spheremap/evaluation/evaluate.h"
#include "core/spheremap/math/light_direction.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace mirrorball {
namespace {

Image picture(std::vector<Layer> layers, int size, SphereMapIndex index = SphereMapIndex::Normal)
{
    SphereMapDocument document;
    document.layers = std::move(layers);
    document.index = index;
    return evaluate(document, {.size = size});
}

std::vector<float> adjusted(const glm::dvec3& color, LayerContent adjustment)
{
    return picture({{.content = FillLayer{color}}, {.content = std::move(adjustment)}}, 1).texels;
}

void expectNear(const std::vector<float>& found, const glm::dvec3& expected, double tolerance = 1e-5)
{
    for (size_t c = 0; c < 3; ++c)
        EXPECT_NEAR(found[c], expected[static_cast<int>(c)], tolerance);
}

const Layer ramp{.content = GradientLayer{.shape = GradientShape::Linear, .stops = {{0.0, {0.1, 0.0, 0.4}}, {1.0, {2.0, 1.0, 0.3}}}}};

TEST(HueSaturation, TurnsScalesAndGrays)
{
    expectNear(adjusted({2.0, 0.5, 0.5}, HueSaturationLayer{.hueDeg = 120.0}), {0.5, 2.0, 0.5});
    expectNear(adjusted({2.0, 0.5, 0.5}, HueSaturationLayer{.hueDeg = -120.0}), {0.5, 0.5, 2.0});
    expectNear(adjusted({0.2, 0.6, 0.4}, HueSaturationLayer{.saturation = 0.0}), {0.6, 0.6, 0.6});
    expectNear(adjusted({0.2, 0.6, 0.4}, HueSaturationLayer{.saturation = 10.0}), {0.0, 0.6, 0.3});
    expectNear(adjusted({0.2, 0.6, 0.4}, HueSaturationLayer{.value = 3.0}), {0.6, 1.8, 1.2});
    expectNear(adjusted({0.2, 0.6, 0.4}, HueSaturationLayer{}), {0.2, 0.6, 0.4});
    expectNear(adjusted({0.2, 0.6, 0.4}, HueSaturationLayer{.hueDeg = 360.0}), {0.2, 0.6, 0.4});
}

TEST(Curves, GoThroughTheirPointsAndKeepTheRatiosOfBrightLight)
{
    const CurvesLayer curve{.points = {{0.0, 0.0}, {0.5, 0.25}, {1.0, 1.0}}};
    expectNear(adjusted({0.0, 0.25, 1.0}, curve), {0.0, 0.0625, 1.0}); // on square roots: 0.5 becomes 0.25
    expectNear(adjusted({4.0, 9.0, 1.0}, curve), {4.0, 9.0, 1.0});
    expectNear(adjusted({0.3, 0.7, 5.0}, CurvesLayer{.points = {{0.0, 0.0}, {1.0, 1.0}}}), {0.3, 0.7, 5.0});
    CurvesLayer red = curve;
    red.channels = AdjustedChannels::Red;
    expectNear(adjusted({0.25, 0.25, 0.25}, red), {0.0625, 0.25, 0.25});
}

TEST(Curves, NeverTurnBackBetweenRisingPoints)
{
    const Image map = picture({{.content = GradientLayer{.shape = GradientShape::Linear,
                                                         .stops = {{0.0, glm::dvec3(0.0)}, {1.0, glm::dvec3(1.0)}},
                                                         .mixing = ColorMixing::Linear,
                                                         .angleDeg = 0.0}},
                               {.content = CurvesLayer{.points = {{0.0, 0.0}, {0.1, 0.0}, {0.15, 0.8}, {0.9, 0.81}, {1.0, 1.0}}}}},
                              500);
    for (int x = 1; x < 500; ++x)
        ASSERT_GE(map.texel(x, 250)[0], map.texel(x - 1, 250)[0]);
}

TEST(Posterize, LeavesAsManyTonesAsCounted)
{
    const Image map = picture(
        {{.content =
              GradientLayer{.shape = GradientShape::Linear, .stops = {{0.0, glm::dvec3(0.0)}, {1.0, glm::dvec3(1.0)}}, .angleDeg = 0.0}},
         {.content = PosterizeLayer{.tones = 5, .softness = 0.0}}},
        512);
    std::set<int> tones;
    for (int x = 0; x < 512; ++x)
        tones.insert(static_cast<int>(std::lround(1000.0 * std::sqrt(map.texel(x, 256)[0]))));
    EXPECT_LE(tones.size(), 9u); // five, and a texel in each slope
    for (const int tone : {0, 250, 500, 750, 1000})
        EXPECT_TRUE(tones.contains(tone)) << tone;
}

TEST(Invert, TwiceIsAsBefore)
{
    expectNear(adjusted({0.0, 1.0, 0.25}, InvertLayer{}), {1.0, 0.0, 0.25});
    const std::vector<float> twice =
        picture({{.content = FillLayer{{0.1, 0.5, 0.9}}}, {.content = InvertLayer{}}, {.content = InvertLayer{}}}, 1).texels;
    expectNear(twice, {0.1, 0.5, 0.9});
}

TEST(Adjustments, MixWithWhatLiesBelowByTheirOpacity)
{
    const std::vector<float> half =
        picture({{.content = FillLayer{{1.0, 0.0, 0.0}}}, {.opacity = 0.5, .content = InvertLayer{}}}, 1).texels;
    expectNear(half, {0.5, 0.5, 0.5});
    for (const LayerKind& kind : layerKinds())
        if (kind.role != LayerRole::Generator) {
            const Image plain = picture({ramp}, 40);
            EXPECT_EQ(picture({ramp, {.opacity = 0.0, .content = makeContent(kind.name)}}, 40), plain) << kind.name;
        }
}

TEST(Rotate, MovesWhatLayAtTheCenter)
{
    const Layer spot{.content = PhongLightsLayer{.lights = {{.polarDeg = 0.0, .exponent = 60.0}}}};
    const auto brightest = [](const Image& map) {
        int best = 0;
        for (int i = 0; i < map.width * map.height; ++i)
            if (map.texels[4 * static_cast<size_t>(i)] > map.texels[4 * static_cast<size_t>(best)])
                best = i;
        return glm::ivec2(best % map.width, best / map.width);
    };
    // 30 degrees on the ball is half a radius in the picture.
    EXPECT_EQ(brightest(picture({spot, {.content = RotateLayer{.rightDeg = 30.0}}}, 201)), glm::ivec2(150, 100));
    EXPECT_EQ(brightest(picture({spot, {.content = RotateLayer{.upDeg = 30.0}}}, 201)), glm::ivec2(100, 50));
    // By mirror directions the light moves as if it were at azimuth 0: 90 degrees counterclockwise it is at the top.
    const Layer aside{.content = PhongLightsLayer{.lights = {{.azimuthDeg = 0.0, .polarDeg = 60.0, .exponent = 60.0}}}};
    EXPECT_EQ(brightest(picture({aside, {.content = RotateLayer{.angleDeg = 90.0}}}, 201)), glm::ivec2(100, 50));
}

TEST(Twist, TurnsTheCenterAndLeavesTheRim)
{
    const Image plain = picture({ramp}, 201), twisted = picture({ramp, {.content = TwistLayer{.angleDeg = 180.0}}}, 201);
    EXPECT_NEAR(twisted.texel(100, 1)[0], plain.texel(100, 1)[0], 1e-3f);
    EXPECT_NEAR(twisted.texel(100, 98)[0], plain.texel(100, 102)[0], 2e-2f); // near the center upside down
    const Image none = picture({ramp, {.content = TwistLayer{.angleDeg = 0.0}}}, 201);
    for (int y = 0; y < 201; ++y)
        for (int x = 0; x < 201; ++x) // outside the disc the nearest point of the rim is read, between texels
            for (int c = 0; c < 4 && std::hypot(x - 100, y - 100) < 99.0; ++c)
                ASSERT_NEAR(none.texel(x, y)[c], plain.texel(x, y)[c], 1e-5f) << x << ' ' << y;
}

TEST(Blur, AConstantStaysConstant)
{
    for (const SphereMapIndex index : {SphereMapIndex::Normal, SphereMapIndex::Reflection})
        for (const double sigma : {0.0, 1.0, 10.0, 60.0}) {
            const Image map =
                picture({{.opacity = 0.5, .content = FillLayer{{1.0, 2.0, 3.0}}}, {.content = BlurLayer{.sigmaDeg = sigma}}}, 64, index);
            for (size_t i = 0; i < map.texels.size(); ++i)
                ASSERT_NEAR(map.texels[i], std::vector<float>({0.5f, 1.0f, 1.5f, 0.5f})[i % 4], 2e-5f) << sigma;
        }
}

/// A change of brightness half way to the rim, where a map of mirror directions turns from the front to the back.
TEST(Blur, HasNoSeamWhereMirrorDirectionsTurnBackwards)
{
    constexpr int size = 400;
    const Image map = picture({ramp, {.content = BlurLayer{.sigmaDeg = 6.0}}}, size, SphereMapIndex::Reflection);
    float steepest = 0.0f; // of second differences along the middle row: a seam would be the largest of all
    float atTheTurn = 0.0f;
    for (int x = size / 2; x < size - 12; ++x) {
        const float bend = std::fabs(map.texel(x - 1, 200)[0] - 2.0f * map.texel(x, 200)[0] + map.texel(x + 1, 200)[0]);
        float& largest = std::fabs(x - size / 2 * (1.0 + std::sqrt(0.5))) < 8.0 ? atTheTurn : steepest;
        largest = std::max(largest, bend);
    }
    EXPECT_LE(atTheTurn, 2.0f * steepest);
}

/// The sum that BlurLayer defines, over the texels of the map itself. The solid angle of a texel of the disc is proportional to 1/z for
/// normals; for mirror directions all are alike.
glm::dvec3 blurredByDefinition(const Image& map, const glm::dvec2& at, double sigma, bool mirror)
{
    const auto direction = [&](const glm::dvec2& q) {
        const double z = std::sqrt(std::max(1.0 - glm::dot(q, q), 0.0));
        return mirror ? glm::dvec3(2.0 * z * q, 2.0 * z * z - 1.0) : glm::dvec3(q, z);
    };
    const glm::dvec3 n = direction(at);
    glm::dvec3 sum(0.0);
    double weights = 0.0;
    for (int y = 0; y < map.height; ++y)
        for (int x = 0; x < map.width; ++x) {
            const glm::dvec2 q((x + 0.5) * 2.0 / map.width - 1.0, 1.0 - (y + 0.5) * 2.0 / map.width);
            if (glm::dot(q, q) >= 1.0)
                continue;
            const double w = std::exp((glm::dot(n, direction(q)) - 1.0) / (sigma * sigma)) / (mirror ? 1.0 : direction(q).z);
            sum += w * glm::dvec3(map.texel(x, y)[0], map.texel(x, y)[1], map.texel(x, y)[2]);
            weights += w;
        }
    return sum / weights;
}

TEST(Blur, IsTheGaussianOnTheSphereEvenAtTheRim)
{
    const std::vector<Layer> scene{ramp, {.content = ToonLayer{}}, {.blend = BlendMode::Add, .content = PhongLightsLayer{}}};
    for (const auto& [index, size, sigmaDeg] : {std::tuple{SphereMapIndex::Normal, 240, 4.0},
                                                {SphereMapIndex::Normal, 240, 15.0},
                                                {SphereMapIndex::Normal, 600, 2.0},
                                                {SphereMapIndex::Reflection, 240, 4.0},
                                                {SphereMapIndex::Reflection, 240, 15.0},
                                                {SphereMapIndex::Reflection, 240, 60.0},
                                                {SphereMapIndex::Reflection, 480, 3.0},
                                                {SphereMapIndex::Reflection, 720, 2.0}}) {
        std::vector<Layer> layers = scene;
        layers.push_back({.content = BlurLayer{.sigmaDeg = sigmaDeg}});
        const Image sharp = picture(scene, size, index), blurred = picture(layers, size, index);
        // In 240ths of the map: the center, half way, where mirror directions turn backwards, the rim.
        for (const auto& [u, v] :
             {std::pair{120, 120}, {72, 54}, {180, 156}, {36, 120}, {120, 12}, {198, 192}, {205, 120}, {60, 180}, {120, 2}, {236, 122}}) {
            const int x = u * size / 240, y = v * size / 240;
            const glm::dvec2 q((x + 0.5) * 2.0 / size - 1.0, 1.0 - (y + 0.5) * 2.0 / size);
            const glm::dvec3 expected = blurredByDefinition(sharp, q, sigmaDeg * pi / 180.0, index == SphereMapIndex::Reflection);
            for (int c = 0; c < 3; ++c) // cells of half a sigma: 2 % of the map's range, 1
                EXPECT_NEAR(blurred.texel(x, y)[c], expected[c], 0.02) << sigmaDeg << ": " << x << ' ' << y;
        }
    }
}

TEST(Blur, ARegionIsACutFromTheWholeAndTouchesAreWidened)
{
    SphereMapDocument document;
    document.layers = {ramp, {.content = HatchingLayer{}}, {.content = BlurLayer{.sigmaDeg = 3.0}}};
    const Image whole = evaluate(document, {.size = 300});
    const TexelRect part{101, 143, 131, 180};
    const Image region = evaluate(document, {.size = 300, .region = part});
    for (int y = 0; y < part.height(); ++y)
        ASSERT_TRUE(std::equal(region.row(y), region.row(y) + 4 * part.width(), whole.texel(part.x0, part.y0 + y))) << y;
    const TexelRect touched = touchedBy(document, 0, {150, 150, 152, 152}, {.size = 300});
    EXPECT_LT(touched.x0, 150 - 27); // 3.5 sigma are 27 texels
    EXPECT_LT(touched.width(), 300);
    document.layers.push_back({.content = TwistLayer{}});
    const TexelRect twisted = touchedBy(document, 0, {150, 150, 152, 152}, {.size = 300});
    EXPECT_EQ(twisted.united(touched), twisted);
    EXPECT_LT(twisted.width(), 300);
}

} // namespace
} // namespace mirrorball
