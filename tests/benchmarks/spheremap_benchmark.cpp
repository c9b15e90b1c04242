#include "core/spheremap/document/presets.h"
#include "core/spheremap/evaluation/painted_files.h"
#include "core/spheremap/evaluation/sphere_map_cache.h"

#include <benchmark/benchmark.h>

#include <cmath>
#include <filesystem>
#include <random>

#include <sys/resource.h>

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

/// A parameter of each layer of the document, dragged on a map of 1024: its content where the second argument is 1, its opacity where 0.
/// The third is the size that the picture shows, and of which the map is made until the drag ends.
void dragged(benchmark::State& state)
{
    SphereMapDocument document = tenLayers(200);
    Layer& layer = document.layers[static_cast<size_t>(state.range(0))];
    state.SetLabel(std::string(kindOf(layer.content).name));
    SphereMapCache cache({.size = static_cast<int>(state.range(2)), .levelSize = 1024, .assets = std::make_shared<SphereMapAssets>()});
    double turn = 0.0;
    const auto step = [&] {
        turn = turn < 90.0 ? turn + 1.0 : 0.0;
        if (state.range(1) == 0) {
            layer.opacity = 0.5 + turn / 180.0;
            return;
        }
        std::visit(
            [turn](auto& content) {
                if constexpr (requires { content.azimuthDeg; })
                    content.azimuthDeg = turn;
                else if constexpr (requires { content.angleDeg; })
                    content.angleDeg = turn;
                else if constexpr (requires { content.hueDeg; })
                    content.hueDeg = turn;
                else if constexpr (requires { content.lights; })
                    content.lights.front().azimuthDeg = turn;
                else if constexpr (requires { content.width; })
                    content.width = 0.05 + 0.001 * turn;
            },
            layer.content);
    };
    for (int i = 0; i < 3; ++i) { // builds what a drag needs
        cache.update(document, twoThreads);
        step();
    }
    for (auto _ : state) {
        benchmark::DoNotOptimize(cache.update(document, twoThreads));
        step();
    }
}
BENCHMARK(dragged)
    ->ArgsProduct({benchmark::CreateDenseRange(0, 9, 1), {0, 1}, {1024, 512}})
    ->UseRealTime()
    ->MeasureProcessCPUTime()
    ->Unit(benchmark::kMillisecond);

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

/// The map as an .exr of so many texels, floats: made and written band by band; and the most memory that the process held.
void exported(benchmark::State& state)
{
    const SphereMapDocument document = tenLayers(200);
    const std::filesystem::path file = std::filesystem::temp_directory_path() / "spheremap_benchmark.exr";
    for (auto _ : state)
        writePainted(file, document, {.size = static_cast<int>(state.range(0))}, SampleType::Float, twoThreads);
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    state.counters["peak_MB"] = static_cast<double>(usage.ru_maxrss) / 1024.0;
    state.counters["file_MB"] = static_cast<double>(std::filesystem::file_size(file)) / 1048576.0;
    std::filesystem::remove(file);
}
BENCHMARK(exported)->Arg(2048)->Arg(8192)->UseRealTime()->MeasureProcessCPUTime()->Unit(benchmark::kMillisecond);

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
