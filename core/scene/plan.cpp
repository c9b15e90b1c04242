#include "planner.h"

#include "core/filter/source_file.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace mirrorball {

Plan Planner::make(const PlanRequest& request)
{
    m_extent = request.extent;
    m_detail = request.detail;
    m_plan.material = planMaterial(m_scene.material, m_extent);
    if (request.picture)
        planPicture();
    if (request.exports)
        planExports(*request.exports);
    planReading();
    return std::move(m_plan);
}

void Planner::need(std::string name, Decision why, const StageCost& cost)
{
    m_later.push_back({.name = std::move(name), .why = std::move(why), .expected = cost});
}

void Planner::leaveOut(std::string name, Decision why)
{
    m_later.push_back({.name = std::move(name), .isLeftOut = true, .why = std::move(why)});
}

LevelChoice Planner::chooseMethod(PrefilterOptions& filter) const
{
    const FilterSettings& chosen = m_scene.filter;
    filter.tolerance = chosen.tolerance;
    filter.knobs = chosen.knobs();
    if (chosen.method == Method::Auto || filter.lobe.isMirror())
        return {};
    PrefilterOptions asked = filter;
    asked.method = chosen.method;
    LevelChoice choice{.asked = chosen.method, .refusal = refusal(chosen.method, asked, {.width = probeWidth()})};
    if (choice.refusal.empty())
        filter.method = chosen.method;
    return choice;
}

void Planner::addLevel(MapPlan& map, PlannedFilter planned, const std::string& name, const LevelChoice& choice,
                       std::optional<Because> whyMirror)
{
    const PrefilterOptions& filter = planned.options;
    if (planned.plan.filtered) {
        need("filter " + name, FiltersLevel{planned, choice}, planned.filtering);
    } else {
        if (!filter.lobe.isMirror())
            leaveOut("filter " + name, LooksUp{planned.plan});
        else if (whyMirror)
            leaveOut("filter " + name, *whyMirror);
        const bool same = filter.target == m_probe && filter.yaw == 0.0;
        if (same)
            leaveOut("resample " + name, IsProbeAlready{m_probe});
        else
            need("resample " + name, ResamplesLevel{m_probe, filter.target, choice}, resamplingCost(m_probe, filter.target));
    }
    map.filters.push_back(std::move(planned));
}

void Planner::planReading()
{
    const bool builtin = m_scene.probe.source.starts_with("builtin:");
    const std::string read = builtin ? "compute probe" : "read probe";
    std::vector<PlannedStage>& stages = m_plan.decisions;
    if (!m_plan.needsProbe()) {
        stages.push_back({.name = read, .isLeftOut = true, .why = Because::NoMapIsNeeded});
    } else {
        const std::vector<const PlannedFilter*> filters = m_plan.planned();
        int filtered = 0, spectral = 0, bandLimit = 0;
        StageCost transform;
        for (const PlannedFilter* filter : filters) {
            const PrefilterPlan& prediction = filter->plan;
            filtered += prediction.filtered;
            if (prediction.filtered && prediction.method == Method::Spectral) {
                ++spectral;
                if (prediction.bandLimit >= bandLimit)
                    transform = filter->spectrum;
            }
            bandLimit = std::max(bandLimit, prediction.filtered ? prediction.bandLimit : 0);
        }
        if (m_plan.isExact()) // whatever its orders and views, of one spectrum
            ++spectral;
        const bool large = std::int64_t{m_probe.width()} * m_probe.height() > streamedFrom;
        const bool streamed =
            large && m_probe.kind == Parameterization::Latlong && !builtin && filtered == static_cast<int>(filters.size());
        ReadsProbe how{.source = m_scene.probe.source, .layout = m_probe, .isLargeAndWhole = large && !streamed};
        if (streamed) {
            how.streamedBandLimit = 0;
            for (const PlannedFilter* filter : filters)
                how.streamedBandLimit = std::max(*how.streamedBandLimit, streamedBandLimit(filter->options));
        }
        stages.push_back({.name = read, .why = how, .expected = readingCost(m_probe, builtin, streamed)});
        if (spectral > 0)
            stages.push_back({.name = "spectrum", .why = TransformsOnce{spectral}, .expected = transform});
        else
            stages.push_back(
                {.name = "spectrum", .isLeftOut = true, .why = filtered == 0 ? Because::NothingIsFiltered : Because::SumsAreCheaper});
    }
    for (const PlannedStage& stage : stages)
        m_plan.sharedSeconds += stage.expected.seconds;
    stages.insert(stages.end(), std::make_move_iterator(m_later.begin()), std::make_move_iterator(m_later.end()));
}

bool Plan::needsProbe() const
{
    return specular || isExact() || diffuse || clearCoat || background || !others.empty() ||
           std::any_of(exports.begin(), exports.end(), [](const ExportPlan& planned) { return !planned.painted; });
}

std::vector<const PlannedFilter*> Plan::planned() const
{
    std::vector<const PlannedFilter*> all;
    const auto add = [&](const MapPlan& map) {
        for (const PlannedFilter& filter : map.filters)
            all.push_back(&filter);
    };
    for (const auto* map : {&specular, &diffuse, &clearCoat, &background})
        if (*map)
            add(**map);
    for (const MapPlan& map : others)
        add(map);
    for (const ExportPlan& exported : exports)
        add(exported.map);
    return all;
}

std::vector<PrefilterOptions> Plan::filters() const
{
    std::vector<PrefilterOptions> all;
    for (const PlannedFilter* filter : planned())
        all.push_back(filter->options);
    return all;
}

bool Plan::filtersAny() const
{
    const std::vector<const PlannedFilter*> all = planned();
    return isExact() || std::any_of(all.begin(), all.end(), [](const PlannedFilter* filter) { return filter->plan.filtered; });
}

double lobeAngle(const Lobe& lobe) { return lobe.isMirror() ? 0.0 : 2.0 * LobeShape(lobe).halfWidth(); }

double texelAngle(const MapLayout& layout) { return std::sqrt(4.0 * pi / (double(layout.width()) * layout.height())); }

std::optional<double> constantReflectance(const Fresnel& fresnel)
{
    if (fresnel.kind == FresnelKind::None)
        return 1.0;
    if (fresnel.kind == FresnelKind::Dielectric && fresnel.index == 1.0)
        return 0.0;
    return std::nullopt;
}

bool mayNeedProbe(const Scene& scene, const PlanRequest& request)
{
    const auto readsProbe = [&](const ExportTarget& target) {
        return target.kind != ExportKind::Painted && isAskedFor(target, *request.exports);
    };
    return request.picture || (request.exports && std::any_of(scene.exports.begin(), scene.exports.end(), readsProbe));
}

Plan makePlan(const Scene& scene, const MapLayout& probe, const PlanRequest& request)
{
    validate(scene);
    return Planner(scene, probe).make(request);
}

Plan planFilters(const std::string& source, const MapLayout& probe, const std::vector<PrefilterOptions>& levels, const std::string& file)
{
    Scene scene;
    scene.probe.source = source;
    return Planner(scene, probe).makeFilters(levels, file);
}

} // namespace mirrorball
