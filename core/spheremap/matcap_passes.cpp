#include "matcap_passes.h"

#include "../error.h"
#include "../field_checks.h"

#include <algorithm>
#include <functional>
#include <vector>

namespace mirrorball {

namespace {

Image overBlack(const Image& rgba)
{
    Image rgb(rgba.width, rgba.height, 3);
    for (size_t i = 0; i < rgb.texels.size() / 3; ++i)
        std::copy_n(&rgba.texels[4 * i], 3, &rgb.texels[3 * i]); // they are multiplied by their opacity
    return rgb;
}

/// Light that is added below a layer passes through it when what the layer does is linear in what lies below.
bool letsLightThrough(const Layer& layer)
{
    const LayerRole role = kindOf(layer.content).role;
    return role == LayerRole::Warp || (role == LayerRole::Generator && layer.blend == BlendMode::Multiply);
}

/// The layers that shine, over black, and what lies above the lowest of them and dims or moves its light.
std::vector<Layer> shineOf(const std::vector<Layer>& layers, const std::function<bool(const Layer&)>& shines)
{
    std::vector<Layer> shine{{.name = "Black", .content = FillLayer{.color = glm::dvec3(0.0)}}};
    for (const Layer& layer : layers) {
        const bool isLowest = shine.size() == 1;
        if (shines(layer))
            shine.push_back(layer);
        else if (!isLowest && letsLightThrough(layer))
            shine.push_back(layer);
        else
            continue;
        if (isLowest)
            shine.back().blend = BlendMode::Normal; // black takes neither overlay nor multiply
    }
    return shine;
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
    specular.layers = shineOf(document.layers, shines);
    return {overBlack(evaluate(diffuse, options, job)), overBlack(evaluate(specular, options, job))};
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
