#include "live_maps.h"

#include "../error.h"
#include "../filter/source_file.h"
#include "../image/map_file.h"

#include <algorithm>

namespace mirrorball {

namespace {

/// A map without coarser levels may be made smaller: lookups do not notice but for sharpness. Levels are counted from the largest, so
/// a pyramid keeps its size.
void apply(const MapDetail& detail, std::optional<MapPlan>& map)
{
    if (!map)
        return;
    for (PrefilterOptions& filter : map->filters) {
        filter.tolerance = detail.tolerance;
        if (!map->pyramid && map->filters.size() == 1 && filter.target.size > detail.largestSize) {
            filter.target.border = filter.target.border * detail.largestSize / filter.target.size;
            filter.target.size = detail.largestSize;
        }
    }
}

} // namespace

EnvironmentMap placeholderProbe()
{
    EnvironmentMap map({Parameterization::Latlong, 128, 0});
    for (int y = 0; y < map.image.height; ++y)
        for (int x = 0; x < map.image.width; ++x) {
            const bool bright = (x / 16 + y / 16) % 2 == 0;
            const glm::vec3 color = bright ? glm::vec3(0.8f, 0.05f, 0.6f) : glm::vec3(0.05f);
            std::copy_n(&color.x, 3, map.image.texel(x, y));
        }
    return map;
}

LiveMaps::ProbeKey LiveMaps::probeKey(const Scene& scene)
{
    ProbeKey key{.path = resolved(scene, scene.probe.source), .parameterization = scene.probe.parameterization};
    if (!key.path.starts_with("builtin:")) {
        std::error_code missing;
        key.time = std::filesystem::last_write_time(key.path, missing);
        key.size = std::filesystem::file_size(key.path, missing);
    }
    return key;
}

void LiveMaps::forgetMaps()
{
    m_specular = m_diffuse = m_background = {};
}

void LiveMaps::openHeader(const Scene& scene)
{
    ProbeKey key = probeKey(scene);
    if (m_key == key)
        return;
    m_key.reset();
    m_probe = {};
    m_environment.reset();
    forgetMaps();
    m_certain = true;
    m_problem.clear();
    try {
        m_layout = probeLayout(scene);
    } catch (const Cancelled&) {
        throw;
    } catch (const Error& error) {
        m_problem = error.what();
        m_environment = std::make_shared<const EnvironmentMap>(placeholderProbe());
        m_layout = m_environment->layout;
    }
    m_isStreamed = std::int64_t{m_layout.width()} * m_layout.height() > streamedFrom;
    m_key = std::move(key);
}

void LiveMaps::readWhole(const Scene& scene, const JobControl& job, WorkRecord& record)
{
    if (m_environment)
        return;
    try {
        Probe probe = readProbe(resolved(scene, scene.probe.source), {.from = scene.probe.parameterization}, job, record.stages);
        m_environment = std::make_shared<const EnvironmentMap>(std::move(probe.map));
        m_probe.repaired = probe.repaired;
        m_probe.origin = std::move(probe.origin);
        m_certain = probe.certain;
    } catch (const Cancelled&) {
        throw;
    } catch (const Error& error) {
        m_problem = error.what();
        m_environment = std::make_shared<const EnvironmentMap>(placeholderProbe());
    }
    m_layout = m_environment->layout;
}

// A probe this large is read as the plan needs it, and again when the next plan needs more of it.
void LiveMaps::openStreamed(const Scene& scene, const Plan& plan, const JobControl& job, WorkRecord& record)
{
    const auto suffices = [&] {
        if (m_probe.source && !m_probe.source->latlong()) {
            const std::vector<PrefilterOptions> filters = plan.filters();
            return std::all_of(filters.begin(), filters.end(), [&](const PrefilterOptions& filter) {
                const PrefilterPlan needed = planPrefilter(filter, {.width = m_probe.source->width()});
                return needed.filtered && needed.bandLimit <= m_probe.source->knownBandLimit();
            });
        }
        return plan.filtersAny() ? m_probe.source.has_value() : m_probe.environment != nullptr;
    };
    if (suffices())
        return;
    m_probe = {};
    m_probe = openProbe(scene, plan, job, record);
}

MapLevels LiveMaps::levels(KeptMap& kept, const std::optional<MapPlan>& plan, SceneProbe& probe, double exposure, const JobControl& job,
                           WorkRecord& record)
{
    if (!plan) {
        kept = {};
    } else if (!kept.levels || kept.plan != *plan || kept.exposure != exposure) {
        auto made = std::make_shared<const std::vector<EnvironmentMap>>(buildMap(*plan, probe, exposure, job, record));
        kept = {*plan, exposure, std::move(made)};
    } else {
        record.stages.push_back({.name = plan->name, .leftOut = true, .why = "kept: nothing that it depends on has changed"});
    }
    return kept.levels;
}

MadeScene LiveMaps::update(const Scene& scene, const MapDetail& detail, const JobControl& job)
{
    MadeScene made{.scene = scene, .detail = detail};
    openHeader(scene);
    made.plan = makePlan(scene, m_layout);
    if (made.plan.needsProbe()) {
        if (m_isStreamed) {
            openStreamed(scene, made.plan, job, made.record);
        } else {
            const MapLayout announced = m_layout;
            readWhole(scene, job, made.record);
            if (m_layout != announced) // a file that breaks off after its header
                made.plan = makePlan(scene, m_layout);
            if (made.plan.filtersAny() && !m_probe.source)
                m_probe.source = timedStage(made.record.stages, "prepare probe", [&] { return FilterSource(*m_environment, job); });
        }
    }
    // As the command line does: where nothing is filtered the maps are made of the probe as it is.
    SceneProbe plain{.environment = m_environment};
    SceneProbe& probe = m_isStreamed || made.plan.filtersAny() ? m_probe : plain;
    for (std::optional<MapPlan>* map : {&made.plan.specular, &made.plan.diffuse})
        apply(detail, *map);

    made.maps = {.specular = levels(m_specular, made.plan.specular, probe, scene.probe.exposure, job, made.record),
                 .diffuse = levels(m_diffuse, made.plan.diffuse, probe, scene.probe.exposure, job, made.record),
                 .background = levels(m_background, made.plan.background, probe, scene.probe.exposure, job, made.record)};
    made.maps.sphereMaps = sphereMaps(scene, made.plan, job, made.record);
    made.probeLayout = m_layout;
    made.environment = m_isStreamed ? m_probe.environment : m_environment;
    made.repaired = m_probe.repaired;
    made.origin = m_probe.origin;
    made.certain = m_certain;
    made.problem = m_problem;
    return made;
}

// A map that cannot be read must not stop the picture: a texel of magenta stands in for it, and the problem is named.
std::vector<SphereMapChain> LiveMaps::sphereMaps(const Scene& scene, const Plan& plan, const JobControl& job, WorkRecord& record)
{
    std::vector<KeptSphereMap> kept;
    std::vector<SphereMapChain> maps;
    for (const SphereMapPlan& wanted : plan.sphereMaps) {
        std::error_code ignored;
        KeptSphereMap map{.plan = wanted};
        if (!wanted.document && isSphereMapFile(wanted.source)) {
            map.path = resolved(scene, wanted.source);
            map.time = std::filesystem::last_write_time(map.path, ignored);
        }
        for (const KeptSphereMap& old : m_sphereMaps)
            if (old.plan == map.plan && old.path == map.path && old.time == map.time)
                map.texels = old.texels;
        if (!map.texels)
            map.texels = timedStage(record.stages, "sphere map " + wanted.source, [&] {
                try {
                    return std::make_shared<const SphereMapTexels>(buildSphereMap(scene, wanted, job));
                } catch (const InvalidArgument& error) {
                    m_problem += (m_problem.empty() ? "" : "; ") + std::string(error.what());
                    Image magenta(1, 1, 4);
                    magenta.texels = {1.0f, 0.0f, 1.0f, 1.0f};
                    return std::make_shared<const SphereMapTexels>(SphereMapTexels{.levels = {magenta}});
                }
            });
        maps.push_back(map.texels);
        kept.push_back(std::move(map));
    }
    m_sphereMaps = std::move(kept);
    return maps;
}

} // namespace mirrorball
