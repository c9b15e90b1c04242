#include "gl_fixture.h"

#include "core/preview/renderer.h"
#include "core/preview/scene_settings.h"
#include "core/scene/material_presets.h"
#include "core/scene/scene_maps.h"

using namespace mirrorball;
using namespace mirrorball::preview;
using namespace mirrorball::test;

using PlanExtentTest = mirrorball::test::GlTest;

namespace {

Image picture(const Scene& scene, PlanExtent extent)
{
    PlannedScene planned = planScene(scene, {.extent = extent});
    const RenderSettings settings = renderSettings(scene, planned.plan);
    Renderer renderer(TexelFormat::Float);
    return renderer.renderRadiance(settings, renderMaps(buildMaps(std::move(planned))));
}

} // namespace

// Leaving out what a scene does not need may not show: the picture is that of everything made. Mips are asked for by both, since a
// picture that reads coarser levels is another one.
TEST_F(PlanExtentTest, LeavingOutChangesNoPicture)
{
    for (const char* name : {"mirror", "car-paint", "clay", "gold"}) {
        const MaterialPreset* preset = findMaterialPreset(name);
        if (!preset)
            continue;
        Scene scene;
        scene.material = preset->material;
        scene.map.size = 64;
        scene.map.mips = true;
        scene.view.width = 96;
        scene.view.height = 72;
        scene.view.geometry = "sphere";
        scene.view.background.kind = Backdrop::Color;
        const Image needed = picture(scene, PlanExtent::Needed), all = picture(scene, PlanExtent::Everything);
        double difference = 0.0, power = 0.0;
        for (size_t i = 0; i < needed.texels.size(); ++i) {
            difference += std::pow(needed.texels[i] - all.texels[i], 2.0);
            power += std::pow(needed.texels[i], 2.0);
        }
        EXPECT_LT(std::sqrt(difference / power), 2e-3) << name; // maps of smooth lobes are smaller
    }
}
