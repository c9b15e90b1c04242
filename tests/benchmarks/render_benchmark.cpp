#include "core/filter/prefilter.h"
#include "core/image/builtin_probes.h"
#include "core/preview/offscreen_context.h"
#include "core/preview/renderer.h"

#include <benchmark/benchmark.h>

/// Frames of the preview at 1280 x 720 with 4 samples a pixel, after the first: a glossy teapot, or one of car paint (a glossy coat
/// by Fresnel over a diffuse map) before its environment. The camera turns, so that no frame repeats the last.
namespace mirrorball::preview {
namespace {

MapLevels levelsOf(EnvironmentMap map)
{
    return std::make_shared<const std::vector<EnvironmentMap>>(std::vector<EnvironmentMap>{std::move(map)});
}

void frames(benchmark::State& state, GeometryKind geometry, Parameterization kind, bool coat)
{
    OffscreenContext context;
    Renderer renderer;
    FilterSource source(renderBuiltinProbe("studio"));
    const MapLayout layout{kind, kind == Parameterization::Cube ? 256 : 512, 0};
    const RenderMaps maps{.specular = levelsOf(prefilter(source, {.lobe = phongLobe(500), .target = layout}).map),
                          .diffuse = levelsOf(prefilter(source, {.lobe = diffuseLobe(), .target = layout}).map),
                          .background = levelsOf(renderBuiltinProbe("studio", layout))};
    RenderSettings settings;
    settings.geometry = {.kind = geometry, .level = 9}; // what `render` chooses for 720 rows
    if (coat) {
        settings.material = {.diffuse = glm::vec3(0.7f, 0.05f, 0.05f), .combine = Combine::Coat};
        settings.material.fresnel = {.kind = FresnelKind::Dielectric, .index = 1.5};
    }
    benchmark::DoNotOptimize(renderer.renderDisplay(settings, maps));
    for (auto _ : state) {
        settings.camera.yaw += 0.01f;
        benchmark::DoNotOptimize(renderer.renderDisplay(settings, maps)); // reading back included
    }
}
BENCHMARK_CAPTURE(frames, teapot_glossy_cube, GeometryKind::Teapot, Parameterization::Cube, false)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(frames, teapot_coat_cube, GeometryKind::Teapot, Parameterization::Cube, true)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(frames, teapot_coat_paraboloid, GeometryKind::Teapot, Parameterization::Paraboloid, true)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(frames, torus_coat_cube, GeometryKind::Torus, Parameterization::Cube, true)->UseRealTime()->Unit(benchmark::kMillisecond);

} // namespace
} // namespace mirrorball::preview
