#pragma once

#include "scene.h"

#include "core/filter/planned_filter.h"

#include <string>
#include <vector>

/// The maps that a plan makes.
namespace mirrorball {

/// One map to make.
struct MapPlan {
    std::string name{};                   ///< for stages: "specular map"
    std::vector<PlannedFilter> filters{}; ///< a filtered level each, largest first; ggx with alpha = 0: the environment itself
    bool pyramid = false;                 ///< the levels below the first are its halvings
    MipFiltering filtering = MipFiltering::AcrossSeams; ///< of the pyramid
    bool operator==(const MapPlan&) const = default;
};

/// One sphere map to evaluate.
struct SphereMapPlan {
    std::string field{}; ///< for messages: "material.sphere_map.source"
    std::string source{};
    EmbeddedSphereMap document{}; ///< in place of the source
    int size = 512;
    SphereMapLevels levels = SphereMapLevels::Authored;
    int drawnSize = 0; ///< where only a coarser picture of it is needed: the edge of that, `size` halved; 0: `size`
    bool operator==(const SphereMapPlan&) const = default;
};

/// The table of a BRDF's lookups. Its entries stand between the levels of the specular map, a ggx chain by chainRoughness(). Or, where
/// those are exact, its view stack, which needs no specular map.
struct BrdfPlan {
    std::string model{}; ///< as the scene names it
    LookupChoice lookups{};
    int columns = 32;       ///< angles of view
    double tolerance = 0.0; ///< exact: of the stack
    double yaw = 0.0;       ///< exact: as yawed()
    bool operator==(const BrdfPlan&) const = default;
};

} // namespace mirrorball
