#include "scene_settings.h"

#include "core/base/error.h"
#include "core/base/field_checks.h"
#include "core/scene/display_curves.h"

#include <algorithm>

namespace mirrorball::preview {

namespace {

float toRadians(double degrees) { return static_cast<float>(degrees * pi / 180.0); }

/// Finer the larger the picture is: the outline of a body of revolution stays within a pixel of its circle. Vertices are a third of a
/// frame's time on a software renderer.
int tessellation(int height) { return std::clamp(height / 80, 9, 48); }

PaintSettings paintSettings(const mirrorball::SphereMapSettings& map)
{
    if (map.isNone())
        return {};
    return {.use = map.use,
            .opacity = static_cast<float>(map.opacity),
            .color = map.color,
            .space = map.space,
            .lookup = map.lookup,
            .flecks = map.flecks.cells};
}

} // namespace

std::optional<std::filesystem::path> meshFile(const Scene& scene)
{
    if (builtinGeometry(scene.view.geometry))
        return std::nullopt;
    return resolved(scene, scene.view.geometry);
}

std::optional<DisplayChoice> displayChoice(const Scene& scene)
{
    const DisplaySettings& display = scene.view.display;
    if (display.config.empty())
        return std::nullopt;
    return DisplayChoice{display.config == "env" ? display.config : resolved(scene, display.config), display.display, display.view};
}

std::string texCoordProblem(const Plan& plan, const Mesh& mesh, const std::string& geometry)
{
    const std::optional<SurfacePicturePlan>& picture = plan.diffusePicture ? plan.diffusePicture
                                                       : plan.fleckPattern ? plan.fleckPattern
                                                                           : plan.normalMap;
    if (!picture || !mesh.texCoords.empty())
        return {};
    return picture->field + ": " + inQuotes(picture->source) + " lies on the mesh by its texture coordinates, and " + inQuotes(geometry) +
           " has none; unwrap the mesh in a modeller, or leave the picture out";
}

RenderSettings renderSettings(const Scene& scene, const Plan& plan, std::shared_ptr<const Mesh> mesh,
                              std::shared_ptr<const DisplayTransform> display)
{
    const ViewSettings& view = scene.view;
    RenderSettings settings{.width = view.width, .height = view.height};
    settings.geometry.level = view.tessellation > 0 ? view.tessellation : tessellation(view.height);
    if (const std::optional<GeometryKind> body = builtinGeometry(view.geometry)) {
        settings.geometry.kind = *body;
    } else {
        if (!mesh)
            throw InvalidArgument("view.geometry: the mesh of '" + view.geometry + "' must be read first");
        if (const std::string problem = texCoordProblem(plan, *mesh, view.geometry); !problem.empty())
            throw InvalidArgument(problem);
        settings.geometry.mesh = std::move(mesh);
    }
    settings.shading = view.shading;
    settings.seamsOf = scene.map.parameterization;
    settings.camera = {.yaw = toRadians(view.camera.yawDeg),
                       .pitch = toRadians(view.camera.pitchDeg),
                       .roll = toRadians(view.camera.rollDeg),
                       .distance = static_cast<float>(view.camera.distance),
                       .fieldOfView = toRadians(view.camera.fieldOfViewDeg),
                       .target = view.camera.target,
                       .projection = view.camera.projection};
    settings.material = {.specular = plan.material.specular,
                         .diffuse = plan.material.diffuse,
                         .hasBrdf = plan.brdf.has_value(),
                         .isExact = plan.isExact(),
                         .fresnel = plan.material.fresnel,
                         .combine = plan.material.combine,
                         .clearCoat = {.weight = static_cast<float>(plan.material.clearCoat),
                                       .index = plan.material.clearCoatIndex,
                                       .combine = plan.material.clearCoatCombine},
                         .lambda = static_cast<float>(scene.material.lambda),
                         .lambdaGrazing = static_cast<float>(scene.material.lambdaGrazing),
                         .faceEdges = scene.map.mipFiltering == MipFiltering::PerFace ? FaceEdges::Clamped : FaceEdges::Seamless,
                         .lodBias = static_cast<float>(scene.material.lodBias),
                         .anisotropy = scene.map.anisotropy,
                         .space = scene.map.space};
    settings.material.hasDiffusePicture = plan.diffusePicture.has_value();
    settings.material.normalStrength = plan.normalMap ? static_cast<float>(scene.material.normalMap.strength) : 0.0f;
    settings.material.paint = paintSettings(scene.material.sphereMap);
    settings.material.paint.hasFleckPattern = plan.fleckPattern.has_value();
    settings.windowDepths = {view.window.depth, view.window.middle.empty() ? view.window.farDepth : view.window.middleDepth,
                             view.window.farDepth};
    settings.background = {.kind = view.background.kind, .color = view.background.color};
    settings.yaw = toRadians(scene.probe.yawDeg);
    settings.exposure = static_cast<float>(view.exposure);
    settings.display = std::move(display);
    const DisplayCurves curves = displayCurves(scene);
    settings.toneCurve = curves.behind;
    if (curves.object != curves.behind)
        settings.objectCurve = curves.object;
    settings.dither = view.dither;
    validate(settings);
    return settings;
}

RenderMaps renderMaps(const SceneMaps& maps)
{
    return {.specular = maps.specular,
            .diffuse = maps.diffuse,
            .background = maps.background,
            .brdfLookups = maps.brdfLookups,
            .viewStack = maps.viewStack,
            .sphereMaps = maps.sphereMaps,
            .diffusePicture = maps.diffusePicture,
            .fleckPattern = maps.fleckPattern,
            .clearCoat = maps.clearCoat,
            .normalMap = maps.normalMap};
}

} // namespace mirrorball::preview
