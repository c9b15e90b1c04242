#pragma once

#include "scene.h"

#include "core/engine/engine_export.h"

#include <filesystem>

namespace mirrorball {

/// Writes a scene's light as an engine takes it (engine_export.h): its probe with its yaw and exposure. Blender also gets the painted
/// sphere map, where the scene has one, as a MatCap in studiolights/matcap.
/// @param options  yaw and reading are the scene's and not looked at
/// @throws FileError, InvalidArgument naming the field, WorkError, Cancelled
EngineExport exportForEngine(const Scene& scene, const EngineProfile& profile, EngineExportOptions options,
                             const std::filesystem::path& folder, const JobControl& job = {});

/// What that will write, and what the files cannot hold of the scene's light; nothing is filtered. @throws as exportForEngine()
struct EngineEstimate {
    std::vector<EngineFilePlan> files{};
    std::vector<std::string> warnings{};
    std::int64_t bytes = 0; ///< in all, about
};
EngineEstimate estimateForEngine(const Scene& scene, const EngineProfile& profile, const EngineExportOptions& options,
                                 const JobControl& job = {});

/// The name that an export gets where none is given: the folder's own, as cmgen names its files; what no name may have becomes _.
std::string engineExportName(const std::filesystem::path& folder);

} // namespace mirrorball
