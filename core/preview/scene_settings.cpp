#include "scene_settings.h"

#include "../error.h"

#include <algorithm>

namespace mirrorball::preview {

namespace {

float toRadians(double degrees)
{
    return static_cast<float>(degrees * pi / 180.0);
}

GeometryKind geometryKind(const std::string& word)
{
    if (word == "teapot")
        return GeometryKind::Teapot;
    if (word == "torus")
        return GeometryKind::Torus;
    if (word == "sphere")
        return GeometryKind::Sphere;
    throw InvalidArgument("view.geometry: '" + word + "' is not one of teapot, torus and sphere; mesh files cannot be read yet");
}

/// Finer the larger the picture is: the outline of a body of revolution stays within a pixel of its circle. Vertices are a third of a
/// frame's time on a software renderer.
int tessellation(int height)
{
    return std::clamp(height / 80, 9, 48);
}

} // namespace

RenderSettings renderSettings(const Scene& scene, const Plan& plan)
{
    const ViewSettings& view = scene.view;
    RenderSettings settings{.width = view.width, .height = view.height};
    settings.geometry = {.kind = geometryKind(view.geometry), .level = tessellation(view.height)};
    settings.camera = {.yaw = toRadians(view.camera.yawDeg),
                       .pitch = toRadians(view.camera.pitchDeg),
                       .distance = static_cast<float>(view.camera.distance),
                       .fieldOfView = toRadians(view.camera.fieldOfViewDeg),
                       .target = view.camera.target,
                       .projection = view.camera.projection == mirrorball::Projection::Orthographic ? Projection::Orthographic
                                                                                                    : Projection::Perspective};
    settings.material = {.specular = plan.material.specular,
                         .diffuse = plan.material.diffuse,
                         .fresnel = plan.material.fresnel,
                         .combine = plan.material.combine,
                         .lambda = static_cast<float>(scene.material.lambda),
                         .space = scene.map.space == MapSpace::Eye ? LookupSpace::Eye : LookupSpace::World};
    const BackdropSettings& background = view.background;
    settings.background = {.kind = background.kind == Backdrop::Color  ? BackgroundKind::Color
                                   : background.kind == Backdrop::None ? BackgroundKind::None
                                                                       : BackgroundKind::Environment,
                           .color = background.color};
    settings.yaw = toRadians(scene.probe.yawDeg);
    settings.exposure = static_cast<float>(view.exposure);
    settings.toneCurve = static_cast<ToneCurve>(view.toneCurve);
    validate(settings);
    return settings;
}

RenderMaps renderMaps(const SceneMaps& maps)
{
    return {.specular = maps.specular, .diffuse = maps.diffuse, .background = maps.background};
}

} // namespace mirrorball::preview
