#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

/// The command line that does what a dialog is about to do.
namespace mirrorball {

/// `mirrorball export SCENE -o DIR [--only=NAME...]`: writes the same bytes as exportScene() on the scene that was saved as `sceneFile`.
/// @param only  names of exports; empty: all of them, and no --only
std::string exportCommand(const std::filesystem::path& sceneFile, const std::filesystem::path& folder,
                          const std::vector<std::string>& only = {});

/// `mirrorball export SCENE --for ENGINE [--size N] -o DIR`: the same for exportForEngine(). @param size  0: the engine's own, and no
/// --size
std::string engineExportCommand(const std::filesystem::path& sceneFile, const std::filesystem::path& folder, std::string_view engine,
                                int size = 0);

} // namespace mirrorball
