#include "matcap_passes.h"

#include "core/base/error.h"
#include "core/base/field_checks.h"

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
    SphereMapDocument body = document;
    std::erase_if(body.layers, [&](const Layer& layer) {
        return std::find(specularLayers.begin(), specularLayers.end(), layer.name) != specularLayers.end();
    });
    MatcapPasses passes{.diffuse = overBlack(evaluate(body, options, job)), .specular = overBlack(evaluate(document, options, job))};
    for (size_t i = 0; i < passes.diffuse.texels.size(); ++i) {
        float &matt = passes.diffuse.texels[i], &shine = passes.specular.texels[i]; // of which the second is the whole still
        matt = std::min(matt, shine);
        shine -= matt;
    }
    return passes;
}

Image bordered(const Image& picture, int texels)
{
    Image result(picture.width + 2 * texels, picture.height + 2 * texels, picture.channels);
    for (int y = 0; y < result.height; ++y)
        for (int x = 0; x < result.width; ++x) {
            const int fromX = std::clamp(x - texels, 0, picture.width - 1), fromY = std::clamp(y - texels, 0, picture.height - 1);
            std::copy_n(picture.texel(fromX, fromY), picture.channels, result.texel(x, y));
        }
    return result;
}

} // namespace mirrorball
