#include "scene_maps.h"

#include "plan_words.h"

#include "core/filter/lookup_table.h"
#include "core/filter/source_file.h"
#include "core/image/mip_pyramid.h"
#include "core/image/reproject.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace mirrorball {

namespace {

/// What methods that promise nothing may leave in a map: nine coefficients ring below 0 beside a sun. Empty where there is none.
std::string negativeLightText(const EnvironmentMap& map)
{
    const float least = *std::min_element(map.image.texels.begin(), map.image.texels.end());
    const auto below = std::count_if(map.image.texels.begin(), map.image.texels.end(), [](float value) { return value < 0.0f; });
    if (below == 0)
        return {};
    std::ostringstream text;
    text.precision(3);
    text << "; the map has negative light, down to " << least << " in " << below << " of " << map.image.texels.size()
         << " values: choose another method, such as auto, where that is seen";
    return text.str();
}

WorkRecord workOf(const PrefilterOptions& options, PrefilterOutcome& outcome)
{
    WorkRecord work{.stages = std::move(outcome.stages)};
    if (!outcome.filtered)
        return work;
    work.methods.emplace_back(name(outcome.method));
    work.bandLimit = outcome.bandLimit;
    work.predicted = outcome.predicted;
    if (!outcome.promised)
        work.unpromised.push_back(unpromisedText(options, outcome) + negativeLightText(outcome.map));
    return work;
}

EnvironmentMap buildLevel(const PlannedFilter& planned, const std::string& name, SceneProbe& probe, const JobControl& job,
                          WorkRecord& record)
{
    const PrefilterOptions& filter = planned.options;
    if (!probe.source)
        return timedStage(record.stages, "resample " + name,
                          [&] { return reproject(*probe.environment, {.target = filter.target, .yaw = filter.yaw}, job); });
    PrefilterOutcome outcome = prefilter(*probe.source, filter, job);
    if (outcome.filtered && !outcome.promised) // then what is predicted is all there is to judge it by
        outcome.predicted =
            timedStage(outcome.stages, "error predicted", [&] { return informedErrors(outcome, filter, *probe.source, job); });
    for (Stage& stage : outcome.stages)
        stage.name += " of " + name;
    record += workOf(filter, outcome);
    return std::move(outcome.map);
}

void expose(Image& image, double exposure)
{
    if (exposure == 0.0)
        return;
    const float factor = static_cast<float>(std::exp2(exposure));
    for (float& value : image.texels)
        value *= factor;
}

} // namespace

WorkRecord& WorkRecord::operator+=(WorkRecord more)
{
    stages.insert(stages.end(), std::make_move_iterator(more.stages.begin()), std::make_move_iterator(more.stages.end()));
    for (std::string& method : more.methods)
        if (std::find(methods.begin(), methods.end(), method) == methods.end())
            methods.push_back(std::move(method));
    notes.insert(notes.end(), more.notes.begin(), more.notes.end());
    bandLimit = std::max(bandLimit, more.bandLimit);
    predicted = largest(predicted, more.predicted);
    unpromised.insert(unpromised.end(), std::make_move_iterator(more.unpromised.begin()), std::make_move_iterator(more.unpromised.end()));
    return *this;
}

std::string WorkRecord::methodText() const
{
    std::string text;
    for (const std::string& method : methods)
        text += (text.empty() ? "" : ", ") + method;
    return text;
}

ProbeFile openProbeFile(const Scene& scene) { return ProbeFile(resolved(scene, scene.probe.source), {.reading = scene.probe.reading}); }

MapLayout probeLayout(const Scene& scene) { return openProbeFile(scene).layout(); }

MapLayout probeLayout(const Scene& scene, const PlanRequest& request)
{
    return mayNeedProbe(scene, request) ? probeLayout(scene) : MapLayout{};
}

PlannedScene planScene(Scene scene, const PlanRequest& request)
{
    PlannedScene planned{.scene = std::move(scene)};
    validate(planned.scene);
    if (mayNeedProbe(planned.scene, request))
        planned.probe = openProbeFile(planned.scene);
    planned.plan = timedStage(planned.record.stages, "plan",
                              [&] { return makePlan(planned.scene, planned.probe ? planned.probe->layout() : MapLayout{}, request); });
    return planned;
}

SceneProbe openProbe(std::optional<ProbeFile> file, const Plan& plan, const JobControl& job)
{
    if (!plan.needsProbe())
        return {};
    if (plan.filtersAny()) {
        OpenedSource opened = openFilterSource(*file, plan.filters(), job);
        return {.source = std::move(opened.source),
                .repaired = opened.repaired,
                .origin = opened.origin,
                .record = {.stages = std::move(opened.stages), .notes = std::move(opened.notes)}};
    }
    Probe probe = file->read(job);
    return {.environment = std::make_shared<const EnvironmentMap>(std::move(probe.map)),
            .repaired = probe.repaired,
            .origin = std::move(probe.origin),
            .record = {.stages = std::move(probe.stages), .notes = std::move(probe.notes)}};
}

