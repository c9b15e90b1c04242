#include "engine_scene_export.h"

#include "export.h"
#include "reading_json.h"
#include "scene_maps.h"

#include <cctype>
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

/// The scene's probe as its light is exported: with its exposure, but not yet turned.
Probe exposedProbe(const Scene& scene, ProbeFile& file, const JobControl& job)
{
    Probe probe = file.read(job);
    if (scene.probe.exposure != 0.0)
        for (float& value : probe.map.image.texels)
            value *= static_cast<float>(std::exp2(scene.probe.exposure));
    return probe;
}

} // namespace

EngineEstimate estimateForEngine(const Scene& scene, const EngineProfile& profile, const EngineExportOptions& options,
                                 const JobControl& job)
{
    ProbeFile probe = openProbeFile(scene);
    EngineEstimate estimate{.files = planEngineExport(profile, options, probe.layout())};
    for (const EngineFilePlan& file : estimate.files)
        estimate.bytes += file.bytes;
    estimate.warnings = engineWarnings(profile, statistics(exposedProbe(scene, probe, job).map));
    return estimate;
}

std::string engineExportName(const std::filesystem::path& folder)
{
    const std::filesystem::path whole = std::filesystem::absolute(folder).lexically_normal();
    std::string name = (whole.has_filename() ? whole : whole.parent_path()).filename().string();
    for (char& c : name)
        if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '-' && c != '_')
            c = '_';
    return name.empty() || name.front() == '-' ? "light" : name.substr(0, 100);
}

EngineExport exportForEngine(const Scene& scene, const EngineProfile& profile, EngineExportOptions options,
                             const std::filesystem::path& folder, const JobControl& job)
{
    ProbeFile file = openProbeFile(scene);
    planEngineExport(profile, options, file.layout()); // refuses before any work
    options.yaw = scene.probe.yawDeg * pi / 180.0;
    if (const auto asked = askedOf(scene.probe.reading); !asked.empty())
        options.reading = asked.dump();
    Probe probe = exposedProbe(scene, file, partOf(job, 0.0f, 0.2f));
    FilterSource source(std::move(probe.map), job);
    EngineExport done = exportForEngine(source, profile, options, folder, partOf(job, 0.2f, 1.0f));
    done.stages.insert(done.stages.begin(), probe.stages.begin(), probe.stages.end());
    if (profile.word == "blender" && !scene.material.sphereMap.isNone())
        addMatcap(scene, options.name, folder, job, done);
    return done;
}

} // namespace mirrorball
