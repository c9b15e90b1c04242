#pragma once

#include "scene_maps.h"

#include "core/spheremap/document/sphere_map_document.h"
#include "core/spheremap/evaluation/painted_files.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

/// The NAME.json beside an exported map: what a reader of the map must know, as the text of one JSON object.
namespace mirrorball {

/// The direction by which a map of the probe is looked up: "direction", "reflection" or "normal".
std::string_view indexedBy(ExportKind kind);

std::string sidecar(const Scene& scene, const ExportPlan& planned, const std::vector<EnvironmentMap>& levels,
                    const std::vector<std::filesystem::path>& files, const WorkRecord& work);

/// Of a painted map: what looks it up, and whether its levels are painted or averages.
std::string paintedSidecar(const Scene& scene, const ExportPlan& planned, const SphereMapDocument& map,
                           const std::vector<PaintedSize>& levels, const std::vector<std::filesystem::path>& files);

} // namespace mirrorball
