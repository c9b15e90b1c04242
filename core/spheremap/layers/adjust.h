#pragma once

#include "core/spheremap/document/layer_kind.h"
#include "core/spheremap/math/curve_table.h"
#include "core/spheremap/math/level.h"
#include "core/spheremap/math/span.h"

#include <span>
#include <string_view>
#include <vector>

/// Layers that change the colors below them, each point by itself. Curves and steps work on the square root of a channel, which is about
/// what the eye and a display make of light, and on light of any size.
namespace mirrorball {

/// Hue, saturation and value of the hexcone model: V is the largest channel, S = (V - smallest)/V. Brighter than 1 stays so.
struct HueSaturationLayer {
    static constexpr LayerKind kind{"hue-saturation", "Hue, saturation, value", "turns hues, strengthens or weakens colors and brightness",
                                    LayerRole::Adjustment};
    double hueDeg = 0.0;
    double saturation = 1.0;
    double value = 1.0;
    UnknownKeys unknown{};

    bool operator==(const HueSaturationLayer&) const = default;
    template <typename Self, typename Visit>
    static void visitFields(Self& self, Visit&& visit)
    {
        visit(Field{"hue", "turn of the hue: 120 makes red green", -360, 360, "degrees"}, self.hueDeg);
        visit(Field{"saturation", "factor; 0: gray; at most as much as a color can hold", 0, 10}, self.saturation);
        visit(Field{"value", "factor of the brightness", 0, 1000}, self.value);
    }
};

/// Which channels an adjustment changes.
enum class AdjustedChannels { All, Red, Green, Blue };
std::span<const std::string_view> words(AdjustedChannels); // all red green blue

/// A tone curve (curve_table.h) on the square root of channels. Light brighter than 1 keeps its ratios.
struct CurvesLayer {
    static constexpr LayerKind kind{"curves", "Curves", "a tone curve for all channels or one", LayerRole::Adjustment};
    AdjustedChannels channels = AdjustedChannels::All;
    std::vector<CurvePoint> points{{0.0, 0.0}, {0.25, 0.19}, {0.75, 0.81}, {1.0, 1.0}};
    UnknownKeys unknown{};

    bool operator==(const CurvesLayer&) const = default;
    template <typename Self, typename Visit>
    static void visitFields(Self& self, Visit&& visit)
    {
        visit(Field{"channels", "which of them it changes"}, self.channels);
        visit(Field{"points", "of the curve, from dark to bright", 2, 32}, self.points);
    }
};

/// Steps of equal height on the square root of each channel.
struct PosterizeLayer {
    static constexpr LayerKind kind{"posterize", "Posterize", "few tones instead of many", LayerRole::Adjustment};
    int tones = 5;
    double softness = 0.1;
    UnknownKeys unknown{};

    bool operator==(const PosterizeLayer&) const = default;
    template <typename Self, typename Visit>
    static void visitFields(Self& self, Visit&& visit)
    {
        visit(Field{"tones", "from black to white", 2, 64}, self.tones);
        visit(Field{"softness", "part of a step that is a slope", 0, 1}, self.softness);
    }
};

/// 1 - x on the square root of each channel, 0 for light brighter than 1: twice inverted is as before.
struct InvertLayer {
    static constexpr LayerKind kind{"invert", "Invert", "dark becomes light", LayerRole::Adjustment};
    UnknownKeys unknown{};

    bool operator==(const InvertLayer&) const = default;
    template <typename Self, typename Visit>
    static void visitFields(Self&, Visit&&)
    {
    }
};

SpanAdjustment prepare(const HueSaturationLayer& layer, const Level& level);
SpanAdjustment prepare(const CurvesLayer& layer, const Level& level);
SpanAdjustment prepare(const PosterizeLayer& layer, const Level& level);
SpanAdjustment prepare(const InvertLayer& layer, const Level& level);

} // namespace mirrorball
