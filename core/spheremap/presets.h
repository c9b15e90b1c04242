#pragma once

#include "sphere_map_document.h"

#include <span>
#include <string>
#include <string_view>

namespace mirrorball {

/// A built-in sphere map: a document of resources/spheremaps, compiled in.
struct SphereMapPreset {
    std::string name{};        ///< "gooch": its file's name without the extension
    std::string title{};       ///< "Cold and warm"
    std::string description{}; ///< one sentence
    SphereMapDocument document{};
};

/// All of them, in the order a list should show them.
std::span<const SphereMapPreset> sphereMapPresets();
/// The preset of that name, or null.
const SphereMapPreset* findSphereMapPreset(std::string_view name);

/// A file of resources/spheremaps as text.
struct SphereMapFile {
    std::string_view name{};
    std::string_view text{};
};
std::span<const SphereMapFile> embeddedSphereMaps();

} // namespace mirrorball
