#include "live_maps.h"

#include "core/image/probe_picture.h"

#include "core/base/error.h"
#include "core/base/field_checks.h"
#include "core/filter/source_file.h"
#include "core/shading/brdf_file.h"
#include "core/sphere/direction.h"

#include <algorithm>
#include <cmath>

namespace mirrorball {

namespace {

/// A probe of so many texels becomes a texture between two frames.
constexpr std::int64_t quickTexels = std::int64_t{2048} * 1024;

/// Whether the filter only looks the probe up: a mirror, or a lobe that its texels do not resolve.
bool isLookup(const PrefilterOptions& filter, const SceneProbe& probe)
{
    const bool blursByHand = filter.method == Method::Mip && filter.knobs.lambda;
    return !probe.source || (!blursByHand && (filter.lobe.isMirror() || isUnresolved(filter.lobe, probe.source->width())));
}

/// What the maps of a plan depend on: lobes that are only looked up make the same map.
MapPlan keyOf(MapPlan plan, const SceneProbe& probe)
{
    for (PlannedFilter& planned : plan.filters) {
        PrefilterOptions& filter = planned.options;
        if (isLookup(filter, probe))
            filter = {.lobe = probe.source && !filter.lobe.isMirror() ? phongLobe(1e9) : ggxLobe(0.0),
                      .target = filter.target,
                      .yaw = filter.yaw};
    }
    return plan;
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
    ProbeKey key{.path = resolved(scene, scene.probe.source), .reading = scene.probe.reading};
    if (!key.path.starts_with("builtin:"))
        for (const std::filesystem::path& file : probeFiles(key.path)) {
            std::error_code missing;
            key.time = std::max(key.time, std::filesystem::last_write_time(file, missing));
            key.size += std::filesystem::file_size(file, missing);
        }
    return key;
}

// What the same file held before is better than a placeholder that nobody asked for.
void LiveMaps::giveUp(const std::string& problem)
{
    m_problem = problem;
    m_file.reset();
    m_isKept = m_before.has_value();
    if (m_isKept) {
        m_now = std::move(*m_before);
        m_before.reset();
        return;
    }
    m_now = {};
    keepProbe(placeholderProbe());
    m_now.layout = m_now.environment->layout;
}

void LiveMaps::openHeader(const Scene& scene)
{
    ProbeKey key = probeKey(scene);
    if (m_key == key)
        return;
    const bool isSameFile = m_key && m_key->path == key.path;
    if (!isSameFile)
        m_before.reset();
    else if ((m_problem.empty() || m_isKept) && m_now.holdsLight())
        m_before = std::move(m_now);
    m_key.reset();
    m_file.reset();
    m_now = {};
    m_problem.clear();
    m_isKept = false;
    try {
        m_file = openProbeFile(scene);
        m_now.layout = m_file->layout();
        m_now.isStreamed = std::int64_t{m_now.layout.width()} * m_now.layout.height() > streamedFrom;
    } catch (const Cancelled&) {
        throw;
    } catch (const Error& error) {
        giveUp(error.what());
    }
    m_key = std::move(key);
}

void LiveMaps::readWhole(const Scene& scene, const JobControl& job, WorkRecord& record)
{
    if (m_now.environment)
        return;
    try {
        Probe probe = probeFile(scene).read(job);
        record += {.stages = std::move(probe.stages), .notes = std::move(probe.notes)};
        keepProbe(std::move(probe.map));
        m_now.probe.repaired = probe.repaired;
        m_now.probe.origin = std::move(probe.origin);
        m_now.certain = probe.certain;
    } catch (const Cancelled&) {
        throw;
    } catch (const Error& error) {
        if (m_before && m_before->isStreamed) // only a header could be told from here
            m_before.reset();
        giveUp(error.what());
    }
    m_now.layout = m_now.environment->layout;
}

/// The file whose header told the layout; after it was used up, opened anew.
ProbeFile LiveMaps::probeFile(const Scene& scene)
{
    if (!m_file)
        return openProbeFile(scene);
    ProbeFile file = std::move(*m_file);
    m_file.reset();
    return file;
}

void LiveMaps::keepProbe(EnvironmentMap probe)
{
    std::vector<EnvironmentMap> levels;
    levels.push_back(std::move(probe));
    m_now.itself = std::make_shared<const std::vector<EnvironmentMap>>(std::move(levels));
    m_now.environment = std::shared_ptr<const EnvironmentMap>(m_now.itself, &m_now.itself->front());
}

// A probe this large is read as the plan needs it, and again when the next plan needs more of it.
void LiveMaps::openStreamed(const Scene& scene, const Plan& plan, const JobControl& job, WorkRecord& record)
{
    const auto suffices = [&] {
        if (m_now.probe.source && !m_now.probe.source->latlong()) {
            const std::vector<const PlannedFilter*> filters = plan.planned();
            return std::all_of(filters.begin(), filters.end(), [&](const PlannedFilter* filter) {
                return filter->plan.filtered && filter->plan.bandLimit <= m_now.probe.source->knownBandLimit();
            });
        }
        return plan.filtersAny() ? m_now.probe.source.has_value() : m_now.probe.environment != nullptr;
    };
    if (suffices())
        return;
    m_now.probe = {};
    m_now.probe = openProbe(probeFile(scene), plan, job);
    record += m_now.probe.record;
}

/// Whether the map that is planned is the probe's own texels: exactly, or as far as the detail asks.
bool LiveMaps::isProbeItself(const MapPlan& plan, const SceneProbe& probe, const MapDetail& detail, double exposure) const
{
    if (!m_now.itself || plan.pyramid || plan.filters.size() != 1 || exposure != 0.0)
        return false;
    const PrefilterOptions& filter = plan.filters.front().options;
    if (filter.yaw != 0.0)
        return false;
    const MapLayout& own = m_now.environment->layout;
    if (filter.target == own && isLookup(filter, probe))
        return true;
    const bool isQuick = std::int64_t{own.width()} * own.height() <= quickTexels || m_now.background.levels == m_now.itself;
    return isQuick && detail.probeItselfUpTo > 0.0 && filter.method == Method::Auto &&
           lobeAngle(filter.lobe) <= detail.probeItselfUpTo * texelAngle(own);
}

MapLevels LiveMaps::levels(KeptMap& kept, const std::optional<MapPlan>& plan, SceneProbe& probe, const MapDetail& detail, double exposure,
                           const JobControl& job, WorkRecord& record)
{
    if (!plan) {
        kept = {};
        return nullptr;
    }
    const auto isKept = [&] {
        record.stages.push_back({.name = plan->name, .leftOut = true, .why = "kept: nothing that it depends on has changed"});
    };
    MapPlan key = keyOf(*plan, probe);
    if (kept.levels && kept.key == key && kept.exposure == exposure) {
        isKept();
        return kept.levels;
    }
    if (isProbeItself(*plan, probe, detail, exposure)) {
        isKept();
        if (plan->filters.front().options.target == m_now.environment->layout)
            kept = {std::move(key), exposure, m_now.itself};
        return m_now.itself;
    }
    BuiltMap built = buildMap(*plan, probe, exposure, job);
    record += std::move(built.record);
    auto made = std::make_shared<const std::vector<EnvironmentMap>>(std::move(built.levels));
    kept = {std::move(key), exposure, std::move(made)};
    return kept.levels;
}

MadeScene LiveMaps::update(const Scene& scene, const MapDetail& detail, const JobControl& job)
{
    MadeScene made{.scene = scene, .detail = detail};
    openHeader(scene);
    const auto planned = [&] {
        return timedStage(made.record.stages, "plan", [&] { return makePlan(scene, m_now.layout, {.detail = detail}); });
    };
    made.plan = planned();
    if (made.plan.needsProbe()) {
        if (m_now.isStreamed) {
            openStreamed(scene, made.plan, job, made.record);
        } else {
            const MapLayout announced = m_now.layout;
            readWhole(scene, job, made.record);
            if (m_now.layout != announced) // a file that breaks off after its header
                made.plan = planned();
            if (made.plan.filtersAny() && !m_now.probe.source)
                m_now.probe.source = timedStage(made.record.stages, "prepare probe", [&] { return FilterSource(*m_now.environment, job); });
        }
    }
    // As the command line does: where nothing is filtered the maps are made of the probe as it is.
    SceneProbe plain{.environment = m_now.environment};
    SceneProbe& probe = m_now.isStreamed || made.plan.filtersAny() ? m_now.probe : plain;

    if (made.plan.needsProbe())
        m_before.reset(); // it has been read, or what it held before is open again

    const auto make = [&](KeptMap& kept, const std::optional<MapPlan>& plan) {
        return levels(kept, plan, probe, detail, scene.probe.exposure, job, made.record);
    };
    made.maps.background = make(m_now.background, made.plan.background); // first: where it is the probe itself, the others may be, too
    made.maps.specular = make(m_now.specular, made.plan.specular);
    made.maps.brdfLookups = brdfLookups(scene, made.plan, job, made.record);
    made.maps.viewStack = viewStack(scene, made.plan, probe, job, made.record);
    made.maps.diffuse = make(m_now.diffuse, made.plan.diffuse);
    made.maps.clearCoat = make(m_now.clearCoat, made.plan.clearCoat);
    made.maps.sphereMaps = sphereMaps(scene, made.plan, job, made.record);
    made.maps.diffusePicture = m_diffusePicture.update(scene, made.plan.diffusePicture, job, made.record);
    made.maps.fleckPattern = m_fleckPattern.update(scene, made.plan.fleckPattern, job, made.record);
    made.maps.normalMap = m_normalMap.update(scene, made.plan.normalMap, job, made.record);
    made.probeLayout = m_now.layout;
    made.environment = m_now.isStreamed ? m_now.probe.environment : m_now.environment;
    made.repaired = m_now.probe.repaired;
    made.origin = m_now.probe.origin;
    made.certain = m_now.certain;
    made.problem = m_problem;
    const auto addProblem = [&](const std::string& problem) {
        if (!problem.empty())
            made.problem += (made.problem.empty() ? "" : "; ") + problem;
    };
    if (m_isKept)
        made.keptFiles.push_back(m_key->path);
    if (const auto& brdf = made.plan.isExact() ? m_now.exact : m_brdf; made.plan.brdf && brdf)
        addProblem(brdf->problem);
    for (const KeptSphereMap& map : m_sphereMaps) {
        addProblem(map.problem);
        if (map.isKept)
            made.keptFiles.push_back(map.path);
    }
    for (const LivePicture* picture : {&m_diffusePicture, &m_fleckPattern, &m_normalMap}) {
        addProblem(picture->problem());
        if (!picture->keptFile().empty())
            made.keptFiles.push_back(picture->keptFile());
    }
    return made;
}

LiveMaps::KeptBrdf LiveMaps::wantedBrdf(const Scene& scene, const BrdfPlan& plan)
{
    KeptBrdf wanted{.plan = plan, .exposure = scene.probe.exposure};
    if (isBrdfFile(plan.model)) {
        std::error_code ignored;
        wanted.path = resolved(scene, plan.model);
        wanted.time = std::filesystem::last_write_time(wanted.path, ignored);
    }
    return wanted;
}

std::shared_ptr<const ViewStack> LiveMaps::viewStack(const Scene& scene, const Plan& plan, SceneProbe& probe, const JobControl& job,
                                                     WorkRecord& record)
{
    std::optional<KeptBrdf>& kept = m_now.exact;
    if (!plan.brdf)
        kept.reset();
    if (!plan.isExact()) // kept, for who compares the two
        return nullptr;
    KeptBrdf wanted = wantedBrdf(scene, *plan.brdf);
    if (kept && kept->plan.model == wanted.plan.model && kept->plan.yaw == wanted.plan.yaw &&
        kept->plan.tolerance <= wanted.plan.tolerance && kept->exposure == wanted.exposure && kept->path == wanted.path &&
        kept->time == wanted.time)
        return kept->stack;
    try {
        wanted.stack = buildViewStack(scene, wanted.plan, probe, record, job);
    } catch (const Cancelled&) {
        throw;
    } catch (const Error& error) {
        wanted.problem = error.what();
        wanted.stack = std::make_shared<const ViewStack>(ViewStack{
            .nodes = {{}}, .albedo = std::vector<glm::dvec3>(ViewStack::albedoViews, glm::dvec3(1.0)), .layers = {Image(2, 1, 3, 1.0f)}});
    }
    kept = std::move(wanted);
    return kept->stack;
}

// A measurement that cannot be read must not stop the picture either.
std::shared_ptr<const Image> LiveMaps::brdfLookups(const Scene& scene, const Plan& plan, const JobControl& job, WorkRecord& record)
{
    if (!plan.brdf)
        m_brdf.reset();
    if (!plan.brdf || plan.isExact())
        return nullptr;
    KeptBrdf wanted = wantedBrdf(scene, *plan.brdf);
    // A table of more views than are asked for serves as well: dragging another control fits none anew.
    if (m_brdf && m_brdf->plan.model == wanted.plan.model && m_brdf->plan.lookups == wanted.plan.lookups &&
        m_brdf->plan.columns >= wanted.plan.columns && m_brdf->path == wanted.path && m_brdf->time == wanted.time)
        return m_brdf->table;
    timedStage(record.stages, "BRDF lookups", [&] {
        try {
            wanted.table = buildBrdfLookups(scene, wanted.plan, job);
        } catch (const Cancelled&) {
            throw;
        } catch (const Error& error) {
            wanted.problem = error.what();
            Image mirror(1, 2);
            std::fill_n(mirror.texel(0, 1), 3, 1.0f);
            wanted.table = std::make_shared<const Image>(std::move(mirror));
        }
    });
    m_brdf = std::move(wanted);
    return m_brdf->table;
}

namespace {

/// The visible layers of a kind that only a newer version knows, or nothing.
std::string unknownLayersOf(const SphereMapDocument& document)
{
    std::string unknown;
    for (size_t i = 0; i < document.layers.size(); ++i) {
        const Layer& layer = document.layers[i];
        const auto isUnknown = [](const LayerContent& content) { return std::holds_alternative<UnknownLayer>(content); };
        if (layer.visible && (isUnknown(layer.content) || (layer.mask && isUnknown(layer.mask->content))))
            unknown += (unknown.empty() ? "" : ", ") + std::to_string(i + 1) + (layer.name.empty() ? "" : " " + inQuotes(layer.name));
    }
    return unknown.empty() ? "" : "the sphere map is shown without layer " + unknown + ", of a kind that this version does not know";
}

/// Whether what was made of one plan is what another asks for: a finer picture serves as well.
bool serves(const SphereMapPlan& made, SphereMapPlan wanted)
{
    const auto edge = [](const SphereMapPlan& plan) { return plan.drawnSize > 0 ? plan.drawnSize : plan.size; };
    const bool isFine = edge(made) >= edge(wanted);
    wanted.drawnSize = made.drawnSize;
    return isFine && made == wanted;
}

} // namespace

// A map that cannot be read must not stop the picture: what its file held before, or a texel of magenta, stands in for it, and the problem
// is named.
void LiveMaps::build(KeptSphereMap& map, const SphereMapChain& before, const Scene& scene, const JobControl& job)
{
    try {
        if (!map.plan.document) {
            map.texels = std::make_shared<const SphereMapTexels>(buildSphereMap(scene, map.plan, job));
            return;
        }
        const SphereMapDocument& document = *map.plan.document.document;
        const bool isCoarse = map.plan.drawnSize > 0;
        std::shared_ptr<SphereMapCache>& cache = isCoarse ? map.coarseCache : map.cache;
        const EvaluateOptions wanted{.size = isCoarse ? map.plan.drawnSize : map.plan.size,
                                     .levelSize = isCoarse ? map.plan.size : 0,
                                     .unknownLayers = UnknownLayers::Skip};
        if (!cache || cache->size() != wanted.size || cache->options().levelSize != wanted.levelSize)
            cache = std::make_shared<SphereMapCache>(wanted);
        map.texels = std::make_shared<const SphereMapTexels>(sphereMapTexels(*cache, document, map.plan.levels, job));
        map.problem = unknownLayersOf(document);
    } catch (const InvalidArgument& error) {
        map.problem = error.what();
        map.isKept = before != nullptr;
        if (map.isKept) {
            map.texels = before;
            return;
        }
        Image magenta(1, 1, 4);
        magenta.texels = {1.0f, 0.0f, 1.0f, 1.0f};
        map.texels = std::make_shared<const SphereMapTexels>(SphereMapTexels{.levels = {magenta}});
    }
}

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
        SphereMapChain before;
        for (const KeptSphereMap& old : m_sphereMaps) {
            if (serves(old.plan, map.plan) && old.path == map.path && old.time == map.time)
                map = old;
            else if (!map.path.empty() && old.plan == map.plan && old.path == map.path && (old.problem.empty() || old.isKept))
                before = old.texels;
            else if (wanted.document && old.plan.field == wanted.field) {
                map.cache = old.cache;
                map.coarseCache = old.coarseCache;
            }
        }
        if (!map.texels)
            timedStage(record.stages, "sphere map " + wanted.source, [&] { build(map, before, scene, job); });
        maps.push_back(map.texels);
        kept.push_back(std::move(map));
    }
    m_sphereMaps = std::move(kept);
    return maps;
}

} // namespace mirrorball
