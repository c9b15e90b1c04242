#include "render_settings.h"

#include "core/base/error.h"
#include "core/base/field_checks.h"
#include "core/scene/scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace mirrorball::preview {

namespace {

template <typename Settings>
void checkRanges(const std::string& path, const Settings& settings)
{
    Settings::visitFields(settings, RangeChecker(path));
}

/// What a scene has the same field for is held to its range there; errors name that field.
void checkFieldsOfScene(const RenderSettings& settings)
{
    const std::string path = "render settings", painted = path + ": sphere map";
    const PaintSettings& paint = settings.material.paint;
    const ClearCoat& coat = settings.material.clearCoat;
    const glm::vec3& depths = settings.windowDepths;
    checkRanges(path, ViewSettings{.tessellation = settings.geometry.level,
                                   .window = {.depth = depths.x, .middleDepth = depths.y, .farDepth = depths.z},
                                   .exposure = settings.exposure,
                                   .width = settings.width,
                                   .height = settings.height});
    checkRanges(path, MapSettings{.anisotropy = settings.material.anisotropy});
    checkRanges(painted, MapSettings{.anisotropy = paint.anisotropy});
    checkRanges(painted, SphereMapSettings{.opacity = paint.opacity, .flecks = {.cells = paint.flecks}});
    checkRanges(path + ": clear coat", ClearCoatSettings{.weight = coat.weight, .index = coat.index});
}

} // namespace

// Checked here is what no scene has a field for, and what may be more than a scene says: camera and levels need only be what can be
// computed.
void validate(const RenderSettings& settings)
{
    checkFieldsOfScene(settings);
    const auto require = [](bool holds, const std::string& message) {
        if (!holds)
            throw InvalidArgument("render settings: " + message);
    };
    require(settings.samples == 1 || settings.samples == 2 || settings.samples == 4, "samples must be 1, 2 or 4");
    require(settings.geometry.level >= 1, "geometry level must be 1 or more");
    require(settings.pixelRatio > 0.0f && settings.pixelRatio <= 16.0f, "pixel ratio must lie between 0 and 16");
    require(std::isfinite(settings.camera.yaw) && std::isfinite(settings.camera.pitch) && std::isfinite(settings.camera.roll),
            "camera angles must be finite");
    require(glm::all(glm::lessThanEqual(glm::abs(settings.camera.target), glm::vec3(1e6f))), "camera target must be finite");
    require(std::isfinite(settings.camera.distance) && settings.camera.distance > 0.0f, "camera distance must be greater than 0");
    require(settings.camera.fieldOfView > 0.0f && settings.camera.fieldOfView < 3.14f, "field of view must lie between 0 and 180 degrees");
    require(std::isfinite(settings.material.lambda) && settings.material.lambda >= 0.0f, "lambda must be 0 or more");
    require(std::isfinite(settings.material.lambdaGrazing) && settings.material.lambdaGrazing >= 0.0f, "lambda grazing must be 0 or more");
    require(std::isfinite(settings.material.lodBias), "LOD bias must be finite");
    require(std::isfinite(settings.yaw), "yaw must be finite");
    require(settings.material.normalStrength >= 0.0f && std::isfinite(settings.material.normalStrength),
            "strength of the normal map must be 0 or more");
    validate(settings.material.fresnel);
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
    const std::optional<SphereMapUse> paint = material.paint.use;
    const bool isWindow = settings.geometry.kind == GeometryKind::Window && !settings.geometry.mesh;
    const bool isShown = settings.shading == Shading::Material;
    const bool isMaterial = isShown && !isWindow && !(paint && hidesMaterial(*paint));
    const bool isLevels = settings.shading == Shading::Mips;
    const bool hidden = material.combine == Combine::Coat && material.fresnel.kind == FresnelKind::None && !material.hasBrdf;
    const bool hasDiffuse = isMaterial && material.diffuse != glm::vec3(0.0f) && !hidden;
    const bool showsNormals =
        !isWindow && (isShown || isLevels || settings.shading == Shading::Normals || settings.shading == Shading::Seams);
    const bool hasFlecks = isShown && !isWindow && paint && material.paint.flecks.density > 0.0f;
    const bool isExact = material.hasBrdf && material.isExact, mirrors = material.specular != glm::vec3(0.0f);
    return {.specular = (isMaterial || isLevels) && mirrors && !isExact,
            .diffuse = hasDiffuse,
            .background = isEnvironment(settings.background.kind),
            .sphereMap = isShown && (isWindow || paint),
            .diffusePicture = hasDiffuse && material.hasDiffusePicture,
            .fleckPattern = hasFlecks && material.paint.hasFleckPattern,
            .clearCoat = isMaterial && material.clearCoat.weight > 0.0f,
            .normalMap = showsNormals && material.normalStrength > 0.0f,
            .viewStack = isMaterial && mirrors && isExact};
}

} // namespace mirrorball::preview
