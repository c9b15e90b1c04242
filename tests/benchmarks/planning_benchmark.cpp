#include "core/scene/plan.h"

#include <benchmark/benchmark.h>

/// What planning a scene costs while a slider is dragged: every step plans anew. CPU time of one thread.
namespace mirrorball {
namespace {

const MapLayout probe{Parameterization::Latlong, 512, 0};

/// A lobe that moves a little from step to step, so that nothing could be kept from the last one.
void planning(benchmark::State& state, const SpecularSettings& from, const PlanRequest& request)
{
    Scene scene;
    scene.material.specular = from;
    scene.material.diffuse.weight = 0.5;
    scene.exports = {{.name = "chain", .kind = ExportKind::Chain, .size = 256}};
    int step = 0;
    for (auto _ : state) {
        const double moved = 1.0 + 1e-4 * (++step % 1000);
        scene.material.specular.exponent = from.exponent * moved;
        scene.material.specular.roughness = from.roughness / moved;
        benchmark::DoNotOptimize(makePlan(scene, probe, request));
    }
}

const PlanRequest dragged{.detail = coarseDetail}, whole{};
const PlanRequest exported{.picture = false, .exports = std::vector<std::string>{}};

BENCHMARK_CAPTURE(planning, phong_50, SpecularSettings{.lobe = SurfaceLobe::Phong, .exponent = 50.0}, dragged)
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(planning, phong_50_whole, SpecularSettings{.lobe = SurfaceLobe::Phong, .exponent = 50.0}, whole)
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(planning, phong_1, SpecularSettings{.lobe = SurfaceLobe::Phong, .exponent = 1.0}, dragged)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(planning, ggx_0_6, SpecularSettings{.lobe = SurfaceLobe::Ggx, .roughness = 0.6}, dragged)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(planning, ggx_0_3, SpecularSettings{.lobe = SurfaceLobe::Ggx, .roughness = 0.3}, dragged)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(planning, ggx_0_3_whole, SpecularSettings{.lobe = SurfaceLobe::Ggx, .roughness = 0.3}, whole)
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(planning, ggx_0_1, SpecularSettings{.lobe = SurfaceLobe::Ggx, .roughness = 0.1}, dragged)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(planning, ggx_0_1_whole, SpecularSettings{.lobe = SurfaceLobe::Ggx, .roughness = 0.1}, whole)
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(planning, export_of_a_chain, SpecularSettings{}, exported)->Unit(benchmark::kMicrosecond);

} // namespace
} // namespace mirrorball
