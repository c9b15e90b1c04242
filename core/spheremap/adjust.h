#pragma once

#include "layer_kind.h"
#include "level.h"
#include "span.h"

/// Layers that change the colours below them, each point by itself.
namespace mirrorball {

/// 1 - x, and 0 for light brighter than 1.
struct InvertLayer {
    static constexpr LayerKind kind{"invert", "Invert", "dark becomes light", LayerRole::Adjustment};
    UnknownKeys unknown{};

    bool operator==(const InvertLayer&) const = default;
    template <typename Self, typename Visit>
    static void visitFields(Self&, Visit&&)
    {
    }
};

SpanAdjustment prepare(const InvertLayer& layer, const Level& level);

} // namespace mirrorball
