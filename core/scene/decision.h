#pragma once

#include "map_plan.h"

#include "core/base/stage.h"

#include <optional>
#include <string>
#include <variant>

/// What a plan decides of each stage, as data: the reason with its numbers. plan_words.h says it in words.
namespace mirrorball {

/// Reasons that need no numbers.
enum class Because {
    NoMapIsNeeded,
    NothingIsFiltered,
    SumsAreCheaper, ///< of every lobe, than a spectrum
    NoneIsNamed,    ///< in the scene
    NotAskedFor,    ///< by the export, or by the command
    NotAmongThoseAskedFor,
    EverythingIsAskedFor, ///< PlanExtent::Everything
    LobeIsMirror,
    SurfaceIsMirror, ///< of a picture, which shows the environment
    ExportIsOfMirror,
    CoatIsMirror,
    RoughnessIsZero, ///< of a chain's level
    SpecularWeightIsZero,
    SpecularColorIsBlack,
    IndexIsOne,        ///< of the material: it reflects nothing
    CoatIndexIsOne,    ///< of the clear coat
    ReflectanceIsZero, ///< F, for an index of 1
    ReflectanceIsOne,  ///< F, without a Fresnel term
    BrdfHoldsFresnel,  ///< inside its integral
    BrdfIsExact,       ///< drawn from maps of its own
    DiffuseWeightIsZero,
    DiffuseColorIsBlack,
    CoatMirrorsAll,
    RoomHasNoMaterial,
    SphereMapReplaces, ///< the reflection
    NoSphereMapForFlecks,
    FleckDensityIsZero,
    StrengthIsZero, ///< of the normal map
    LambdaHoldsNoLevel,
    LambdaIsTheSame, ///< at every angle
    FinestLevelIsEnough,
    BackdropIsOneColor,
    BackdropIsNone,
};

/// What is said of a filtered level beside what it is: how its method was chosen, and why it is smaller than asked for.
struct LevelChoice {
    std::optional<Method> asked{};  ///< the scene's own choice of method
    std::string refusal{};          ///< why that cannot do it, so that auto did; empty where it can
    int askedSize = 0;              ///< what the scene asks for, where the lobe is so smooth that less shows all of it; 0: that is made
    bool isForCompleteness = false; ///< PlanExtent::Everything
};

/// The probe is read: whole, or truncated row by row to a band limit.
struct ReadsProbe {
    std::string source{};
    MapLayout layout{};
    std::optional<int> streamedBandLimit{};
    bool isLargeAndWhole = false; ///< not every map is filtered
};
struct TransformsOnce {
    int lobes = 0;
};
struct FiltersLevel {
    PlannedFilter filter{};
    LevelChoice choice{};
};
/// The lobe is narrower than the probe's texels.
struct LooksUp {
    PrefilterPlan plan{};
};
struct ResamplesLevel {
    MapLayout from{}, to{};
    LevelChoice choice{};
};
struct IsProbeAlready {
    MapLayout layout{};
};
/// The mip levels of the picture's specular map.
struct HalvesForPicture {
    double lambda = 0.0, lodBias = 0.0;
    int levels = 0;
    bool perFace = false;
};
struct HalvesForExport {
    int levels = 0;
};
struct FileHoldsNoLevels {
    std::string file{};
};
struct ShowsDebugView {
    Shading shading = Shading::Normals;
};
struct DielectricAtEveryPixel {
    double index = 1.5;
};
struct MetalAtEveryPixel {
    std::string metal{};
};
struct LambdaAtEveryPixel {
    double grazing = 0.0;
};
struct BrdfAtEveryPixel {
    BrdfPlan brdf{};
};
struct FlecksAtEveryPixel {
    double density = 0.0, size = 0.0;
};
struct EvaluatesSphereMap {
    SphereMapPlan map{};
};
struct PaintsFile {
    SphereMapPlan map{};
    ExportTarget target{};
};
struct ReadsOneParameterization {
    Parameterization kind = Parameterization::Cube;
};
/// By the mesh's texture coordinates.
struct ReadsSurfacePicture {
    std::string source{};
};
struct MeshIsBuiltin {
    std::string geometry{};
};
struct ReadsMesh {
    std::string file{};
};
struct Draws {
    std::string geometry{};
    int width = 0, height = 0;
};
struct SavesFile {
    std::string file{};
};

using Decision = std::variant<Because, ReadsProbe, TransformsOnce, FiltersLevel, LooksUp, ResamplesLevel, IsProbeAlready, HalvesForPicture,
                              HalvesForExport, FileHoldsNoLevels, ShowsDebugView, DielectricAtEveryPixel, MetalAtEveryPixel,
                              LambdaAtEveryPixel, BrdfAtEveryPixel, FlecksAtEveryPixel, EvaluatesSphereMap, PaintsFile,
                              ReadsOneParameterization, ReadsSurfacePicture, MeshIsBuiltin, ReadsMesh, Draws, SavesFile>;

/// One stage of a plan: made, or left out, and why.
struct PlannedStage {
    std::string name{}; ///< a stage that touches files has read, load, write or save in its name
    bool isLeftOut = false;
    Decision why{};
    StageCost expected{}; ///< about; none where it is not worth telling, or where nothing is made
};

} // namespace mirrorball
