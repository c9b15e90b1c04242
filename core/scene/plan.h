#pragma once

#include "decision.h"
#include "map_plan.h"
#include "surface_picture.h"

#include "core/base/stage.h"

#include <limits>
#include <optional>
#include <string>
#include <vector>

/// What a scene needs, what is left out, and why. Pure: nothing is opened or computed, and stages that are left out cost nothing later.
namespace mirrorball {

/// The material with everything resolved that does not change from pixel to pixel. A color of 0 needs no map, and where F is the same
/// at every angle no Fresnel term is evaluated: kind None.
struct PlannedMaterial {
    glm::dvec3 specular{0.0};
    glm::dvec3 diffuse{0.0};
    Fresnel fresnel{};
    Combine combine = Combine::Add;
    double clearCoat = 0.0; ///< its weight; 0: there is none to be seen
    double clearCoatIndex = 1.5;
    Combine clearCoatCombine = Combine::Coat;
    bool operator==(const PlannedMaterial&) const = default;
};

struct ExportPlan {
    MapPlan map{};
    ExportTarget target{};
    std::optional<SphereMapPlan> painted{}; ///< what is written in place of a map of the probe
    double seconds = 0.0;                   ///< of its own stages, CPU time, about: what other exports share is in Plan::sharedSeconds
};

/// The maps that an export writes, largest first.
std::vector<MapLayout> levelLayouts(const ExportPlan& plan);

/// How much a plan makes.
enum class PlanExtent {
    Needed,     ///< what the scene needs
    Everything, ///< every stage as if none could be left out, at full sizes: what leaving out is measured against. The picture is the same.
};

/// How good the maps that the picture reads must be.
struct MapDetail {
    int largestSize = 16384;                             ///< texels: maps without coarser levels are made no larger
    double tolerance = 1e-5;                             ///< rel_rms of the filters, (0, 1]
    int longBandLimit = std::numeric_limits<int>::max(); ///< specular lobes that the tolerance would have followed beyond it are promised
    double longTolerance = 1e-5; ///< this instead: those of a narrow lobe, or of one that begins with a step at its horizon
    double texelsPerLobe = std::numeric_limits<double>::infinity(); ///< maps are made smaller where their lobe spans more at half its peak
    int brdfColumns = 32;                                           ///< angles of view in the table of a BRDF's lookups
    double brdfTolerance = 1e-2;                                    ///< rel_rms of a BRDF that is drawn exactly
    /// Texels of the probe that a lobe spans at half its peak: for one that spans no more, the probe's own texels in their own layout may
    /// stand in, which costs nothing; 0: never.
    double probeItselfUpTo = 0.0;
    int discPixels = 0; ///< a scene's own sphere map is made no finer than for a disc of so many pixels across; 0: as the scene says
    bool operator==(const MapDetail&) const = default;
};

/// While a control is dragged: soft enough to be made between two frames, and near enough to judge by.
inline constexpr MapDetail coarseDetail{.largestSize = 128,
                                        .tolerance = 1e-3,
                                        .longBandLimit = 256,
                                        .longTolerance = 1e-2,
                                        .texelsPerLobe = 6.0,
                                        .brdfColumns = 8,
                                        .brdfTolerance = 0.1,
                                        .probeItselfUpTo = 4.0,
                                        .discPixels = 512};

/// Angle across a lobe at half its peak, and along the side of a square of a texel's mean solid angle; radians.
double lobeAngle(const Lobe& lobe);
double texelAngle(const MapLayout& layout);

struct PlanRequest {
    bool picture = true;                               ///< the maps that the view shows
    std::optional<std::vector<std::string>> exports{}; ///< names of exports; empty list: all of them; nothing: none
    PlanExtent extent = PlanExtent::Needed;
    MapDetail detail{}; ///< of specular and irradiance map
};

struct Plan {
    std::vector<PlannedStage> decisions{}; ///< in order
    PlannedMaterial material{};
    std::optional<MapPlan> specular{};
    std::optional<BrdfPlan> brdf{}; ///< how the specular map is read, or what stands for it
    std::optional<MapPlan> diffuse{};
    std::optional<MapPlan> clearCoat{};
    std::optional<MapPlan> background{};
    std::vector<SphereMapPlan> sphereMaps{}; ///< the material's, and behind it the layers of a window
    std::optional<SurfacePicturePlan> diffusePicture{}, fleckPattern{}, normalMap{};
    std::vector<MapPlan> others{}; ///< PlanExtent::Everything: the specular map in every other parameterization; not shown
    std::vector<ExportPlan> exports{};
    double sharedSeconds = 0.0; ///< of reading the probe and of its spectrum, CPU time, about

    /// The decisions in words; seconds are 0.
    std::vector<Stage> stages() const;
    bool needsProbe() const;
    /// Whether the material's BRDF is drawn from a view stack.
    bool isExact() const { return brdf && brdf->lookups.kind == LookupKind::Exact; }
    /// Every filter of the plan, for openFilterSource.
    std::vector<PrefilterOptions> filters() const;
    std::vector<const PlannedFilter*> planned() const;
    /// Whether any map is filtered, or a view stack made; otherwise the probe is only resampled and no spectrum is needed.
    bool filtersAny() const;
};

/// Whether anything that is asked for could be made of the probe: a picture, or an export that is no painted map.
bool mayNeedProbe(const Scene& scene, const PlanRequest& request);

/// @param probe  layout of the probe as its file's header tells it (probeLayout() in scene_maps.h); anything where !mayNeedProbe()
/// @throws InvalidArgument naming the field; for a painted export of a scene without a sphere map; for unknown export names, naming the
/// known ones
Plan makePlan(const Scene& scene, const MapLayout& probe, const PlanRequest& request = {});

/// The plan of filters of a probe without a scene around it: one export, in plan.exports.
/// @param source  of the probe, for messages. @throws as planPrefilter()
Plan planFilters(const std::string& source, const MapLayout& probe, const std::vector<PrefilterOptions>& levels, const std::string& file);

/// F where it is the same at every angle and in every channel: 1 without a Fresnel term, 0 for an index of 1.
std::optional<double> constantReflectance(const Fresnel& fresnel);

} // namespace mirrorball
