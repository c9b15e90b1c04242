#include "picture_file.h"

#include "display_transform.h"
#include "mesh_file.h"
#include "offscreen_context.h"
#include "renderer.h"
#include "scene_settings.h"

#include "core/base/atomic_file.h"
#include "core/image/image_format.h"
#include "core/image/opacity.h"
#include "core/scene/scene_dependencies.h"

#include <algorithm>
#include <utility>

namespace mirrorball::preview {

namespace {

/// Colors that are multiplied by their opacity to such that are not, as 8-bit files have them.
void divideByOpacity(Image& rgba)
{
    for (size_t i = 0; i < rgba.texels.size(); i += 4)
        for (size_t c = 0; c < 3 && rgba.texels[i + 3] > 0.0f; ++c)
            rgba.texels[i + c] = std::min(rgba.texels[i + c] / rgba.texels[i + 3], 1.0f);
}

} // namespace

struct PictureMaker::Kept {
    OffscreenContext context{};
    Renderer renderer{};
    std::optional<Scene> mapsOf{}; ///< of which the maps are
    SceneMaps maps{};
    std::optional<std::filesystem::path> meshFile{};
    std::shared_ptr<const Mesh> mesh{};
};

PictureMaker::PictureMaker() = default;
PictureMaker::~PictureMaker() = default;

Picture PictureMaker::draw(PlannedScene planned, PictureLight light, const JobControl& job)
{
    const Scene& scene = planned.scene;
    WorkRecord record = std::move(planned.record);
    const bool radiance = light == PictureLight::Radiance;
    std::shared_ptr<const DisplayTransform> display;
    if (const auto choice = displayChoice(scene); choice && !radiance)
        display = timedStage(record.stages, "read display configuration", [&] { return displayTransform(*choice); });
    std::shared_ptr<const Mesh> mesh = m_kept ? m_kept->mesh : nullptr;
    const auto file = meshFile(scene);
    if (!mesh || file != m_kept->meshFile)
        mesh = file ? timedStage(record.stages, "read mesh", [&] { return std::make_shared<const Mesh>(readMesh(*file, job)); }) : nullptr;
    const RenderSettings settings = renderSettings(scene, planned.plan, mesh, std::move(display));
    const Scene wanted = mapsOf(scene);
    if (m_kept && m_kept->mapsOf == wanted) {
        record.stages.push_back({.name = "maps", .leftOut = true, .why = "kept: nothing that they depend on has changed"});
    } else {
        m_kept.reset(); // the old maps go before the new ones come
        SceneProbe probe = openProbe(std::move(planned.probe), planned.plan, partOf(job, 0.0f, 0.3f));
        SceneMaps maps = buildMaps(scene, planned.plan, probe, partOf(job, 0.3f, 0.9f));
        record += std::exchange(maps.record, {});
        job.checkStop();
        timedStage(record.stages, "make OpenGL context", [&] { m_kept = std::make_unique<Kept>(); });
        m_kept->mapsOf = wanted;
        m_kept->maps = std::move(maps);
    }
    m_kept->meshFile = file;
    m_kept->mesh = std::move(mesh);
    job.checkStop();
    Image picture = timedStage(record.stages, "draw", [&] {
        const RenderMaps maps = renderMaps(m_kept->maps);
        return radiance ? m_kept->renderer.renderRadiance(settings, maps) : m_kept->renderer.renderDisplay(settings, maps);
    });
    return {.image = std::move(picture), .record = std::move(record)};
}

Picture drawPicture(PlannedScene planned, PictureLight light, const JobControl& job)
{
    return PictureMaker().draw(std::move(planned), light, job);
}

PictureLight lightOf(const std::filesystem::path& path)
{
    return writableFormat(path).samples == StoredSamples::Byte ? PictureLight::Display : PictureLight::Radiance;
}

void writePicture(const std::filesystem::path& path, Image picture, Backdrop background)
{
    const bool radiance = lightOf(path) == PictureLight::Radiance;
    if (background != Backdrop::None || !writableFormat(path).alpha)
        picture = withoutOpacity(picture);
    else if (!radiance)
        divideByOpacity(picture);
    writeImage(path, picture, {.encoding = radiance ? Encoding::Linear : Encoding::Display});
}

WorkRecord savePicture(PictureMaker& maker, PlannedScene planned, const std::filesystem::path& path, const JobControl& job)
{
    const PictureLight light = lightOf(path);
    checkTarget(path);
    const Backdrop background = planned.scene.view.background.kind;
    Picture drawn = maker.draw(std::move(planned), light, job);
    job.checkStop();
    timedStage(drawn.record.stages, "save picture", [&] { writePicture(path, std::move(drawn.image), background); });
    return std::move(drawn.record);
}

WorkRecord savePicture(PlannedScene planned, const std::filesystem::path& path, const JobControl& job)
{
    PictureMaker maker;
    return savePicture(maker, std::move(planned), path, job);
}

} // namespace mirrorball::preview
