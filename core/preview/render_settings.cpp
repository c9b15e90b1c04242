#include "render_settings.h"

#include "../error.h"

#include <cmath>
#include <string>

namespace mirrorball::preview {

void validate(const RenderSettings& settings)
{
    const auto require = [](bool holds, const std::string& message) {
        if (!holds)
            throw InvalidArgument("render settings: " + message);
    };
    require(settings.width >= 1 && settings.width <= 16384 && settings.height >= 1 && settings.height <= 16384,
            "size must be 1 to 16384 pixels each way");
    require(settings.samples == 1 || settings.samples == 2 || settings.samples == 4, "samples must be 1, 2 or 4");
    require(settings.geometry.level >= 1 && settings.geometry.level <= 256, "geometry level must be 1 to 256");
    require(std::isfinite(settings.camera.yaw) && std::isfinite(settings.camera.pitch), "camera angles must be finite");
    require(std::isfinite(settings.camera.distance) && settings.camera.distance > 0.0f, "camera distance must be greater than 0");
    require(settings.camera.fieldOfView > 0.0f && settings.camera.fieldOfView < 3.14f, "field of view must lie between 0 and 180 degrees");
    require(std::isfinite(settings.material.lambda) && settings.material.lambda >= 0.0f, "lambda must be 0 or more");
    require(std::isfinite(settings.exposure) && std::abs(settings.exposure) <= 64.0f, "exposure must lie between -64 and 64 EV");
    require(std::isfinite(settings.yaw), "yaw must be finite");
    validate(settings.material.fresnel);
}

// With F = 1 everywhere a coat hides the diffuse part altogether.
NeededMaps neededMaps(const RenderSettings& settings)
{
    const MaterialSettings& material = settings.material;
    const bool hidden = material.combine == Combine::Coat && material.fresnel.kind == FresnelKind::None;
    return {.specular = material.specular != glm::vec3(0.0f),
            .diffuse = material.diffuse != glm::vec3(0.0f) && !hidden,
            .background = settings.background.kind == BackgroundKind::Environment};
}

} // namespace mirrorball::preview
