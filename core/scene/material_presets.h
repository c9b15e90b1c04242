#pragma once

#include "scene.h"

#include <span>
#include <string_view>

namespace mirrorball {

struct MaterialPreset {
    std::string_view name;        ///< "car-paint"
    std::string_view description; ///< one sentence
    Material material;
};

/// The built-in materials, in the order a list should show them.
std::span<const MaterialPreset> materialPresets();
/// The preset of that name, or null.
const MaterialPreset* findMaterialPreset(std::string_view name);

} // namespace mirrorball
