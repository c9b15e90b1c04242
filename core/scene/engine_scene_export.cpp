#include "engine_scene_export.h"

#include "export.h"
#include "scene_maps.h"

#include <cmath>

namespace mirrorball {

namespace {

/// Border that keeps Blender's bilinear lookups inside the picture.
constexpr int matcapBorder = 2;

void addMatcap(const Scene& scene, const std::string& name, const std::filesystem::path& folder, const JobControl& job, EngineExport& done)
{
    Scene painted = scene;
    painted.exports = {{.name = name, .kind = ExportKind::Painted, .size = 512, .border = matcapBorder, .half = true}};
    ExportOutcome outcome = exportScene(painted, folder / "studiolights" / "matcap", {}, job);
    done.files.insert(done.files.end(), outcome.files.begin(), outcome.files.end());
    done.stages.insert(done.stages.end(), outcome.record.stages.begin(), outcome.record.stages.end());
}

} // namespace

EngineExport exportForEngine(const Scene& scene, const EngineProfile& profile, EngineExportOptions options,
                             const std::filesystem::path& folder, const JobControl& job)
{
    ProbeFile file = openProbeFile(scene);
    planEngineExport(profile, options, file.layout()); // refuses before any work
    options.yaw = scene.probe.yawDeg * pi / 180.0;
    Probe probe = file.read(partOf(job, 0.0f, 0.2f));
    if (scene.probe.exposure != 0.0)
        for (float& value : probe.map.image.texels)
            value *= static_cast<float>(std::exp2(scene.probe.exposure));
    FilterSource source(std::move(probe.map), job);
    EngineExport done = exportForEngine(source, profile, options, folder, partOf(job, 0.2f, 1.0f));
    done.stages.insert(done.stages.begin(), probe.stages.begin(), probe.stages.end());
    if (profile.word == "blender" && !scene.material.sphereMap.isNone())
        addMatcap(scene, options.name, folder, job, done);
    return done;
}

} // namespace mirrorball
