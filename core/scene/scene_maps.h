#pragma once

#include "plan.h"
#include "sphere_map_source.h"

#include "core/base/job.h"
#include "core/image/environment_map.h"
#include "core/image/repair.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

/// From a plan to maps in memory.
namespace mirrorball {

/// The layout of the scene's probe, from its file's header alone. @throws FileError, InvalidArgument
MapLayout probeLayout(const Scene& scene);

/// The same for a request: of one that makes nothing of the probe, its file is not opened and the layout says nothing.
MapLayout probeLayout(const Scene& scene, const PlanRequest& request);

/// What was done: for `--stats`.
struct WorkRecord {
    std::vector<Stage> stages{};
    std::string method{};        ///< those that ran: "spectral, direct"; empty when nothing was filtered
    int bandLimit = 0;           ///< the largest
    PredictedErrors predicted{}; ///< the largest of each
    bool promised = true;        ///< all maps that were filtered keep their tolerance

    void add(const PrefilterOutcome& outcome);
};

/// The scene's probe, opened as a plan needs it. Keep it while only other parts of the scene change: it keeps its spectrum.
struct SceneProbe {
    std::optional<FilterSource> source{};                ///< when something is filtered
    std::shared_ptr<const EnvironmentMap> environment{}; ///< when nothing is: the probe as it is
    RepairReport repaired{};
    std::string origin{}; ///< how its parameterization was found, in words
};

/// @throws FileError, InvalidArgument, Cancelled
SceneProbe openProbe(const Scene& scene, const Plan& plan, const JobControl& job, WorkRecord& record);

/// A map and its coarser levels, largest first.
using MapLevels = std::shared_ptr<const std::vector<EnvironmentMap>>;

/// The levels of one planned map; radiance times 2^exposure.
std::vector<EnvironmentMap> buildMap(const MapPlan& plan, SceneProbe& probe, double exposure, const JobControl& job, WorkRecord& record);

/// What the renderer needs of a scene. Maps that the plan leaves out are null.
struct SceneMaps {
    MapLevels specular{};
    MapLevels diffuse{};
    MapLevels background{};
    std::vector<SphereMapChain> sphereMaps{}; ///< those of the plan
    std::vector<MapLevels> others{};          ///< of PlanExtent::Everything
};

/// The document of a planned sphere map. @throws as readSphereMap()
SphereMapDocument sphereMapDocument(const Scene& scene, const SphereMapPlan& plan);

SphereMapTexels buildSphereMap(const Scene& scene, const SphereMapPlan& plan, const JobControl& job);

/// The sphere maps alone. @throws as readSphereMap()
std::vector<SphereMapChain> buildSphereMaps(const Scene& scene, const Plan& plan, const JobControl& job, WorkRecord& record);

SceneMaps buildMaps(const Scene& scene, const Plan& plan, SceneProbe& probe, const JobControl& job, WorkRecord& record);

} // namespace mirrorball
