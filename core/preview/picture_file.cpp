#include "picture_file.h"

#include "display_transform.h"
#include "mesh_file.h"
#include "offscreen_context.h"
#include "renderer.h"
#include "scene_settings.h"

#include "core/base/atomic_file.h"
#include "core/image/image_format.h"
#include "core/image/opacity.h"

#include <algorithm>

namespace mirrorball::preview {

namespace {

/// Colours that are multiplied by their opacity to such that are not, as 8-bit files have them.
void divideByOpacity(Image& rgba)
{
    for (size_t i = 0; i < rgba.texels.size(); i += 4)
        for (size_t c = 0; c < 3 && rgba.texels[i + 3] > 0.0f; ++c)
            rgba.texels[i + c] = std::min(rgba.texels[i + c] / rgba.texels[i + 3], 1.0f);
}

} // namespace

Picture drawPicture(PlannedScene planned, PictureLight light, const JobControl& job)
{
    const Scene& scene = planned.scene;
    WorkRecord record = std::move(planned.record);
    const bool radiance = light == PictureLight::Radiance;
    std::shared_ptr<const DisplayTransform> display;
    if (const auto choice = displayChoice(scene); choice && !radiance)
        display = timedStage(record.stages, "read display configuration", [&] { return displayTransform(*choice); });
    std::shared_ptr<const Mesh> mesh;
    if (const auto file = meshFile(scene))
        mesh = timedStage(record.stages, "read mesh", [&] { return std::make_shared<const Mesh>(readMesh(*file, job)); });
    const RenderSettings settings = renderSettings(scene, planned.plan, std::move(mesh), std::move(display));
    SceneProbe probe = openProbe(std::move(planned.probe), planned.plan, partOf(job, 0.0f, 0.3f));
    SceneMaps made = buildMaps(scene, planned.plan, probe, partOf(job, 0.3f, 0.9f));
    record += std::move(made.record);
    const RenderMaps maps = renderMaps(made);
    job.checkStop();
    Image picture = timedStage(record.stages, "draw", [&] {
        OffscreenContext context;
        Renderer renderer;
        return radiance ? renderer.renderRadiance(settings, maps) : renderer.renderDisplay(settings, maps);
    });
    return {.image = std::move(picture), .record = std::move(record)};
}

WorkRecord savePicture(PlannedScene planned, const std::filesystem::path& path, const JobControl& job)
{
    const ImageFormat& format = writableFormat(path);
    const bool radiance = format.samples != StoredSamples::Byte;
    checkTarget(path);
    const bool keepsOpacity = planned.scene.view.background.kind == Backdrop::None && format.alpha;
    Picture drawn = drawPicture(std::move(planned), radiance ? PictureLight::Radiance : PictureLight::Display, job);
    if (!keepsOpacity)
        drawn.image = withoutOpacity(drawn.image);
    else if (!radiance)
        divideByOpacity(drawn.image);
    job.checkStop();
    timedStage(drawn.record.stages, "save picture",
               [&] { writeImage(path, drawn.image, {.encoding = radiance ? Encoding::Linear : Encoding::Display}); });
    return std::move(drawn.record);
}

} // namespace mirrorball::preview