BuiltMap buildMap(const MapPlan& plan, SceneProbe& probe, double exposure, const JobControl& job)
{
    BuiltMap built;
    std::vector<EnvironmentMap>& levels = built.levels;
    const float parts = static_cast<float>(plan.filters.size() + (plan.pyramid ? 1 : 0));
    for (size_t i = 0; i < plan.filters.size(); ++i)
        levels.push_back(buildLevel(plan.filters[i], plan.filters.size() > 1 ? plan.name + " level " + std::to_string(i) : plan.name, probe,
                                    partOf(job, static_cast<float>(i) / parts, static_cast<float>(i + 1) / parts), built.record));
    if (plan.pyramid)
        levels = timedStage(built.record.stages, "mip levels of " + plan.name, [&] {
            const JobControl last = partOf(job, 1.0f - 1.0f / parts, 1.0f);
            return plan.filtering == MipFiltering::PerFace ? std::move(buildFacePyramid(levels.front(), last).levels)
                                                           : std::move(buildMipPyramid(levels.front(), last).levels);
        });
    for (EnvironmentMap& level : levels)
        expose(level.image, exposure);
    return built;
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

std::shared_ptr<const Image> buildBrdfLookups(const Scene& scene, const BrdfPlan& plan, const JobControl& job)
{
    return std::make_shared<const Image>(makeLookupTable(brdfOf(scene), plan.lookups, plan.columns, job));
}

std::shared_ptr<const ViewStack> buildViewStack(const Scene& scene, const BrdfPlan& plan, SceneProbe& probe, WorkRecord& record,
                                                const JobControl& job)
{
    return timedStage(record.stages, "exact BRDF maps", [&] {
        auto stack =
            std::make_shared<ViewStack>(makeViewStack(*probe.source, brdfOf(scene), {.tolerance = plan.tolerance, .yaw = plan.yaw}, job));
        for (Image& layer : stack->layers)
            expose(layer, scene.probe.exposure);
        if (stack->tolerance > plan.tolerance)
            record.unpromised.push_back(text(plan.model, ": its exact maps would be too large for a tolerance of ", plan.tolerance,
                                             "; rel_rms is about ", stack->predictedError));
        return stack;
    });
}

SceneMaps buildMaps(const Scene& scene, const Plan& plan, SceneProbe& probe, const JobControl& job)
{
    SceneMaps maps{.record = probe.record};
    const auto build = [&](const MapPlan& map) {
        BuiltMap built = buildMap(map, probe, scene.probe.exposure, job);
        maps.record += std::move(built.record);
        return std::make_shared<const std::vector<EnvironmentMap>>(std::move(built.levels));
    };
    const auto read = [&](const std::optional<SurfacePicturePlan>& picture) {
        return picture ? timedStage(maps.record.stages, "read " + picture->name, [&] { return readSurfacePicture(scene, *picture, job); })
                       : nullptr;
    };
    maps.diffusePicture = read(plan.diffusePicture); // first: a name that is mistyped is told before anything is filtered
    maps.fleckPattern = read(plan.fleckPattern);
    maps.normalMap = read(plan.normalMap);
    if (plan.specular)
        maps.specular = build(*plan.specular);
    if (plan.isExact())
        maps.viewStack = buildViewStack(scene, *plan.brdf, probe, maps.record, job);
    else if (plan.brdf)
        maps.brdfLookups = timedStage(maps.record.stages, "BRDF lookups", [&] { return buildBrdfLookups(scene, *plan.brdf, job); });
    if (plan.diffuse)
        maps.diffuse = build(*plan.diffuse);
    if (plan.clearCoat)
        maps.clearCoat = build(*plan.clearCoat);
    if (plan.background)
        maps.background = build(*plan.background);
    for (const SphereMapPlan& map : plan.sphereMaps)
        maps.sphereMaps.push_back(timedStage(maps.record.stages, "sphere map " + map.source,
                                             [&] { return std::make_shared<const SphereMapTexels>(buildSphereMap(scene, map, job)); }));
    for (const MapPlan& map : plan.others)
        maps.others.push_back(build(map));
    return maps;
}

SceneMaps buildMaps(PlannedScene planned, const JobControl& job)
{
    SceneProbe probe = openProbe(std::move(planned.probe), planned.plan, job);
    return buildMaps(planned.scene, planned.plan, probe, job);
}

} // namespace mirrorball
