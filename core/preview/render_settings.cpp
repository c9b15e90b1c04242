#include "render_settings.h"

#include "core/base/error.h"

#include <algorithm>
#include <array>
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
    require(settings.pixelRatio > 0.0f && settings.pixelRatio <= 16.0f, "pixel ratio must lie between 0 and 16");
    require(std::isfinite(settings.camera.yaw) && std::isfinite(settings.camera.pitch) && std::isfinite(settings.camera.roll),
            "camera angles must be finite");
    require(glm::all(glm::lessThanEqual(glm::abs(settings.camera.target), glm::vec3(1e6f))), "camera target must be finite");
    require(std::isfinite(settings.camera.distance) && settings.camera.distance > 0.0f, "camera distance must be greater than 0");
    require(settings.camera.fieldOfView > 0.0f && settings.camera.fieldOfView < 3.14f, "field of view must lie between 0 and 180 degrees");
    require(std::isfinite(settings.material.lambda) && settings.material.lambda >= 0.0f, "lambda must be 0 or more");
    require(std::isfinite(settings.material.lambdaGrazing) && settings.material.lambdaGrazing >= 0.0f, "lambda grazing must be 0 or more");
    require(std::isfinite(settings.material.lodBias), "LOD bias must be finite");
    require(settings.material.anisotropy >= 1 && settings.material.anisotropy <= 16, "anisotropy must be 1 to 16");
    const PaintSettings& paint = settings.material.paint;
    require(paint.anisotropy >= 1 && paint.anisotropy <= 16, "anisotropy of the sphere map must be 1 to 16");
    require(paint.opacity >= 0.0f && paint.opacity <= 1.0f, "opacity of the sphere map must be 0 to 1");
    require(paint.flecks.density >= 0.0f && paint.flecks.density <= 1.0f, "density of flecks must be 0 to 1");
    require(paint.flecks.size > 0.0f && std::isfinite(paint.flecks.size), "size of flecks must be greater than 0");
    require(paint.flecks.spread >= 0.0f && std::isfinite(paint.flecks.spread), "spread of flecks must be 0 or more");
    require(glm::all(glm::greaterThanEqual(settings.windowDepths, glm::vec3(0.0f))), "depths outside a window must be 0 or more");
    require(std::isfinite(settings.exposure) && std::abs(settings.exposure) <= 64.0f, "exposure must lie between -64 and 64 EV");
    require(std::isfinite(settings.yaw), "yaw must be finite");
    require(settings.material.clearCoat.weight >= 0.0f && settings.material.clearCoat.weight <= 1.0f,
            "weight of the clear coat must be 0 to 1");
    require(settings.material.normalStrength >= 0.0f && std::isfinite(settings.material.normalStrength),
            "strength of the normal map must be 0 or more");
    validate(settings.material.fresnel);
    validate(Fresnel{.kind = FresnelKind::Dielectric, .index = settings.material.clearCoat.index});
}

glm::vec3 levelColor(float level)
{
    constexpr std::array<glm::vec3, 8> colors{{{0.03f, 0.09f, 0.6f},
                                               {0.0f, 0.45f, 0.75f},
                                               {0.02f, 0.45f, 0.08f},
                                               {0.85f, 0.75f, 0.03f},
                                               {0.9f, 0.28f, 0.02f},
                                               {0.65f, 0.02f, 0.02f},
                                               {0.7f, 0.05f, 0.6f},
                                               {1.0f, 1.0f, 1.0f}}};
    level = std::clamp(level, 0.0f, 7.0f);
    const auto below = std::min(static_cast<size_t>(level), colors.size() - 2);
    return glm::mix(colors[below], colors[below + 1], level - static_cast<float>(below));
}

// With F = 1 everywhere a coat hides the diffuse part altogether.
NeededMaps neededMaps(const RenderSettings& settings)
{
    const MaterialSettings& material = settings.material;
    const PaintUse paint = material.paint.use;
    const bool isWindow = settings.geometry.kind == GeometryKind::Window && !settings.geometry.mesh;
    const bool isShown = settings.shading == Shading::Material;
    const bool isMaterial = isShown && !isWindow && paint != PaintUse::Replace && paint != PaintUse::Multiply;
    const bool isLevels = settings.shading == Shading::Mips;
    const bool hidden = material.combine == Combine::Coat && material.fresnel.kind == FresnelKind::None && !material.hasBrdf;
    const bool hasDiffuse = isMaterial && material.diffuse != glm::vec3(0.0f) && !hidden;
    const bool showsNormals =
        !isWindow && (isShown || isLevels || settings.shading == Shading::Normals || settings.shading == Shading::Seams);
    const bool hasFlecks = isShown && !isWindow && paint != PaintUse::None && material.paint.flecks.density > 0.0f;
    return {.specular = (isMaterial || isLevels) && material.specular != glm::vec3(0.0f),
            .diffuse = hasDiffuse,
            .background = settings.background.kind == BackgroundKind::Environment,
            .sphereMap = isShown && (isWindow || paint != PaintUse::None),
            .diffusePicture = hasDiffuse && material.hasDiffusePicture,
            .fleckPattern = hasFlecks && material.paint.hasFleckPattern,
            .clearCoat = isMaterial && material.clearCoat.weight > 0.0f,
            .normalMap = showsNormals && material.normalStrength > 0.0f};
}

} // namespace mirrorball::preview
