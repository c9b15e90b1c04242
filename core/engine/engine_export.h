#pragma once

#include "engine_profile.h"
#include "sh_conventions.h"

#include "core/base/job.h"
#include "core/base/stage.h"
#include "core/filter/filter_source.h"
#include "core/image/environment_map.h"
#include "core/image/probe_statistics.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

/// From a probe to the files that an engine takes.
namespace mirrorball {

struct EngineExportOptions {
    int size = 0;                          ///< checkedSize(); 0: the profile's own
    std::string name = "light";            ///< of the export: letters, digits, - and _; names the files
    double yaw = 0.0;                      ///< radians; of the scene, beside what the profile turns
    double tolerance = 1e-4;               ///< of the filtered maps, rel_rms; the formats round to 5e-4 and more
    PackedColor atlas = PackedColor::Rgbp; ///< of PlayCanvas' atlas; Rgbm is the other one it takes
    std::optional<TexelFormat> texels{};   ///< of Bevy's cubes, in place of the profile's
    bool compressKtx2 = false;             ///< Zstandard
    std::string reading{};                 ///< what was asked of the probe's file, a JSON object, for NAME.json; empty: nothing
};

/// What one file will be.
struct EngineFilePlan {
    std::string file{}; ///< without the folder
    EngineContent content = EngineContent::Latlong;
    int size = 0;                    ///< edge of a face, height of a latlong; 0 for text
    int levels = 0;                  ///< 0 for text
    std::vector<double> roughness{}; ///< of the levels of a chain
    std::int64_t bytes = 0;          ///< exact for cubes, an estimate for compressed pictures and text
};

/// @param probe  the probe's layout, which says how large a latlong becomes
/// @throws InvalidArgument for a size that the engine does not take, or a name that is none
std::vector<EngineFilePlan> planEngineExport(const EngineProfile& profile, const EngineExportOptions& options, const MapLayout& probe);

/// What the engine's files cannot hold of a probe, a sentence each: light beyond the largest value, a sun that is most of the light.
std::vector<std::string> engineWarnings(const EngineProfile& profile, const ProbeStatistics& probe);

/// A file in memory, but for latlongs, which are written by their format.
struct EngineExport {
    std::vector<std::filesystem::path> files{};
    std::vector<std::string> warnings{};
    std::optional<ShQuality> sh{}; ///< where the profile has coefficients
    std::vector<Stage> stages{};
};

/// Writes every file of the profile into `folder`, which is made when missing; each appears whole or not at all. Beside them goes
/// NAME.json: engine, files, sizes, roughness of the levels, orientation, how the probe was read, warnings. Results do not depend on the
/// number of threads.
/// @param probe  with its texels in memory
/// @throws as planEngineExport(); WorkError; Cancelled
EngineExport exportForEngine(FilterSource& probe, const EngineProfile& profile, const EngineExportOptions& options,
                             const std::filesystem::path& folder, const JobControl& job = {});

/// A chain of ggx levels for a law, cubes in our convention, largest first. Level 0 of a law whose roughness there is 0 is the probe
/// itself.
std::vector<EnvironmentMap> lawChain(FilterSource& probe, RoughnessLaw law, int size, int levels, const EngineExportOptions& options,
                                     const JobControl& job = {});

/// The texture of a chain for a container, each level stored as `orientation` says.
Texture storedTexture(const std::vector<EnvironmentMap>& levels, const CubeOrientation& orientation, TexelFormat format);

/// PlayCanvas' atlas of a probe, as radiance.
Image playCanvasAtlas(FilterSource& probe, const EngineExportOptions& options, const JobControl& job = {});

} // namespace mirrorball
