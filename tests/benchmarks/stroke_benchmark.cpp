#include "core/spheremap/evaluation/sphere_map_cache.h"
#include "support/stroke_builders.h"

#include <benchmark/benchmark.h>

#include <cmath>

/// Times of the stroke engine on two threads: 200 strokes at once, and what one frame of painting on top of them costs.
namespace mirrorball {
namespace {

const JobControl twoThreads{.threads = 2};

void strokes200(benchmark::State& state)
{
    const std::vector<Stroke> strokes = handDrawnStrokes(200, 1);
    for (auto _ : state)
        benchmark::DoNotOptimize(paintStrokes(strokes, static_cast<int>(state.range(0)), twoThreads));
}
BENCHMARK(strokes200)->Arg(256)->Arg(1024)->Arg(2048)->UseRealTime()->Unit(benchmark::kMillisecond);

/// The pen moves by 1/50 of the disc a frame over 200 strokes; the argument is the tip's radius in thousandths.
void penMoves(benchmark::State& state)
{
    std::vector<Stroke> strokes = handDrawnStrokes(200, 1);
    const Brush brush{.mode = static_cast<BrushMode>(state.range(1)), .radius = static_cast<double>(state.range(0)) * 1e-3};
    StrokeCanvas canvas(1024);
    canvas.update(strokes, twoThreads);
    strokes.push_back(dab({-0.6, 0.0}, brush));
    double t = 0.0;
    for (auto _ : state) {
        t += 0.02;
        if (strokes.back().points.size() > 200)
            strokes.back().points.resize(1);
        strokes.back().points.push_back({{0.6 * std::cos(t), 0.6 * std::sin(t)}, 1.0});
        benchmark::DoNotOptimize(canvas.update(strokes, twoThreads));
    }
}
BENCHMARK(penMoves)->Args({20, 0})->Args({80, 0})->Args({300, 0})->Args({80, 2})->UseRealTime()->Unit(benchmark::kMillisecond);

/// A new stroke, whole, and its undoing.
void strokeAndUndo(benchmark::State& state)
{
    std::vector<Stroke> strokes = handDrawnStrokes(201, 1);
    const std::vector<Stroke> without(strokes.begin(), strokes.end() - 1);
    StrokeCanvas canvas(1024);
    canvas.update(without, twoThreads);
    for (auto _ : state) {
        benchmark::DoNotOptimize(canvas.update(strokes, twoThreads));
        benchmark::DoNotOptimize(canvas.update(without, twoThreads));
    }
}
BENCHMARK(strokeAndUndo)->UseRealTime()->Unit(benchmark::kMillisecond);

/// Undo goes on below the last stroke: the tiles of each that goes are evaluated from the first stroke on.
void undoFarBack(benchmark::State& state)
{
    const std::vector<Stroke> all = handDrawnStrokes(200, 1);
    std::vector<Stroke> strokes = all;
    StrokeCanvas canvas(1024);
    canvas.update(strokes, twoThreads);
    for (auto _ : state) {
        if (strokes.size() < 100) {
            state.PauseTiming();
            strokes = all;
            canvas.update(strokes, twoThreads);
            state.ResumeTiming();
        }
        strokes.pop_back();
        benchmark::DoNotOptimize(canvas.update(strokes, twoThreads));
    }
}
BENCHMARK(undoFarBack)->UseRealTime()->Unit(benchmark::kMillisecond);

/// Ten layers with 200 strokes in three of them.
SphereMapDocument tenLayers()
{
    const std::vector<Stroke> strokes = handDrawnStrokes(200, 1);
    const auto share = [&](ptrdiff_t first, ptrdiff_t last) {
        return PaintLayer{.strokes = {strokes.begin() + first, strokes.begin() + last}};
    };
    SphereMapDocument document;
    document.layers = {{.content = GradientLayer{}},
                       {.blend = BlendMode::Multiply, .content = GradientLayer{.shape = GradientShape::Radial}},
                       {.content = share(0, 80)},
                       {.opacity = 0.5, .blend = BlendMode::Screen, .content = GradientLayer{.shape = GradientShape::Linear}},
                       {.opacity = 0.3, .content = InvertLayer{}},
                       {.blend = BlendMode::SoftLight, .content = share(80, 160)},
                       {.opacity = 0.4, .blend = BlendMode::Overlay, .content = GradientLayer{.shape = GradientShape::Angular}},
                       {.opacity = 0.5, .content = FillLayer{}, .mask = Mask{.content = GradientLayer{.shape = GradientShape::Radial}}},
                       {.content = share(160, 200)},
                       {.content = SilhouetteLayer{}}};
    return document;
}

void tenLayersWith200Strokes(benchmark::State& state)
{
    const SphereMapDocument document = tenLayers();
    for (auto _ : state)
        benchmark::DoNotOptimize(evaluate(document, {.size = static_cast<int>(state.range(0))}, twoThreads));
}
BENCHMARK(tenLayersWith200Strokes)->Arg(256)->Arg(1024)->UseRealTime()->Unit(benchmark::kMillisecond);

/// One frame of painting on the top paint layer of that document: what the studio waits for between two movements of the pen.
void penMovesOnTenLayers(benchmark::State& state)
{
    SphereMapDocument document = tenLayers();
    SphereMapCache cache({.size = 1024});
    cache.update(document, twoThreads);
    std::vector<Stroke>& strokes = std::get<PaintLayer>(document.layers[8].content).strokes;
    strokes.push_back(dab({-0.6, 0.0}, {.radius = static_cast<double>(state.range(0)) * 1e-3}));
    cache.update(document, twoThreads);
    double t = 0.0;
    for (auto _ : state) {
        t += 0.02;
        if (strokes.back().points.size() > 200)
            strokes.back().points.resize(1);
        strokes.back().points.push_back({{0.6 * std::cos(t), 0.6 * std::sin(t)}, 1.0});
        benchmark::DoNotOptimize(cache.update(document, twoThreads));
    }
}
BENCHMARK(penMovesOnTenLayers)->Arg(20)->Arg(80)->Arg(300)->UseRealTime()->Unit(benchmark::kMillisecond);

/// The same under a layer that moves the picture, or on a mask; the argument is the index into what.
void penMovesUnder(benchmark::State& state)
{
    struct Case {
        const char* name;
        Layer above;
    };
    static const std::vector<Case> cases{{"nothing", {.visible = false}},
                                         {"blur of 2 degrees", {.content = BlurLayer{.sigmaDeg = 2.0}}},
                                         {"blur of 8 degrees", {.content = BlurLayer{.sigmaDeg = 8.0}}},
                                         {"twist", {.content = TwistLayer{}}},
                                         {"rotation", {.content = RotateLayer{.angleDeg = 40.0, .rightDeg = 20.0}}},
                                         {"a mask's owner", {.content = FillLayer{}, .mask = Mask{.content = PaintLayer{}}}}};
    const Case& wanted = cases[static_cast<size_t>(state.range(0))];
    state.SetLabel(wanted.name);
    SphereMapDocument document = tenLayers();
    document.layers.push_back(wanted.above);
    const bool isMask = wanted.above.mask.has_value();
    SphereMapCache cache({.size = 1024});
    cache.update(document, twoThreads);
    std::vector<Stroke>& strokes = std::get<PaintLayer>(isMask ? document.layers[10].mask->content : document.layers[8].content).strokes;
    strokes.push_back(dab({-0.6, 0.0}, {.radius = 0.04}));
    cache.update(document, twoThreads);
    double t = 0.0;
    for (auto _ : state) {
        t += 0.02;
        if (strokes.back().points.size() > 200)
            strokes.back().points.resize(1);
        strokes.back().points.push_back({{0.6 * std::cos(t), 0.6 * std::sin(t)}, 1.0});
        benchmark::DoNotOptimize(cache.update(document, twoThreads));
    }
}
BENCHMARK(penMovesUnder)->DenseRange(0, 5)->UseRealTime()->Unit(benchmark::kMillisecond);

/// A slider of a layer in the middle; the argument is the map's size, 512 where the picture shows no more.
void opacityOfTheSeventhOfTenLayers(benchmark::State& state)
{
    SphereMapDocument document = tenLayers();
    SphereMapCache cache({.size = static_cast<int>(state.range(0)), .levelSize = 1024});
    for (auto _ : state) {
        document.layers[6].opacity = document.layers[6].opacity > 0.8 ? 0.2 : document.layers[6].opacity + 0.01;
        benchmark::DoNotOptimize(cache.update(document, twoThreads));
    }
}
BENCHMARK(opacityOfTheSeventhOfTenLayers)->Arg(1024)->Arg(512)->UseRealTime()->Unit(benchmark::kMillisecond);

} // namespace
} // namespace mirrorball
