#pragma once

#include "sphere_map_document.h"

#include <span>
#include <string>
#include <string_view>

namespace mirrorball {

/// A built-in sphere map: a document of resources, compiled in.
struct SphereMapPreset {
    std::string name{};        ///< "gooch": its file's name without the extension
    std::string title{};       ///< "Cold and warm"
    std::string description{}; ///< one sentence
    SphereMapDocument document{};
};

/// All that are made for models, in the order a list should show them: resources/spheremaps.
std::span<const SphereMapPreset> sphereMapPresets();
/// What may lie outside a window, the nearest first, each transparent where a farther one shows: some of resources/scenes.
std::span<const SphereMapPreset> windowViewPresets();
/// The preset of that name among both, or null.
const SphereMapPreset* findSphereMapPreset(std::string_view name);

/// A file of theirs as text.
struct SphereMapFile {
    std::string_view name{};
    std::string_view text{};
};
std::span<const SphereMapFile> embeddedSphereMaps();
std::span<const SphereMapFile> embeddedWindowViews();

} // namespace mirrorball
