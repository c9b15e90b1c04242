#pragma once

#include "core/spheremap/evaluation/blend.h"

#include <string_view>

namespace mirrorball {

/// What a layer does: makes colors of its own, changes those below it point by point, or changes them as a whole picture.
enum class LayerRole { Generator, Adjustment, Warp };

/// A kind of layer, as files and forms name it.
struct LayerKind {
    std::string_view name{};  ///< the word in files
    std::string_view title{}; ///< for a list in a form
    std::string_view help{};  ///< one line, no full stop
    LayerRole role = LayerRole::Generator;
    BlendMode blend = BlendMode::Normal; ///< what a new layer of the kind is given; files that name none mean normal
};

} // namespace mirrorball
