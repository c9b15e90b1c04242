#pragma once

#include "plan.h"
#include "sphere_map_source.h"

#include "core/base/job.h"
#include "core/filter/view_stack.h"
#include "core/image/environment_map.h"
#include "core/image/probe_file.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

/// From a plan to maps in memory.
namespace mirrorball {

/// The scene's probe, opened but not read. @throws FileError, InvalidArgument
ProbeFile openProbeFile(const Scene& scene);

/// Its layout, from its file's header alone. @throws FileError, InvalidArgument
MapLayout probeLayout(const Scene& scene);

/// The same for a request: of one that makes nothing of the probe, its file is not opened and the layout says nothing.
MapLayout probeLayout(const Scene& scene, const PlanRequest& request);

/// What was done: for `--stats`. Records add up.
struct WorkRecord {
    std::vector<Stage> stages{};
    std::vector<std::string> methods{}; ///< those that ran, each once: "spectral"; "paint"; empty when nothing was filtered
    int bandLimit = 0;                  ///< the largest
    PredictedErrors predicted{};        ///< the largest of each
    /// Of each map whose tolerance is not promised: its lobe, its method and what is predicted of it, in words. Empty: all are promised.
    std::vector<std::string> unpromised{};
    std::vector<std::string> notes{}; ///< what of the probe's file a user should know

    WorkRecord& operator+=(WorkRecord more);
    /// "spectral, direct"; empty as methods
    std::string methodText() const;
};

/// A scene with its plan, and its probe opened for it: from here on the scene is only followed.
struct PlannedScene {
    Scene scene{};
    Plan plan{};
    std::optional<ProbeFile> probe{}; ///< nothing where the request makes nothing of it
    WorkRecord record{};              ///< what planning took
};
/// Opens the probe's header and plans. @throws as makePlan(); FileError
PlannedScene planScene(Scene scene, const PlanRequest& request = {});

/// The scene's probe, opened as a plan needs it. Keep it while only other parts of the scene change: it keeps its spectrum.
struct SceneProbe {
    std::optional<FilterSource> source{};                ///< when something is filtered
    std::shared_ptr<const EnvironmentMap> environment{}; ///< when nothing is: the probe as it is
    RepairReport repaired{};
    std::string origin{}; ///< how its parameterization was found, in words
    WorkRecord record{};  ///< what opening it took
};

/// @param file  of the scene's probe, which is used up; nothing where the plan does not need it. @throws FileError, InvalidArgument,
/// Cancelled
SceneProbe openProbe(std::optional<ProbeFile> file, const Plan& plan, const JobControl& job = {});

/// A map and its coarser levels, largest first.
using MapLevels = std::shared_ptr<const std::vector<EnvironmentMap>>;

struct BuiltMap {
    std::vector<EnvironmentMap> levels{};
    WorkRecord record{};
};
/// The levels of one planned map; radiance times 2^exposure.
BuiltMap buildMap(const MapPlan& plan, SceneProbe& probe, double exposure, const JobControl& job = {});

/// What the renderer needs of a scene. Maps that the plan leaves out are null.
struct SceneMaps {
    MapLevels specular{};
    std::shared_ptr<const Image> brdfLookups{};   ///< lookup_table.h
    std::shared_ptr<const ViewStack> viewStack{}; ///< view_stack.h
    MapLevels diffuse{};
    MapLevels clearCoat{};
    MapLevels background{};
    std::vector<SphereMapChain> sphereMaps{}; ///< those of the plan
    PictureLevels diffusePicture{}, fleckPattern{}, normalMap{};
    std::vector<MapLevels> others{}; ///< of PlanExtent::Everything
    WorkRecord record{};             ///< what making them took
};

/// The document of a planned sphere map. @throws as readSphereMap()
SphereMapDocument sphereMapDocument(const Scene& scene, const SphereMapPlan& plan);

SphereMapTexels buildSphereMap(const Scene& scene, const SphereMapPlan& plan, const JobControl& job);

/// The table of the lookups of the scene's BRDF. @throws InvalidArgument, FileError, Cancelled
std::shared_ptr<const Image> buildBrdfLookups(const Scene& scene, const BrdfPlan& plan, const JobControl& job);

/// What the scene's BRDF reflects, exactly; radiance times 2^exposure. The record says where it misses its tolerance.
/// @throws InvalidArgument, FileError, Cancelled
std::shared_ptr<const ViewStack> buildViewStack(const Scene& scene, const BrdfPlan& plan, SceneProbe& probe, WorkRecord& record,
                                                const JobControl& job);

/// All of them; the record tells of opening the probe, too.
SceneMaps buildMaps(const Scene& scene, const Plan& plan, SceneProbe& probe, const JobControl& job = {});

/// Opens the probe and makes the maps. @throws FileError, InvalidArgument, Cancelled
SceneMaps buildMaps(PlannedScene planned, const JobControl& job = {});

} // namespace mirrorball
