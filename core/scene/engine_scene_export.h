#pragma once

#include "scene.h"

#include "core/engine/engine_export.h"

#include <filesystem>

namespace mirrorball {

/// Writes a scene's light as an engine takes it (engine_export.h): its probe with its yaw and exposure. Blender also gets the painted
/// sphere map, where the scene has one, as a MatCap in studiolights/matcap.
/// @param options  yaw is the scene's and not looked at
/// @throws FileError, InvalidArgument naming the field, WorkError, Cancelled
EngineExport exportForEngine(const Scene& scene, const EngineProfile& profile, EngineExportOptions options,
                             const std::filesystem::path& folder, const JobControl& job = {});

} // namespace mirrorball
