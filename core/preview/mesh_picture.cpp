#include "mesh_picture.h"

#include "offscreen_context.h"
#include "renderer.h"

#include <algorithm>

namespace mirrorball::preview {

namespace {

/// Light by the normal, brighter from above and from the right: what a filtered map of a window and a room would be, without a filter.
MapLevels softLight()
{
    EnvironmentMap map({Parameterization::Cube, 16, 0});
    for (int y = 0; y < map.image.height; ++y)
        for (int x = 0; x < map.image.width; ++x) {
            const glm::dvec3 d = texelDirection(map.layout, x, y);
            const auto light = static_cast<float>(0.55 + 0.3 * d.y + 0.2 * d.x + 0.1 * d.z);
            std::fill_n(map.image.texel(x, y), 3, std::max(light, 0.0f));
        }
    return std::make_shared<const std::vector<EnvironmentMap>>(1, std::move(map));
}

} // namespace

Image meshPicture(const Geometry& geometry, int edge)
{
    const CurrentContextGuard guard;
    OffscreenContext context;
    context.makeCurrent();
    RenderSettings settings{.width = edge, .height = edge, .geometry = geometry};
    settings.camera = {.yaw = 0.44f, .pitch = 0.31f, .distance = 3.6f, .fieldOfView = 0.63f};
    settings.background.kind = Backdrop::None;
    settings.toneCurve = ToneCurve::None;
    settings.material.specular = glm::vec3(0.0f);
    settings.material.diffuse = glm::vec3(0.7f);
    Renderer renderer; // last: it dies while its context is current
    return renderer.renderDisplay(settings, {.diffuse = softLight()});
}

} // namespace mirrorball::preview
