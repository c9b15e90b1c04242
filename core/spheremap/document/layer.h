#pragma once

#include "core/spheremap/evaluation/blend.h"
#include "core/spheremap/layers/adjust.h"
#include "core/spheremap/layers/blur.h"
#include "core/spheremap/layers/cold_warm.h"
#include "core/spheremap/layers/colorgram.h"
#include "core/spheremap/layers/hatching.h"
#include "core/spheremap/layers/image_layer.h"
#include "core/spheremap/layers/paint_layer.h"
#include "core/spheremap/layers/phong_lights.h"
#include "core/spheremap/layers/probe_layer.h"
#include "core/spheremap/layers/silhouette.h"
#include "core/spheremap/layers/toon.h"
#include "core/spheremap/layers/turn.h"
#include "core/spheremap/layers/window.h"
#include "core/spheremap/math/gradient.h"

#include <optional>
#include <span>
#include <string>
#include <variant>

/// Layers: what a sphere map is a stack of.
namespace mirrorball {

/// A layer of a kind that this version does not know: kept as it was read, so that it survives loading and saving.
struct UnknownLayer {
    static constexpr LayerKind kind{};
    std::string name{}; ///< the kind's word in the file
    std::string text{}; ///< JSON of its parameters
    bool operator==(const UnknownLayer&) const = default;
};

/// What a layer is: one of the kinds, each a plain struct of parameters with visitFields (fields.h) and a static `kind`.
/// To add a kind: its struct and its `prepare` in a file of its own, and its name here.
using LayerContent = std::variant<FillLayer, GradientLayer, WindowLayer, ColdWarmLayer, SilhouetteLayer, HatchingLayer, ToonLayer,
                                  ColorgramLayer, PhongLightsLayer, ProbeLayer, ImageLayer, PaintLayer, BlurLayer, TwistLayer, RotateLayer,
                                  HueSaturationLayer, CurvesLayer, PosterizeLayer, InvertLayer, UnknownLayer>;

/// All kinds but the unknown one, in the order of LayerContent.
std::span<const LayerKind> layerKinds();
/// A layer's kind; for an unknown one its name and nothing else.
LayerKind kindOf(const LayerContent& content);
/// A layer of a kind with its defaults; an UnknownLayer of that name where there is no such kind.
LayerContent makeContent(std::string_view kindName);

/// What of a mask's picture counts.
enum class MaskChannel { Luminance, Opacity };
std::span<const std::string_view> words(MaskChannel); // luminance opacity

/// Where a layer shows: the luminance of a generator, times its opacity, or its opacity alone.
struct Mask {
    LayerContent content = GradientLayer{};
    MaskChannel channel = MaskChannel::Luminance;
    bool invert = false;
    UnknownKeys unknown{};

    bool operator==(const Mask&) const = default;
    template <typename Self, typename Visit>
    static void visitFields(Self& self, Visit&& visit)
    {
        visit(Field{"content", "a generator: fill, gradient, image, paint, ..."}, self.content);
        visit(Field{"channel", "luminance: where the mask is bright; opacity: where it is there"}, self.channel);
        visit(Field{"invert", "shows the layer where the mask does not"}, self.invert);
    }
};

inline constexpr int deepestLevel = 16;

struct Layer {
    std::string name{};
    bool visible = true;
    double opacity = 1.0;
    BlendMode blend = BlendMode::Normal;
    LayerContent content = FillLayer{};
    std::optional<Mask> mask{};
    int firstLevel = 0;
    int lastLevel = deepestLevel;
    UnknownKeys unknown{};

    bool operator==(const Layer&) const = default;
    template <typename Self, typename Visit>
    static void visitFields(Self& self, Visit&& visit)
    {
        visit(Field{"name", "what the artist calls it"}, self.name);
        visit(Field{"visible", "takes part"}, self.visible);
        visit(Field{"opacity", "how much of it shows", 0, 1}, self.opacity);
        visit(Field{"blend", "how it meets what lies below"}, self.blend);
        visit(Field{"content", "its kind and the kind's parameters"}, self.content);
        visit(Field{"mask", "where it shows; null: everywhere"}, self.mask);
        visit(Field{"first-level", "largest level of a hand-made mip chain that it takes part in", 0, deepestLevel}, self.firstLevel);
        visit(Field{"last-level", "smallest level that it takes part in", 0, deepestLevel}, self.lastLevel);
    }
};

/// A layer as one adds it to a stack: of a kind, with its defaults, blended as such layers usually are.
Layer makeLayer(std::string_view kindName);

/// Checks the parameters of a layer's content. @throws InvalidArgument naming the field
void checkFields(const std::string& path, const LayerContent& content);

} // namespace mirrorball
