#include "layer.h"

#include "core/base/field_checks.h"

#include <array>

namespace mirrorball {

namespace {

using namespace std::string_view_literals;
constexpr std::array maskChannelWords{"luminance"sv, "opacity"sv};
constexpr std::array widthUnitWords{"disc"sv, "pixels"sv};
constexpr std::array indexWords{"normal"sv, "reflection"sv};

constexpr size_t kindCount = std::variant_size_v<LayerContent> - 1; // without the unknown one

template <size_t... i>
constexpr std::array<LayerKind, kindCount> allKinds(std::index_sequence<i...>)
{
    return {std::variant_alternative_t<i, LayerContent>::kind...};
}
constexpr auto kinds = allKinds(std::make_index_sequence<kindCount>{});

template <size_t... i>
LayerContent contentAt(size_t index, std::index_sequence<i...>)
{
    LayerContent content;
    (void)((i == index && (content.emplace<i>(), true)) || ...);
    return content;
}

} // namespace

std::span<const std::string_view> words(MaskChannel) { return maskChannelWords; }
std::span<const std::string_view> words(WidthUnit) { return widthUnitWords; }
std::span<const std::string_view> words(SphereMapIndex) { return indexWords; }

std::span<const LayerKind> layerKinds() { return kinds; }

LayerKind kindOf(const LayerContent& content)
{
    if (const auto* unknown = std::get_if<UnknownLayer>(&content))
        return {.name = unknown->name, .title = unknown->name};
    return kinds[content.index()];
}

LayerContent makeContent(std::string_view kindName)
{
    for (size_t i = 0; i < kindCount; ++i)
        if (kinds[i].name == kindName)
            return contentAt(i, std::make_index_sequence<kindCount>{});
    return UnknownLayer{.name = std::string(kindName), .text = "{}"};
}

Layer makeLayer(std::string_view kindName)
{
    Layer layer{.content = makeContent(kindName)};
    layer.blend = kindOf(layer.content).blend;
    return layer;
}

void checkFields(const std::string& path, const LayerContent& content)
{
    std::visit(
        [&](const auto& layer) {
            using Kind = std::decay_t<decltype(layer)>;
            if constexpr (hasFields<Kind>)
                Kind::visitFields(layer, RangeChecker(path));
        },
        content);
}

} // namespace mirrorball
