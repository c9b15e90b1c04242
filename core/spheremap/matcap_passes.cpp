#include "matcap_passes.h"

#include "../error.h"
#include "../field_checks.h"

#include <algorithm>

namespace mirrorball {

namespace {

Image overBlack(const Image& rgba)
{
    Image rgb(rgba.width, rgba.height, 3);
    for (size_t i = 0; i < rgb.texels.size() / 3; ++i)
        std::copy_n(&rgba.texels[4 * i], 3, &rgb.texels[3 * i]); // they are multiplied by their opacity
    return rgb;
}

} // namespace

MatcapPasses evaluatePasses(const SphereMapDocument& document, std::span<const std::string> specularLayers, const EvaluateOptions& options,
                            const JobControl& job)
{
    for (const std::string& name : specularLayers)
        if (std::none_of(document.layers.begin(), document.layers.end(), [&](const Layer& layer) { return layer.name == name; }))
            throw InvalidArgument("specular: no layer is called " + inQuotes(name));
    SphereMapDocument diffuse = document, specular = document;
    const auto shines = [&](const Layer& layer) {
        return std::find(specularLayers.begin(), specularLayers.end(), layer.name) != specularLayers.end();
    };
    std::erase_if(diffuse.layers, shines);
    std::erase_if(specular.layers, [&](const Layer& layer) { return !shines(layer); });
    return {overBlack(evaluate(diffuse, options, job)), overBlack(evaluate(specular, options, job))};
}

} // namespace mirrorball
