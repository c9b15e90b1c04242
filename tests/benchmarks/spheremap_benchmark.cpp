#include "core/spheremap/document/presets.h"
#include "core/spheremap/evaluation/evaluate.h"

#include <benchmark/benchmark.h>

#include <cmath>
#include <random>

/// Times of evaluating sphere maps on two threads.
namespace mirrorball {
namespace {

const JobControl twoThreads{.threads = 2};

/// Ten layers of every sort that works point by point, one of them painted with `strokes` short strokes of 2 to 5 % of the disc.
SphereMapDocument tenLayers(int strokes)
{
    std::mt19937 engine(5);
    const auto uniform = [&engine](double low, double high) { return low + (high - low) * static_cast<double>(engine()) / 4294967296.0; };
    PaintLayer paint;
    for (int i = 0; i < strokes; ++i) {
        Stroke stroke;
        stroke.brush.color = {uniform(0, 1), uniform(0, 1), uniform(0, 1)};
        stroke.brush.radius = uniform(0.02, 0.05);
        const double angle = uniform(0, 2 * pi), far = 0.9 * std::sqrt(uniform(0, 1)), turn = uniform(0, 2 * pi);
        glm::dvec2 q(far * std::cos(angle), far * std::sin(angle));
        for (int k = 0; k < 8; ++k) {
            stroke.points.push_back({q, 0.5 + 0.5 * std::sin(k)});
            q += 0.03 * glm::dvec2(std::cos(turn + 0.2 * k), std::sin(turn + 0.2 * k));
        }
        paint.strokes.push_back(stroke);
    }
    SphereMapDocument document;
    document.layers = {{.content = GradientLayer{}},
                       {.blend = BlendMode::Screen, .content = GradientLayer{.shape = GradientShape::Radial}},
                       {.opacity = 0.6, .blend = BlendMode::SoftLight, .content = ToonLayer{}},
                       {.blend = BlendMode::Add, .content = PhongLightsLayer{}},
                       {.opacity = 0.5, .content = WindowLayer{}},
                       {.opacity = 0.7, .blend = BlendMode::Multiply, .content = ColorgramLayer{}},
                       {.content = HueSaturationLayer{.hueDeg = 20.0}},
                       {.content = paint},
                       {.opacity = 0.5, .content = HatchingLayer{}},
                       {.content = SilhouetteLayer{}}};
    return document;
}

void tenLayersWith200Strokes(benchmark::State& state)
{
    const SphereMapDocument document = tenLayers(200);
    const EvaluateOptions options{.size = static_cast<int>(state.range(0)), .assets = std::make_shared<SphereMapAssets>()};
    for (auto _ : state)
        benchmark::DoNotOptimize(evaluate(document, options, twoThreads));
}
BENCHMARK(tenLayersWith200Strokes)->Arg(256)->Arg(512)->Arg(1024)->UseRealTime()->MeasureProcessCPUTime()->Unit(benchmark::kMillisecond);

/// Each layer of the document by itself, at 1024: where the time goes.
void oneLayer(benchmark::State& state)
{
    SphereMapDocument document = tenLayers(200);
    document.layers = {{.content = FillLayer{}}, document.layers[static_cast<size_t>(state.range(0))]};
    state.SetLabel(std::string(kindOf(document.layers[1].content).name));
    for (auto _ : state)
        benchmark::DoNotOptimize(evaluate(document, {.size = 1024}, twoThreads));
}
BENCHMARK(oneLayer)->DenseRange(0, 9)->UseRealTime()->MeasureProcessCPUTime()->Unit(benchmark::kMillisecond);

/// @param index  of the map, whose mirror directions are twice as many as normals
void blurOnTheSphere(benchmark::State& state, SphereMapIndex index)
{
    SphereMapDocument document;
    document.index = index;
    document.layers = {{.content = WindowLayer{}}, {.content = BlurLayer{.sigmaDeg = static_cast<double>(state.range(0))}}};
    for (auto _ : state)
        benchmark::DoNotOptimize(evaluate(document, {.size = 1024}, twoThreads));
}
BENCHMARK_CAPTURE(blurOnTheSphere, byNormal, SphereMapIndex::Normal)
    ->Arg(1)
    ->Arg(2)
    ->Arg(4)
    ->Arg(16)
    ->UseRealTime()
    ->MeasureProcessCPUTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(blurOnTheSphere, byReflection, SphereMapIndex::Reflection)
    ->Arg(1)
    ->Arg(2)
    ->Arg(4)
    ->Arg(16)
    ->UseRealTime()
    ->MeasureProcessCPUTime()
    ->Unit(benchmark::kMillisecond);

/// What a stroke of 64 texels costs: the part of the map that it touched.
void regionOf64(benchmark::State& state)
{
    const SphereMapDocument document = tenLayers(200);
    for (auto _ : state)
        benchmark::DoNotOptimize(evaluate(document, {.size = 1024, .region = TexelRect{480, 480, 544, 544}}, twoThreads));
}
BENCHMARK(regionOf64)->UseRealTime()->MeasureProcessCPUTime()->Unit(benchmark::kMillisecond);

/// The hand-made levels of a silhouette in pixels, 1024 down to 1.
void authoredLevels(benchmark::State& state)
{
    const SphereMapPreset* preset = findSphereMapPreset("silhouette");
    for (auto _ : state)
        benchmark::DoNotOptimize(evaluateLevels(preset->document, 1024, twoThreads));
}
BENCHMARK(authoredLevels)->UseRealTime()->MeasureProcessCPUTime()->Unit(benchmark::kMillisecond);

/// Every preset, probes filtered once before.
void presets(benchmark::State& state)
{
    const SphereMapPreset& preset = sphereMapPresets()[static_cast<size_t>(state.range(0))];
    state.SetLabel(preset.name);
    const EvaluateOptions options{.size = 512, .assets = std::make_shared<SphereMapAssets>()};
    benchmark::DoNotOptimize(evaluate(preset.document, options, twoThreads));
    for (auto _ : state)
        benchmark::DoNotOptimize(evaluate(preset.document, options, twoThreads));
}
BENCHMARK(presets)
    ->DenseRange(0, static_cast<int64_t>(sphereMapPresets().size()) - 1)
    ->UseRealTime()
    ->MeasureProcessCPUTime()
    ->Unit(benchmark::kMillisecond);

} // namespace
} // namespace mirrorball
