#pragma once

#include "plan.h"
#include "plan_words.h"
#include "stage_cost.h"

#include "core/filter/filter_source.h"

#include <string>
#include <utility>
#include <vector>

namespace mirrorball {

/// Whether an export is among those asked for; an empty list asks for all.
bool isAskedFor(const ExportTarget& target, const std::vector<std::string>& only);

/// Which light the material takes in at all, in the order in which reasons rule it out.
PlannedMaterial planMaterial(const Material& material, PlanExtent extent);

inline bool isBlack(const glm::dvec3& color) { return color == glm::dvec3(0.0); }

/// Makes one plan: what the picture needs (plan_picture.cpp), what exports need (plan_exports.cpp), and what both share (plan.cpp).
class Planner {
public:
    Planner(const Scene& scene, const MapLayout& probe) : m_scene(scene), m_probe(probe) {}
    Plan make(const PlanRequest& request);
    /// Levels that are all filtered from the probe, as one export.
    Plan makeFilters(const std::vector<PrefilterOptions>& levels, const std::string& file);

private:
    bool makesAll() const { return m_extent == PlanExtent::Everything; }
    int probeWidth() const { return 2 * latlongHeight(m_probe); }
    void need(std::string name, Decision why, const StageCost& cost = {});
    void leaveOut(std::string name, Decision why);
    /// Why the material shows no reflection, or no diffuse light.
    Because whyNoSpecular() const;
    Because whyNoDiffuse() const;
    PlannedFilter planned(const PrefilterOptions& filter) const { return planFilter(filter, probeWidth()); }
    /// The scene's choice of method. What that refuses is left to auto.
    LevelChoice chooseMethod(PrefilterOptions& filter) const;
    /// Adds the stages of one level and remembers what it takes. A map that never was to be filtered has no stage for that.
    void addLevel(MapPlan& map, PlannedFilter planned, const std::string& name, const LevelChoice& choice = {},
                  std::optional<Because> whyMirror = {});
    /// A debug view shows what the material is computed from, and not the material.
    bool showsMaterial() const { return m_scene.view.shading == Shading::Material; }
    bool isWindow() const { return showsWindow(m_scene); }
    /// Views of normals, and of what mirror directions find, show those of a normal map.
    bool showsNormals() const
    {
        const Shading shading = m_scene.view.shading;
        return !isWindow() && (showsMaterial() || shading == Shading::Normals || shading == Shading::Seams || shading == Shading::Mips);
    }
    /// Nor does a sphere map that replaces the material show it, nor a room.
    bool readsMaterial() const;
    Decision whyNoMaterial() const;
    void planPicture();
    void planLambda();
    void planOthers();
    void planSphereMap(const std::string& name, const std::string& field, const std::string& source, SphereMapLevels levels,
                       const EmbeddedSphereMap& document = {});
    void planSphereMaps();
    /// Why no flecks are shown; nothing where they are.
    std::optional<Decision> whyNoFlecks() const;
    void planSurfacePictures();
    /// The environment's yaw belongs to the picture's lookups, so that turning it makes no map anew; a map in eye space has no such turn.
    double bakedYaw() const { return m_scene.map.space == MapSpace::Eye ? m_scene.probe.yawDeg * pi / 180.0 : 0.0; }
    /// A filter of the picture, of the tolerance that the detail asks for.
    PlannedFilter withTolerance(PrefilterOptions filter) const;
    /// A map without coarser levels may be made smaller: lookups do not notice but for sharpness. Levels are counted from the largest, so
    /// a pyramid keeps its size.
    void applySize(PrefilterOptions& filter, bool pyramid) const;
    /// What the mirror direction is looked up in: of that tolerance, and no larger than its lobe needs.
    PlannedFilter reflectionFilter(const PrefilterOptions& wanted, bool pyramid, LevelChoice& choice) const;
    MapLayout mapLayout() const { return {m_scene.map.parameterization, m_scene.map.size, m_scene.map.border}; }
    void planSpecular();
    void planBrdf();
    void planExactBrdf();
    void planDiffuse();
    void planClearCoat();
    void planBackground();
    void planExports(const std::vector<std::string>& only);
    /// What is loaded for a file is loaded once.
    StageCost savingStage(const std::filesystem::path& file, const ExportPlan& planned);
    void planPainted(const ExportTarget& target);
    void planExport(const ExportTarget& target);
    /// The stages before all others follow from what the maps need.
    void planReading();
    const Scene& m_scene;
    MapLayout m_probe;
    PlanExtent m_extent = PlanExtent::Needed;
    MapDetail m_detail{};
    Plan m_plan{};
    std::vector<PlannedStage> m_later{};
    bool m_isWriterLoaded = false;
};

} // namespace mirrorball
