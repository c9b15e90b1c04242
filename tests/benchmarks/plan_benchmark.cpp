#include "core/preview/offscreen_context.h"
#include "core/preview/renderer.h"
#include "core/preview/scene_settings.h"
#include "core/scene/scene_maps.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <fstream>
#include <string>

#include <malloc.h>

/// What leaving out saves: five scenes from nothing to a picture of 640 x 360, once as planned and once with every stage forced on
/// (PlanExtent::Everything). Time is wall time of reading, filtering, uploading, compiling shaders and drawing, and the CPU time of all
/// threads; memory is the highest resident size above the start, textures included, because the renderer is a software one.
namespace mirrorball::preview {
namespace {

Scene base()
{
    Scene scene;
    scene.probe.source = "builtin:sky";
    scene.map.size = 256;
    scene.view.width = 640;
    scene.view.height = 360;
    return scene;
}

Scene mirrorOnly() { return base(); }

Scene diffuseOnly()
{
    Scene scene = base();
    scene.material.specular.weight = 0.0;
    scene.material.diffuse.weight = 1.0;
    return scene;
}

Scene glossyWithoutFresnel()
{
    Scene scene = base();
    scene.material.specular = {.lobe = SurfaceLobe::Phong, .exponent = 50.0};
    return scene;
}

Scene fullCoat()
{
    Scene scene = glossyWithoutFresnel();
    scene.material.specular.exponent = 500.0;
    scene.material.fresnel = {.kind = FresnelKind::Dielectric, .index = 1.5};
    scene.material.combine = Combine::Coat;
    scene.material.diffuse.weight = 1.0;
    scene.map.mips = true;
    return scene;
}

Scene paintedSphereMap()
{
    Scene scene = base();
    scene.material.sphereMap.source = "studio-clay";
    scene.view.background.kind = Backdrop::Color;
    return scene;
}

double kilobytes(const std::string& field)
{
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);)
        if (line.starts_with(field))
            return std::stod(line.substr(field.size() + 1));
    return 0.0;
}

/// @return the plan that was followed
Plan makePicture(const Scene& scene, PlanExtent extent)
{
    const JobControl job{.threads = 2};
    PlannedScene planned = planScene(scene, {.extent = extent});
    Plan plan = planned.plan;
    const SceneMaps maps = buildMaps(std::move(planned), job);
    const OffscreenContext context;
    Renderer renderer;
    benchmark::DoNotOptimize(renderer.renderDisplay(renderSettings(scene, plan), renderMaps(maps)));
    return plan;
}

void pictureOf(benchmark::State& state, Scene (*make)(), PlanExtent extent)
{
    static const Plan warmUp = makePicture(mirrorOnly(), PlanExtent::Needed); // a process loads its graphics driver once
    const Scene scene = make();
    double peak = 0.0;
    Plan plan;
    for (auto _ : state) {
        state.PauseTiming();
        malloc_trim(0);
        std::ofstream("/proc/self/clear_refs") << "5"; // the high-water mark falls to what is resident now
        const double before = kilobytes("VmRSS:");
        state.ResumeTiming();

        plan = makePicture(scene, extent);

        state.PauseTiming();
        peak = std::max(peak, kilobytes("VmHWM:") - before);
        state.ResumeTiming();
    }
    const auto leftOut =
        std::count_if(plan.decisions.begin(), plan.decisions.end(), [](const PlannedStage& stage) { return stage.isLeftOut; });
    state.counters["peak_MB"] = peak / 1024.0;
    state.counters["stages"] = static_cast<double>(plan.decisions.size()) - static_cast<double>(leftOut);
    state.counters["left_out"] = static_cast<double>(leftOut);
}

#define SCENE(name)                                                                                                                        \
    BENCHMARK_CAPTURE(pictureOf, name, name, PlanExtent::Needed)->MeasureProcessCPUTime()->UseRealTime()->Unit(benchmark::kMillisecond);   \
    BENCHMARK_CAPTURE(pictureOf, name##_everything, name, PlanExtent::Everything)                                                          \
        ->MeasureProcessCPUTime()                                                                                                          \
        ->UseRealTime()                                                                                                                    \
        ->Unit(benchmark::kMillisecond)
SCENE(mirrorOnly);
SCENE(diffuseOnly);
SCENE(glossyWithoutFresnel);
SCENE(fullCoat);
SCENE(paintedSphereMap);

} // namespace
} // namespace mirrorball::preview
