#include "planner.h"

#include "core/base/error.h"
#include "core/image/image_format.h"
#include "core/image/map_file.h"
#include "core/image/mip_pyramid.h"
#include "core/spheremap/evaluation/evaluate.h"

#include <algorithm>

/// What exports need of a scene.
namespace mirrorball {

bool isAskedFor(const ExportTarget& target, const std::vector<std::string>& only)
{
    return only.empty() || std::find(only.begin(), only.end(), target.name) != only.end();
}

StageCost Planner::savingStage(const std::filesystem::path& file, const ExportPlan& planned)
{
    StageCost cost = savingCost(file, levelLayouts(planned));
    if (!m_isWriterLoaded) {
        const double loading = loadingSeconds(file);
        cost.seconds += loading;
        m_isWriterLoaded = loading > 0.0;
    }
    return cost;
}

Plan Planner::makeFilters(const std::vector<PrefilterOptions>& levels, const std::string& file)
{
    MapPlan map{.name = levels.size() == 1 ? describe(levels.front().lobe) : "map"};
    for (size_t i = 0; i < levels.size(); ++i)
        addLevel(map, planned(levels[i]), levels.size() == 1 ? map.name : text(map.name, " level ", i), {}, Because::LobeIsMirror);
    if (levels.size() == 1)
        leaveOut("mip levels of " + map.name, Because::NotAskedFor);
    m_plan.exports.push_back({.map = std::move(map)});
    need("save map", SavesFile{file}, savingStage(file, m_plan.exports.back()));
    planReading();
    return std::move(m_plan);
}

void Planner::planExports(const std::vector<std::string>& only)
{
    for (const std::string& name : only)
        if (std::none_of(m_scene.exports.begin(), m_scene.exports.end(), [&](const ExportTarget& t) { return t.name == name; })) {
            std::string known;
            for (const ExportTarget& target : m_scene.exports)
                known += (known.empty() ? "" : ", ") + target.name;
            throw InvalidArgument("--only: the scene has no export '" + name + "'; it has " + (known.empty() ? "none" : known));
        }
    for (const ExportTarget& target : m_scene.exports)
        if (!isAskedFor(target, only)) {
            leaveOut("export " + target.name, Because::NotAmongThoseAskedFor);
        } else {
            const size_t firstStage = m_later.size();
            if (target.kind == ExportKind::Painted)
                planPainted(target);
            else
                planExport(target);
            ExportPlan& planned = m_plan.exports.back();
            need("save " + target.name, SavesFile{target.fileName()}, savingStage(target.fileName(), planned));
            for (size_t i = firstStage; i < m_later.size(); ++i)
                planned.seconds += m_later[i].expected.seconds;
        }
}

std::vector<MapLayout> levelLayouts(const ExportPlan& plan)
{
    std::vector<MapLayout> layouts;
    if (plan.painted)
        for (int size = plan.target.size; size >= 1; size = plan.target.mips ? size / 2 : 0)
            layouts.push_back({Parameterization::Sphere, size, 0});
    for (const PlannedFilter& filter : plan.map.filters)
        layouts.push_back(filter.options.target);
    if (plan.map.pyramid)
        for (int i = 1; i < levelCount(layouts.front()); ++i)
            layouts.push_back(levelLayout(layouts.front(), i));
    return layouts;
}

void Planner::planPainted(const ExportTarget& target)
{
    const SphereMapSettings& map = m_scene.material.sphereMap;
    if (map.isNone())
        throw InvalidArgument(text("exports[", &target - m_scene.exports.data(),
                                   "].kind: painted writes the scene's sphere map, and it has none; "
                                   "give material.sphere_map.source a preset or a file, or choose another kind"));
    const SphereMapPlan painted{"material.sphere_map.source", map.source, map.document, target.size - 2 * target.border, map.levels};
    const SphereMapDocument* document = documentAtHand(painted);
    const bool isAuthored = target.mips && document && map.levels == SphereMapLevels::Authored && hasAuthoredLevels(*document);
    need("paint " + target.name, PaintsFile{painted, target},
         paintingCost(painted.size, document ? document->layers.size() : 1, isAuthored));
    m_plan.exports.push_back({.map = {.name = target.name}, .target = target, .painted = painted});
}

void Planner::planExport(const ExportTarget& target)
{
    MapPlan map{.name = target.name};
    PrefilterOptions filter{.target = target.layout(), .yaw = m_scene.probe.yawDeg * pi / 180.0};
    switch (target.kind) {
    case ExportKind::Source:
        filter.lobe = ggxLobe(0.0);
        break;
    case ExportKind::Specular:
        filter.lobe = lobe(m_scene.material.specular);
        break;
    case ExportKind::Diffuse:
        filter.lobe = diffuseLobe();
        break;
    case ExportKind::Chain:
    case ExportKind::Painted:
        break;
    }
    if (target.kind == ExportKind::Chain) {
        const int all = levelCount(filter.target), levels = target.levels == 0 ? all : std::min(target.levels, all);
        for (int i = 0; i < levels; ++i) {
            const double roughness = chainRoughness(i, levels);
            PrefilterOptions level = filter;
            level.lobe = ggxLobe(roughness * roughness);
            level.target = levelLayout(filter.target, i);
            addLevel(map, planned(level), text(target.name, " level ", i), {}, Because::RoughnessIsZero);
        }
    } else {
        const bool isSpecular = target.kind == ExportKind::Specular;
        const LevelChoice choice = isSpecular ? chooseMethod(filter) : LevelChoice{};
        addLevel(map, planned(filter), map.name, choice, isSpecular ? std::optional(Because::ExportIsOfMirror) : std::nullopt);
        const bool held = holdsMips(target.fileName()) || namesLevels(target.fileName());
        map.pyramid = target.mips && held;
        if (map.pyramid)
            need("mip levels of " + map.name, HalvesForExport{levelCount(filter.target)}, pyramidCost(filter.target));
        else
            leaveOut("mip levels of " + map.name, target.mips ? Decision(FileHoldsNoLevels{target.fileName()}) : Because::NotAskedFor);
    }
    m_plan.exports.push_back({.map = std::move(map), .target = target});
}

} // namespace mirrorball
