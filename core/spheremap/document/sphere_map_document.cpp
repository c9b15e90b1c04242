#include "sphere_map_document.h"

#include "core/base/error.h"
#include "core/base/field_checks.h"

#include <algorithm>

namespace mirrorball {

namespace {

void checkLayer(const std::string& path, const Layer& layer)
{
    if (layer.firstLevel > layer.lastLevel)
        throw InvalidArgument(path + ".last-level: must be at least first-level, " + std::to_string(layer.firstLevel) + "; it is " +
                              std::to_string(layer.lastLevel));
    if (layer.mask && kindOf(layer.mask->content).role != LayerRole::Generator)
        throw InvalidArgument(path + ".mask.content.kind: must be a generator, such as gradient or image; it is " +
                              inQuotes(kindOf(layer.mask->content).name));
}

bool isInPixels(const LayerContent& content)
{
    return std::visit(
        [](const auto& layer) {
            if constexpr (requires { layer.unit; })
                return layer.unit == WidthUnit::Pixels;
            else
                return false;
        },
        content);
}

} // namespace

void validate(const SphereMapDocument& document)
{
    SphereMapDocument::visitFields(document, RangeChecker(""));
    for (size_t i = 0; i < document.layers.size(); ++i)
        checkLayer("layers[" + std::to_string(i) + "]", document.layers[i]);
}

bool hasAuthoredLevels(const SphereMapDocument& document)
{
    return std::any_of(document.layers.begin(), document.layers.end(), [](const Layer& layer) {
        return layer.visible && (layer.firstLevel > 0 || layer.lastLevel < deepestLevel || isInPixels(layer.content) ||
                                 (layer.mask && isInPixels(layer.mask->content)));
    });
}

} // namespace mirrorball
