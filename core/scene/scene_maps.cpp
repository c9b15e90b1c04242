#include "scene_maps.h"

#include "core/filter/source_file.h"
#include "core/image/builtin_probes.h"
#include "core/image/layout_detection.h"
#include "core/image/map_file.h"
#include "core/image/mip_pyramid.h"
#include "core/image/reproject.h"

#include <algorithm>
#include <cmath>

namespace mirrorball {

namespace {

EnvironmentMap buildLevel(const PrefilterOptions& filter, const std::string& name, SceneProbe& probe, const JobControl& job,
                          WorkRecord& record)
{
    if (!probe.source)
        return timedStage(record.stages, "resample " + name,
                          [&] { return reproject(*probe.environment, {.target = filter.target, .yaw = filter.yaw}, job); });
    PrefilterOutcome outcome = prefilter(*probe.source, filter, job);
    for (Stage& stage : outcome.stages) {
        stage.name += " of " + name;
        record.stages.push_back(std::move(stage));
    }
    record.add(outcome);
    return std::move(outcome.map);
}

void expose(std::vector<EnvironmentMap>& levels, double exposure)
{
    if (exposure == 0.0)
        return;
    const float factor = static_cast<float>(std::exp2(exposure));
    for (EnvironmentMap& level : levels)
        for (float& value : level.image.texels)
            value *= factor;
}

} // namespace

void WorkRecord::add(const PrefilterOutcome& outcome)
{
    if (!outcome.filtered)
        return;
    if (const std::string_view ran = name(outcome.method); method.find(ran) == std::string::npos)
        method += (method.empty() ? "" : ", ") + std::string(ran);
    bandLimit = std::max(bandLimit, outcome.bandLimit);
    predicted = largest(predicted, {outcome.predictedError, outcome.predictedMedianRel, outcome.predictedP99Rel});
    promised = promised && outcome.promised;
}

MapLayout probeLayout(const Scene& scene)
{
    const std::string path = resolved(scene, scene.probe.source);
    if (path.starts_with("builtin:")) {
        builtinProbe(std::string_view(path).substr(8)); // says when there is none of that name
        return builtinProbeLayout;
    }
    return detectLayout(openImage(path)->info(), scene.probe.parameterization).layout;
}

MapLayout probeLayout(const Scene& scene, const PlanRequest& request)
{
    return mayNeedProbe(scene, request) ? probeLayout(scene) : MapLayout{};
}

SceneProbe openProbe(const Scene& scene, const Plan& plan, const JobControl& job, WorkRecord& record)
{
    if (!plan.needsProbe())
        return {};
    const std::string path = resolved(scene, scene.probe.source);
    const ReadProbeOptions options{.from = scene.probe.parameterization};
    if (plan.filtersAny()) {
        OpenedSource opened = openFilterSource(path, options, plan.filters(), job, record.stages);
        return {.source = std::move(opened.source), .repaired = opened.repaired, .origin = opened.origin};
    }
    Probe probe = readProbe(path, options, job, record.stages);
    return {.environment = std::make_shared<const EnvironmentMap>(std::move(probe.map)),
            .repaired = probe.repaired,
            .origin = std::move(probe.origin)};
}

std::vector<EnvironmentMap> buildMap(const MapPlan& plan, SceneProbe& probe, double exposure, const JobControl& job, WorkRecord& record)
{
    std::vector<EnvironmentMap> levels;
    const float parts = static_cast<float>(plan.filters.size() + (plan.pyramid ? 1 : 0));
    for (size_t i = 0; i < plan.filters.size(); ++i)
        levels.push_back(buildLevel(plan.filters[i], plan.filters.size() > 1 ? plan.name + " level " + std::to_string(i) : plan.name, probe,
                                    partOf(job, static_cast<float>(i) / parts, static_cast<float>(i + 1) / parts), record));
    if (plan.pyramid)
        levels = timedStage(record.stages, "mip levels of " + plan.name, [&] {
            const JobControl last = partOf(job, 1.0f - 1.0f / parts, 1.0f);
            return plan.filtering == MipFiltering::PerFace ? std::move(buildFacePyramid(levels.front(), last).levels)
                                                           : std::move(buildMipPyramid(levels.front(), last).levels);
        });
    expose(levels, exposure);
    return levels;
}

SphereMapDocument sphereMapDocument(const Scene& scene, const SphereMapPlan& plan)
{
    return plan.document ? *plan.document.document : readSphereMapDocument(scene, plan.field, plan.source);
}

SphereMapTexels buildSphereMap(const Scene& scene, const SphereMapPlan& plan, const JobControl& job)
{
    return plan.document ? sphereMapTexels(*plan.document.document, plan.size, plan.levels, job)
                         : readSphereMap(scene, plan.field, plan.source, plan.size, plan.levels, job);
}

std::vector<SphereMapChain> buildSphereMaps(const Scene& scene, const Plan& plan, const JobControl& job, WorkRecord& record)
{
    std::vector<SphereMapChain> maps;
    for (const SphereMapPlan& map : plan.sphereMaps)
        maps.push_back(timedStage(record.stages, "sphere map " + map.source,
                                  [&] { return std::make_shared<const SphereMapTexels>(buildSphereMap(scene, map, job)); }));
    return maps;
}

SceneMaps buildMaps(const Scene& scene, const Plan& plan, SceneProbe& probe, const JobControl& job, WorkRecord& record)
{
    const auto build = [&](const std::optional<MapPlan>& map) {
        return map ? std::make_shared<const std::vector<EnvironmentMap>>(buildMap(*map, probe, scene.probe.exposure, job, record))
                   : nullptr;
    };
    SceneMaps maps{.specular = build(plan.specular), .diffuse = build(plan.diffuse), .background = build(plan.background)};
    maps.sphereMaps = buildSphereMaps(scene, plan, job, record);
    for (const MapPlan& map : plan.others)
        maps.others.push_back(build(map));
    return maps;
}

} // namespace mirrorball
