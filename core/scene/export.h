#pragma once

#include "scene_maps.h"

#include <filesystem>
#include <string>
#include <vector>

namespace mirrorball {

struct ExportOptions {
    std::vector<std::string> only{}; ///< names of exports; empty: all of them
};

struct ExportOutcome {
    std::vector<std::filesystem::path> files{}; ///< everything written, in order
    WorkRecord record{};
};

/// Writes the scene's exports into a folder, which is made when missing. All share one reading of the probe and one forward transform.
///
/// Beside each map lies NAME.json, which says what a reader of the map must know: the files and their levels, parameterization and axes,
/// whether it is looked up by direction, reflection or normal, border, color space, lobe and the law from level to roughness, or whether
/// the levels of a painted map are painted or averages. Painted maps are the same bytes as `mirrorball paint` writes; the probe is not
/// opened where nothing else is exported.
/// All files come together, whole or not at all, and replace older ones; each NAME.json after its map, and last of all the manifest with
/// every file's size and checksum (FileTransaction).
/// @throws InvalidArgument naming the field, when there is nothing to export or `only` names an unknown export; WorkError; Cancelled
ExportOutcome exportScene(const Scene& scene, const std::filesystem::path& folder, const ExportOptions& options = {},
                          const JobControl& job = {});

/// The same in two steps: the plan, which opens the probe's header, and what is done as it says.
PlannedScene planExports(const Scene& scene, const ExportOptions& options = {});
ExportOutcome exportPlanned(PlannedScene planned, const std::filesystem::path& folder, const JobControl& job = {});

} // namespace mirrorball
