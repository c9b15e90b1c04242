#include "core/base/error.h"
#include "core/sphere/direction.h"
#include "core/spheremap/document/presets.h"
#include "core/spheremap/evaluation/evaluate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace mirrorball {
namespace {

const Layer white{.content = FillLayer{{1.0, 1.0, 1.0}}};

SphereMapDocument stack(std::vector<Layer> layers)
{
    SphereMapDocument document;
    document.layers = std::move(layers);
    return document;
}

/// Sets each parameter to the least or the largest of its range, or leaves it, and each choice to any of its words.
struct Extremes {
    std::mt19937& random;

    template <typename T>
    void operator()(const Field& field, T& value) const
    {
        if constexpr (std::is_same_v<T, bool>)
            value = random() % 2 == 0;
        else if constexpr (std::is_same_v<T, double> || std::is_same_v<T, int>)
            value = random() % 3 == 0 ? value : static_cast<T>(random() % 2 == 0 ? field.low : field.high);
        else if constexpr (std::is_same_v<T, glm::dvec3>)
            for (int c = 0; c < 3; ++c)
                (*this)(field, value[c]);
        else if constexpr (std::is_enum_v<T>)
            value = static_cast<T>(random() % words(T{}).size());
    }
    template <typename T>
    void operator()(const Field&, std::vector<T>& list) const
    {
        if constexpr (requires { T::visitFields(list.front(), Extremes{random}); })
            for (T& entry : list)
                T::visitFields(entry, Extremes{random});
    }
};

LayerContent extreme(std::string_view kind, std::mt19937& random)
{
    LayerContent content = makeContent(kind);
    std::visit(
        [&](auto& layer) {
            using L = std::decay_t<decltype(layer)>;
            if constexpr (std::is_same_v<L, ProbeLayer>) // its picture comes from one probe, which need not be filtered anew
                layer.exposure = random() % 2 == 0 ? 64.0 : -64.0, layer.tint = glm::dvec3(1000.0);
            else if constexpr (requires { L::visitFields(layer, Extremes{random}); })
                L::visitFields(layer, Extremes{random});
        },
        content);
    return content;
}

bool isFinite(const Image& map)
{
    return std::all_of(map.texels.begin(), map.texels.end(), [](float x) { return std::isfinite(x); });
}

std::vector<std::string_view> drawableKinds()
{
    std::vector<std::string_view> kinds;
    for (const LayerKind& kind : layerKinds())
        if (kind.name != "image") // it has no file here
            kinds.push_back(kind.name);
    return kinds;
}

/// At an odd size a texel's center is the disc's, where x, y and rho are 0.
TEST(EvaluateSphereMap, EveryKindIsFiniteEvenAtTheVeryCenter)
{
    std::mt19937 random(7);
    const auto assets = std::make_shared<SphereMapAssets>();
    for (const std::string_view kind : drawableKinds())
        for (int draw = 0; draw < 60; ++draw) {
            const SphereMapDocument document = stack({white, {.content = extreme(kind, random)}});
            for (const int size : {1, 33})
                ASSERT_TRUE(isFinite(evaluate(document, {.size = size, .assets = assets}))) << kind << ' ' << draw << ' ' << size;
        }
}

TEST(EvaluateSphereMap, NoParametersInTheirRangesOverflow)
{
    const ProbeLayer glare{.exposure = 64.0, .tint = glm::dvec3(1000.0)};
    const Image covered = evaluate(
        stack({{.content = glare}, {.blend = BlendMode::Multiply, .content = glare}, white, {.content = CurvesLayer{}}}), {.size = 33});
    EXPECT_EQ(covered, evaluate(stack({white, {.content = CurvesLayer{}}}), {.size = 33}));
    std::vector<Layer> brighter(20, {.content = HueSaturationLayer{.value = 1000.0}});
    brighter.front() = white;
    brighter.push_back({.blend = BlendMode::Multiply, .content = FillLayer{glm::dvec3(0.0)}});
    EXPECT_EQ(evaluate(stack(brighter), {.size = 1}).texels, (std::vector<float>{0.0f, 0.0f, 0.0f, 1.0f}));

    std::mt19937 random(11);
    const auto assets = std::make_shared<SphereMapAssets>();
    const std::vector<std::string_view> kinds = drawableKinds();
    for (int draw = 0; draw < 400; ++draw) {
        std::vector<Layer> layers;
        for (int i = 0; i < 12; ++i)
            layers.push_back({.opacity = random() % 2 == 0 ? 1.0 : 1e-6,
                              .blend = static_cast<BlendMode>(random() % words(BlendMode{}).size()),
                              .content = extreme(kinds[random() % kinds.size()], random)});
        ASSERT_TRUE(isFinite(evaluate(stack(layers), {.size = 9, .assets = assets}))) << draw;
    }
}

TEST(EvaluateSphereMap, WithoutLayersIsTransparent) { EXPECT_EQ(evaluate({}, {.size = 3}), Image(3, 3, 4)); }

TEST(EvaluateSphereMap, LayersCoverByTheirOpacity)
{
    const Image half = evaluate(stack({{.opacity = 0.25, .content = FillLayer{{4.0, 2.0, 0.0}}}}), {.size = 1});
    EXPECT_EQ(half.texels, (std::vector<float>{1.0f, 0.5f, 0.0f, 0.25f})); // multiplied by the opacity
    const Image over = evaluate(stack({white, {.opacity = 0.25, .content = FillLayer{{4.0, 2.0, 0.0}}}}), {.size = 1});
    EXPECT_EQ(over.texels, (std::vector<float>{1.75f, 1.25f, 0.75f, 1.0f}));
    const Image hidden = evaluate(stack({white, {.visible = false, .content = FillLayer{}}}), {.size = 1});
    EXPECT_EQ(hidden.texels, std::vector<float>(4, 1.0f));
}

TEST(EvaluateSphereMap, AMaskShowsALayerWhereItIsBright)
{
    const Layer black{.content = FillLayer{{0.0, 0.0, 0.0}},
                      .mask = Mask{.content = GradientLayer{.shape = GradientShape::Linear,
                                                            .stops = {{0.5, glm::dvec3(0.0)}, {0.5, glm::dvec3(1.0)}},
                                                            .angleDeg = 0.0}}};
    const Image right = evaluate(stack({white, black}), {.size = 8});
    EXPECT_EQ(right.texel(1, 4)[0], 1.0f);
    EXPECT_EQ(right.texel(6, 4)[0], 0.0f);
    Layer inverse = black;
    inverse.mask->invert = true;
    const Image left = evaluate(stack({white, inverse}), {.size = 8});
    EXPECT_EQ(left.texel(1, 4)[0], 0.0f);
    EXPECT_EQ(left.texel(6, 4)[0], 1.0f);
}

TEST(EvaluateSphereMap, TheRimsColorGoesOnOutsideTheDisc)
{
    const Image map = evaluate(stack({{.content = GradientLayer{.shape = GradientShape::Angular,
                                                                .stops = {{0.0, glm::dvec3(0.0)}, {1.0, glm::dvec3(1.0)}},
                                                                .mixing = ColorMixing::Linear}}}),
                               {.size = 256});
    // Along a ray from the center the angular gradient is constant: inside, at the rim and in the corner.
    EXPECT_NEAR(map.texel(255, 0)[0], map.texel(192, 63)[0], 1e-5f);
    const Image ring = evaluate(stack({white, {.content = SilhouetteLayer{.width = 0.1}}}), {.size = 64});
    EXPECT_EQ(ring.texel(0, 0)[0], 0.0f);
    EXPECT_EQ(ring.texel(32, 32)[0], 1.0f);
}

TEST(EvaluateSphereMap, ShadedGradientsFollowTheLight)
{
    // Linear ramp black to white: the value is (n.l + 1) / 2. The light is at the right, 60 degrees off the eye.
    const Image map = evaluate(stack({{.content = GradientLayer{.stops = {{0.0, glm::dvec3(0.0)}, {1.0, glm::dvec3(1.0)}},
                                                                .mixing = ColorMixing::Linear,
                                                                .azimuthDeg = 0.0,
                                                                .polarDeg = 60.0}}}),
                               {.size = 100});
    for (const int x : {10, 50, 90}) {
        const double nx = (x + 0.5) / 50.0 - 1.0, ny = 1.0 - 50.5 / 50.0, nz = std::sqrt(1.0 - nx * nx - ny * ny);
        EXPECT_NEAR(map.texel(x, 50)[1], 0.5 + 0.5 * (nx * std::sin(pi / 3.0) + nz * 0.5), 1e-5);
    }
}

TEST(EvaluateSphereMap, GivesTheSameBytesOnOneAndTwoThreads)
{
    for (const SphereMapPreset& preset : sphereMapPresets()) {
        const auto assets = std::make_shared<SphereMapAssets>();
        EXPECT_EQ(evaluate(preset.document, {.size = 150, .assets = assets}, {.threads = 1}),
                  evaluate(preset.document, {.size = 150, .assets = assets}, {.threads = 2}))
            << preset.name;
    }
}

TEST(EvaluateSphereMap, ARegionIsACutFromTheWhole)
{
    const TexelRect part{37, 20, 61, 90};
    for (const SphereMapPreset& preset : sphereMapPresets()) {
        const auto assets = std::make_shared<SphereMapAssets>();
        const Image whole = evaluate(preset.document, {.size = 96, .assets = assets});
        const Image region = evaluate(preset.document, {.size = 96, .region = part, .assets = assets});
        ASSERT_EQ(region.width, part.width());
        ASSERT_EQ(region.height, part.height());
        for (int y = 0; y < part.height(); ++y)
            ASSERT_TRUE(std::equal(region.row(y), region.row(y) + 4 * part.width(), whole.texel(part.x0, part.y0 + y))) << preset.name;
    }
}

TEST(EvaluateSphereMap, RefusesVisibleUnknownLayersUnlessToldToSkipThem)
{
    SphereMapDocument document = stack({white, {.content = makeContent("plasma")}});
    try {
        evaluate(document, {.size = 4});
        FAIL();
    } catch (const InvalidArgument& error) {
        EXPECT_STREQ(error.what(),
                     "layers[1].content.kind: \"plasma\" is no kind of layer that this version knows; hide the layer or update "
                     "Mirrorball");
    }
    EXPECT_EQ(evaluate(document, {.size = 4, .unknownLayers = UnknownLayers::Skip}), evaluate(stack({white}), {.size = 4}));
    document.layers[1].visible = false;
    EXPECT_EQ(evaluate(document, {.size = 4}), evaluate(stack({white}), {.size = 4}));
}

TEST(SphereMapAssets, ForgetWhatWasNotUsedTheLongestBeyondTheirBudget)
{
    SphereMapAssets assets(100);
    int made = 0;
    const auto get = [&](const char* key, size_t bytes) {
        return *assets.get<int>(key, [&] { return SphereMapAssets::Made<int>{++made, bytes}; });
    };
    EXPECT_EQ(get("a", 40), 1);
    EXPECT_EQ(get("b", 40), 2);
    EXPECT_EQ(get("a", 40), 1);
    EXPECT_EQ(get("c", 40), 3); // b goes
    EXPECT_EQ(assets.bytes(), 80u);
    EXPECT_EQ(get("a", 40), 1);
    EXPECT_EQ(get("b", 40), 4); // c goes
    EXPECT_EQ(get("huge", 1000), 5);
    EXPECT_EQ(assets.bytes(), 1000u); // the newest stays
    EXPECT_EQ(get("huge", 1000), 5);
}

TEST(EvaluateSphereMap, TakesTheRasterOfALayerThatIsAtHand)
{
    Image raster(4, 4, 4);
    raster.texel(1, 2)[1] = 0.5f;
    raster.texel(1, 2)[3] = 0.5f;
    const SphereMapDocument document = stack({white, {.content = FillLayer{}}});
    const Image map = evaluate(document, {.size = 4, .raster = [&](size_t layer, PaintTarget) { return layer == 1 ? &raster : nullptr; }});
    EXPECT_EQ(map.texel(0, 0)[0], 1.0f);
    EXPECT_EQ(map.texel(1, 2)[0], 0.5f); // half of white
    EXPECT_EQ(map.texel(1, 2)[1], 1.0f); // half of white and half of green
}

TEST(SphereMapLevels, KeepAWidthInPixels)
{
    const SphereMapDocument document = stack({white, {.content = SilhouetteLayer{.width = 3.0, .unit = WidthUnit::Pixels}}});
    ASSERT_TRUE(hasAuthoredLevels(document));
    const std::vector<Image> levels = evaluateLevels(document, 256);
    ASSERT_EQ(levels.size(), 9u);
    for (const Image& level : levels) {
        double dark = 0.0; // texels along the row through the middle, from the left edge to the center
        for (int x = 0; x < level.width / 2; ++x)
            dark += 1.0 - level.texel(x, level.height / 2)[0];
        if (level.width >= 32) { // 3 pixels, and at most the sagitta of a texel on a circle of 13: 1/26
            EXPECT_NEAR(dark, 3.0, 1.0 / 26.0) << level.width;
        } else if (level.width <= 4) {
            EXPECT_NEAR(dark, level.width / 2, 1e-6);
        }
    }
    // An ordinary chain halves it instead.
    const std::vector<Image> plain = plainChain(levels[0]);
    double dark = 0.0;
    for (int x = 0; x < 16; ++x)
        dark += 1.0 - plain[3].texel(x, 16)[0];
    EXPECT_NEAR(dark, 3.0 / 8.0, 0.05);
}

TEST(SphereMapLevels, OfADiscOnlyDocumentAreAverages)
{
    const SphereMapDocument document = stack({{.content = GradientLayer{}}});
    const std::vector<Image> levels = evaluateLevels(document, 5);
    ASSERT_EQ(levels.size(), 3u);
    EXPECT_EQ(levels[1].width, 2);
    EXPECT_EQ(levels[2].width, 1);
    EXPECT_EQ(levels, plainChain(evaluate(document, {.size = 5})));
    EXPECT_EQ(plainChain(Image(5, 5, 4, 0.75f))[1].texels, std::vector<float>(16, 0.75f));
}

TEST(EvaluateSphereMap, SaysWhichLayerIsWrong)
{
    const auto messageOf = [](const Layer& wrong) {
        try {
            evaluate(stack({white, wrong}), {.size = 4});
        } catch (const InvalidArgument& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    EXPECT_EQ(messageOf({.name = "Matcap", .content = ImageLayer{}}), "layers[1] \"Matcap\": source: must be an image file; it is empty");
    EXPECT_EQ(messageOf({.content = ProbeLayer{.source = ""}}).find("layers[1] \"Light probe\": source"), 0u);
    EXPECT_EQ(
        messageOf({.name = "Glow", .mask = Mask{.content = ImageLayer{.source = "gone.png"}}}).find("layers[1].mask \"Glow\": gone.png"),
        0u);
}

TEST(SphereMapLevels, LayersTakePartInTheLevelsTheyName)
{
    const SphereMapDocument document = stack({white, {.content = FillLayer{{0.0, 0.0, 0.0}}, .firstLevel = 1, .lastLevel = 2}});
    const std::vector<Image> levels = evaluateLevels(document, 16);
    EXPECT_EQ(levels[0].texel(8, 8)[0], 1.0f);
    EXPECT_EQ(levels[1].texel(4, 4)[0], 0.0f);
    EXPECT_EQ(levels[2].texel(2, 2)[0], 0.0f);
    EXPECT_EQ(levels[3].texel(1, 1)[0], 1.0f);
}

} // namespace
} // namespace mirrorball
