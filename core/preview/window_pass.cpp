#include "render_resources.h"

#include "window_mesh.h"
#include "window_view.h"

#include "core/base/error.h"

#include <cmath>

namespace mirrorball::preview {

void Renderer::Resources::drawWindow(const RenderSettings& settings, const RenderMaps& maps, Output output)
{
    const size_t layers = maps.sphereMaps.size();
    if (layers < 1 || layers > 3)
        throw InvalidArgument("material.sphere_map.source: a window shows a sphere map outside; name one, such as studio-clay");
    std::vector<ShaderDefine> defines = {{"HAS_TEXCOORD", "1"},
                                         {"SPHERE_VERTEX", "0"},
                                         {"WINDOW_LAYERS", std::to_string(layers)},
                                         {"WINDOW_SPACE", spaceDefine(settings.material.paint.space)}};
    addOutputDefines(defines, settings, output, settings.objectCurve.value_or(settings.toneCurve));
    const ShaderProgram& shader = programs.get({"preview/object.vert", "preview/window.frag"}, defines, outputPrelude(settings, output));
    displayTables.bind(shader, displayUnit);
    for (size_t i = 0; i < layers; ++i) {
        const auto unit = static_cast<GLuint>(4 + i);
        sphereMaps[i].update(maps.sphereMaps[i], "sphere map");
        sphereMaps[i].bind(unit, settings.material.paint.anisotropy, i == 0 ? settings.material.paint.onlyLevel : std::nullopt);
        shader.set(("windowLayer" + std::to_string(i)).c_str(), static_cast<int>(unit));
    }
    setWindowView(settings, shader);
    shader.set("layerDepths", glm::vec4(settings.windowDepths, 0.0f));
    shader.set("pane", glm::vec4(window::paneCenter, window::paneHalf));
    shader.set("exposure", std::exp2(settings.exposure));
    drawMesh(settings, shader);
}

void Renderer::Resources::setWindowView(const RenderSettings& settings, const ShaderProgram& shader)
{
    const double roll = rollToCancel(settings.camera.cameraToWorld());
    shader.set("reference", glm::vec4(windowReference, 0.0f));
    shader.set("worldToCamera", glm::transpose(settings.camera.cameraToWorld()));
    shader.set("rollCancelled", glm::vec4(std::cos(roll), std::sin(roll), 0.0f, 0.0f));
}

} // namespace mirrorball::preview
