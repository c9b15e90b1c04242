#include "core/spheremap/evaluation/sphere_map_cache.h"

#include "core/base/error.h"
#include "support/stroke_builders.h"

#include <gtest/gtest.h>

#include <functional>
#include <random>

namespace mirrorball {
namespace {

SphereMapDocument paintedDocument()
{
    SphereMapDocument document;
    document.layers = {
        {.content = GradientLayer{}},
        {.opacity = 0.8, .content = PaintLayer{.strokes = handDrawnStrokes(8, 5, 0.06, 0.5, 15)}},
        {.opacity = 0.5, .content = InvertLayer{}},
        {.blend = BlendMode::Multiply,
         .content = PaintLayer{.strokes = handDrawnStrokes(5, 6, 0.1, 0.7)},
         .mask = Mask{.content = GradientLayer{.shape = GradientShape::Radial}}},
        {.content = SilhouetteLayer{}, .mask = Mask{.content = PaintLayer{.strokes = handDrawnStrokes(3, 7, 0.2, 0.7)}}},
    };
    return document;
}

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

TEST(SphereMapCache, GivesTheBytesOfAFullEvaluationAfterEveryKindOfChange)
{
    const std::vector<Stroke> pool = handDrawnStrokes(40, 8, 0.08, 0.7, 20);
    std::mt19937 random(11);
    SphereMapCache cache({.size = 144});
    SphereMapDocument document = paintedDocument();
    cache.update(document);
    for (int step = 0; step < 60; ++step) {
        const Image before = cache.image();
        const auto painted = random();
        const auto choice = random() % 10u;
        std::vector<PaintLayer*> papers;
        for (Layer& layer : document.layers) {
            if (auto* paper = std::get_if<PaintLayer>(&layer.content))
                papers.push_back(paper);
            if (auto* paper = layer.mask ? std::get_if<PaintLayer>(&layer.mask->content) : nullptr)
                papers.push_back(paper);
        }
        std::vector<Stroke>& strokes = papers[painted % papers.size()]->strokes;
        if (choice < 3 || strokes.empty())
            strokes.push_back(pool[random() % pool.size()]);
        else if (choice < 5)
            strokes.back().points.push_back({strokes.back().points.back().q * 0.9 + 0.02, 1.0});
        else if (choice == 5)
            strokes.pop_back();
        else if (choice == 6)
            document.layers[random() % document.layers.size()].opacity = 0.1 * (1.0 + static_cast<double>(random() % 10u));
        else if (choice == 7)
            document.layers[random() % document.layers.size()].visible = random() % 4u != 0;
        else if (choice == 8)
            std::swap(document.layers[random() % document.layers.size()], document.layers[random() % document.layers.size()]);
        else if (auto* gradient = std::get_if<GradientLayer>(&document.layers[0].content))
            gradient->polarDeg += 5.0;
        const TexelRect dirty = cache.update(document, {.threads = 1 + step % 2});
        ASSERT_EQ(cache.image(), evaluate(document, {.size = 144})) << "step " << step << " choice " << choice;
        ASSERT_TRUE(equalOutside(dirty, before, cache.image())) << "step " << step << " choice " << choice;
    }
}

/// Changes a parameter that the picture depends on, whatever the kind.
void nudge(LayerContent& content, int step)
{
    std::visit(
        [step](auto& layer) {
            if constexpr (requires { layer.azimuthDeg; })
                layer.azimuthDeg = 10.0 + 7.0 * step;
            else if constexpr (requires { layer.angleDeg; })
                layer.angleDeg = 10.0 + 7.0 * step;
            else if constexpr (requires { layer.hueDeg; })
                layer.hueDeg = 10.0 + 7.0 * step;
            else if constexpr (requires { layer.sigmaDeg; })
                layer.sigmaDeg = 1.0 + 0.3 * step;
            else if constexpr (requires { layer.width; })
                layer.width = 0.05 + 0.01 * step;
            else if constexpr (requires { layer.color; })
                layer.color.x = 0.1 * step;
            else if constexpr (requires { layer.reference; })
                layer.reference = 400 + 50 * step;
        },
        content);
}

/// What a drag keeps - the picture below, what the layers above give, their masks - is not to be seen in its result.
TEST(SphereMapCache, GivesTheBytesOfAFullEvaluationWhileAnyParameterOfAnyLayerIsDragged)
{
    const std::vector<Stroke> strokes = handDrawnStrokes(12, 4, 0.06, 0.6, 15);
    const auto painted = [&](ptrdiff_t first) {
        return PaintLayer{.unit = WidthUnit::Pixels, .reference = 400, .strokes = {strokes.begin() + first, strokes.begin() + first + 4}};
    };
    SphereMapDocument document;
    document.layers = {{.content = GradientLayer{}},
                       {.blend = BlendMode::SoftLight, .content = ToonLayer{}, .mask = Mask{.content = PhongLightsLayer{}}},
                       {.opacity = 0.6, .content = painted(0)},
                       {.blend = BlendMode::Overlay, .content = FillLayer{}, .mask = Mask{.content = painted(4), .invert = true}},
                       {.content = HueSaturationLayer{.hueDeg = 20.0}},
                       {.content = TwistLayer{.angleDeg = 40.0}},
                       {.blend = BlendMode::Screen, .content = ColorgramLayer{}, .mask = Mask{.content = GradientLayer{}}},
                       {.opacity = 0.5, .content = BlurLayer{.sigmaDeg = 2.0}},
                       {.content = painted(8)},
                       {.content = SilhouetteLayer{.unit = WidthUnit::Pixels}}};
    const EvaluateOptions options{.size = 96, .levelSize = 192};
    SphereMapCache cache(options);
    cache.update(document);
    const auto dragged = [&](size_t layer, const char* what, const std::function<void(Layer&, int)>& change) {
        for (int step = 1; step <= 4; ++step) {
            change(document.layers[layer], step);
            cache.update(document, {.threads = 1 + step % 2});
            ASSERT_EQ(cache.image(), evaluate(document, options)) << what << " of layer " << layer << ", step " << step;
        }
    };
    for (size_t layer = 0; layer < document.layers.size(); ++layer) {
        dragged(layer, "opacity", [](Layer& l, int step) { l.opacity = 0.2 * step; });
        dragged(layer, "a parameter", [](Layer& l, int step) { nudge(l.content, step); });
        dragged(layer, "mask", [](Layer& l, int step) {
            if (l.mask)
                nudge(l.mask->content, step);
        });
        dragged(layer, "inversion", [](Layer& l, int step) {
            if (l.mask)
                l.mask->invert = step % 2 != 0;
        });
        dragged(layer, "blending and showing", [](Layer& l, int step) {
            l.blend = static_cast<BlendMode>(step);
            l.visible = step != 3;
        });
        dragged(layer, "having a mask", [](Layer& l, int step) {
            if (step % 2 != 0)
                l.mask = Mask{.content = GradientLayer{.shape = GradientShape::Angular}};
            else
                l.mask.reset();
        });
        std::get<PaintLayer>(document.layers[8].content).strokes.push_back(strokes[layer % 4]); // and a stroke in between
    }
}

TEST(Evaluate, TakesWhatALayerGivesFromWhereItIsAtHand)
{
    SphereMapDocument document;
    document.layers = {{.content = GradientLayer{}},
                       {.opacity = 0.7, .blend = BlendMode::Screen, .content = ToonLayer{}, .mask = Mask{.content = GradientLayer{}}},
                       {.content = InvertLayer{}}};
    EvaluateOptions options{.size = 70};
    const Image colors = drawnLayer(document, 1, PaintTarget::Layer, options), mask = drawnLayer(document, 1, PaintTarget::Mask, options);
    const Image plain = evaluate(document, options);
    options.drawn = [&](size_t layer, PaintTarget target) -> const Image* {
        return layer != 1 ? nullptr : target == PaintTarget::Mask ? &mask : &colors;
    };
    EXPECT_EQ(evaluate(document, options), plain);
    document.layers[1].content = FillLayer{}; // is not looked at
    EXPECT_EQ(evaluate(document, options), plain);
    EXPECT_THROW(drawnLayer(document, 2, PaintTarget::Layer, options), InvalidArgument);
    EXPECT_THROW(drawnLayer(document, 0, PaintTarget::Mask, options), InvalidArgument);
}

TEST(SphereMapCache, AStrokeEvaluatesOnlyItsTilesAndWhatContinuesThemPastTheRim)
{
    SphereMapDocument document = paintedDocument();
    SphereMapCache cache({.size = 1024});
    cache.update(document);
    std::get<PaintLayer>(document.layers[1].content).strokes.push_back(dab({0.1, 0.1}, {.radius = 0.02}));
    const TexelRect inside = cache.update(document);
    EXPECT_EQ(inside, (TexelRect{512, 448, 576, 512})); // 0.1 is texel 563 and, upwards, 461
    std::get<PaintLayer>(document.layers[1].content).strokes.push_back(dab({0.7, 0.7}, {.radius = 0.02}));
    const TexelRect rim = cache.update(document);
    EXPECT_EQ(rim.x1, 1024); // the corner outside takes the rim's color
    EXPECT_EQ(rim.y0, 0);
    EXPECT_LE(rim.width(), 256);
}

/// Under what moves the picture a stroke reaches other places: whichever it does not is as before, and the rest is right.
TEST(SphereMapCache, FollowsStrokesUnderEveryWarp)
{
    const std::vector<Layer> warps{{.content = BlurLayer{.sigmaDeg = 1.5}},
                                   {.content = BlurLayer{.sigmaDeg = 6.0}},
                                   {.content = TwistLayer{.angleDeg = 90.0}},
                                   {.content = TwistLayer{.angleDeg = -500.0, .radius = 0.6}},
                                   {.opacity = 0.5, .content = TwistLayer{.angleDeg = 30.0, .radius = 1.3}},
                                   {.content = RotateLayer{.angleDeg = 40.0}},
                                   {.content = RotateLayer{.rightDeg = 35.0, .upDeg = -20.0}},
                                   {.blend = BlendMode::Screen, .content = RotateLayer{.angleDeg = 10.0, .rightDeg = -80.0, .upDeg = 70.0}},
                                   {.content = RotateLayer{.upDeg = 180.0}}};
    const std::vector<Stroke> pool = handDrawnStrokes(40, 9, 0.05, 0.3);
    std::mt19937 random(12);
    for (size_t w = 0; w < warps.size(); ++w) {
        SphereMapDocument document;
        document.layers = {{.content = GradientLayer{}}, {.content = PaintLayer{}}, warps[w], {.content = SilhouetteLayer{}}};
        if (w == 0)
            document.layers.push_back(warps[2]);
        SphereMapCache cache({.size = 200});
        cache.update(document);
        std::vector<Stroke>& strokes = std::get<PaintLayer>(document.layers[1].content).strokes;
        for (int step = 0; step < 12; ++step) {
            const Image before = cache.image();
            if (step % 4 == 3)
                strokes.pop_back();
            else if (step % 4 == 2)
                strokes.back().points.push_back({strokes.back().points.back().q * 1.1 + 0.03, 1.0});
            else
                strokes.push_back(pool[random() % pool.size()]);
            const TexelRect dirty = cache.update(document);
            ASSERT_EQ(cache.image(), evaluate(document, {.size = 200})) << "warp " << w << " step " << step;
            ASSERT_TRUE(equalOutside(dirty, before, cache.image())) << "warp " << w << " step " << step;
        }
    }
}

TEST(SphereMapCache, AStrokeUnderATwistOrABlurEvaluatesWhatItReachesAndNotTheWhole)
{
    for (const Layer& warp :
         {Layer{.content = TwistLayer{.angleDeg = 90.0}}, Layer{.content = RotateLayer{.angleDeg = 40.0, .rightDeg = 20.0}},
          Layer{.content = BlurLayer{.sigmaDeg = 2.0}}}) {
        SphereMapDocument document;
        document.layers = {{.content = GradientLayer{}}, {.content = PaintLayer{}}, warp};
        SphereMapCache cache({.size = 1024});
        cache.update(document);
        std::get<PaintLayer>(document.layers[1].content).strokes.push_back(dab({0.3, 0.1}, {.radius = 0.02}));
        const TexelRect dirty = cache.update(document);
        EXPECT_LT(dirty.width(), 384) << kindOf(warp.content).name;
        EXPECT_LT(dirty.height(), 384) << kindOf(warp.content).name;
    }
}

TEST(SphereMapCache, AStrokeOnAMaskEvaluatesOnlyItsTiles)
{
    SphereMapDocument document = paintedDocument();
    SphereMapCache cache({.size = 1024});
    cache.update(document);
    std::get<PaintLayer>(document.layers[4].mask->content).strokes.push_back(dab({0.1, 0.1}, {.radius = 0.02}));
    EXPECT_EQ(cache.update(document), (TexelRect{512, 448, 576, 512}));
}

TEST(SphereMapCache, IsUnchangedByNamesAndStartsAfreshAfterItWasStopped)
{
    SphereMapDocument document = paintedDocument();
    SphereMapCache cache({.size = 64});
    std::stop_source stop;
    stop.request_stop();
    EXPECT_THROW(cache.update(document, {.stop = stop.get_token()}), Cancelled);
    EXPECT_EQ(cache.update(document), (TexelRect{0, 0, 64, 64}));
    EXPECT_EQ(cache.image(), evaluate(document, {.size = 64}));
    document.layers[1].name = "shine";
    EXPECT_TRUE(cache.update(document).empty());
    EXPECT_THROW(SphereMapCache({.size = 0}), InvalidArgument);
}

TEST(PaintLayer, ContinuesTheRimsColorOutsideTheDiscWhateverWasPaintedThere)
{
    const Brush hard{.color = {1, 0, 0}, .radius = 0.5, .hardness = 1.0, .flow = 1.0};
    Brush other = hard;
    other.color = {0, 1, 0};
    SphereMapDocument document;
    document.layers = {{.content = PaintLayer{.strokes = {dab({0.7, 0.7}, hard), dab({1.0, 1.0}, other)}}}};
    std::get<PaintLayer>(document.layers[0].content).strokes[1].brush.radius = 0.3; // green in the corner, outside the disc only
    const Image map = evaluate(document, {.size = 256});
    EXPECT_EQ(map.texel(254, 1)[0], 1.0f);
    EXPECT_EQ(map.texel(254, 1)[1], 0.0f);
    // A region is a cut of the whole, though its rim lies elsewhere.
    const TexelRect corner{230, 0, 256, 20};
    const Image part = evaluate(document, {.size = 256, .region = corner});
    for (int y = 0; y < part.height; ++y)
        for (int x = 0; x < part.width; ++x)
            EXPECT_TRUE(std::equal(part.texel(x, y), part.texel(x, y) + 4, map.texel(corner.x0 + x, corner.y0 + y)));
}

TEST(PaintLayer, InPixelsATipKeepsItsWidthOnEveryLevel)
{
    SphereMapDocument document;
    document.layers = {
        {.content = PaintLayer{.unit = WidthUnit::Pixels,
                               .reference = 512,
                               .strokes = {straightStroke({-2, 0}, {2, 0}, {.radius = 4.0 / 256.0, .hardness = 1.0, .flow = 1.0})}}}};
    ASSERT_TRUE(hasAuthoredLevels(document));
    for (const int size : {512, 128, 32}) {
        const Image map = evaluate(document, {.size = size});
        double width = 0.0;
        for (int y = 0; y < size; ++y)
            width += static_cast<double>(map.texel(size / 2, y)[3]);
        EXPECT_NEAR(width, 8.0, 0.6) << size; // dabs a tenth of a diameter apart leave the edge a little uneven
    }
}

} // namespace
} // namespace mirrorball
