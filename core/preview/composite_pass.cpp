#include "render_resources.h"

#include "core/sphere/direction.h"

#include <cmath>

namespace mirrorball::preview {

glm::mat3 yawToMap(float yaw)
{
    return {glm::vec3(yawed({1, 0, 0}, -yaw)), glm::vec3(yawed({0, 1, 0}, -yaw)), glm::vec3(yawed({0, 0, 1}, -yaw))};
}

void addOutputDefines(std::vector<ShaderDefine>& defines, const RenderSettings& settings, Output output, ToneCurve curve)
{
    defines.emplace_back("OUTPUT_RADIANCE", output == Output::Radiance ? "1" : "0");
    defines.emplace_back("DISPLAY_OCIO", output == Output::Display && settings.display ? "1" : "0");
    defines.emplace_back("TONE_CURVE", output == Output::Radiance ? "0" : std::to_string(static_cast<int>(curve)));
}

std::string_view outputPrelude(const RenderSettings& settings, Output output)
{
    return output == Output::Display && settings.display ? std::string_view(settings.display->glsl) : std::string_view();
}

void Renderer::Resources::drawComposite(const RenderSettings& settings, const RenderMaps& maps, Output output,
                                        const Destination& destination, const PixelRectangle& part, const GlObject* object)
{
    if (part.width <= 0 || part.height <= 0)
        return;
    std::vector<ShaderDefine> defines = {{"OBJECT_SAMPLES", object ? std::to_string(settings.samples) : "0"}};
    defines.emplace_back("DITHER", settings.dither && output == Output::Display ? "1" : "0");
    addOutputDefines(defines, settings, output, settings.toneCurve);
    const EnvironmentTexture* texture = nullptr;
    switch (settings.background.kind) {
    case Backdrop::None:
        defines.emplace_back("BACKGROUND", "0");
        break;
    case Backdrop::Color:
        defines.emplace_back("BACKGROUND", "1");
        break;
    case Backdrop::Environment:
    case Backdrop::Blurred:
        defines.emplace_back("BACKGROUND", "2");
        // The environment is often the specular map itself: one texture then serves both.
        texture = specular.texture() && specular.source() == maps.background ? specular.texture()
                                                                             : &background.update(maps.background, format, "background");
        addMapDefines(defines, "BACKGROUND", *texture);
        break;
    }

    const ShaderProgram& shader =
        programs.get({"preview/composite.vert", "preview/composite.frag"}, defines, outputPrelude(settings, output));
    displayTables.bind(shader, displayUnit);
    if (texture)
        bindMap(shader, "background", 2, *texture, yawToMap(settings.yaw));
    if (object) {
        glBindTextureUnit(3, *object);
        shader.set("objectSamples", 3);
    }
    shader.set("backgroundColor", settings.background.color);
    shader.set("exposure", std::exp2(settings.exposure));
    shader.set("halfExtent", glm::vec3(settings.camera.halfExtent(float(settings.width) / float(settings.height)), 0.0f));
    shader.set("cameraToWorld", settings.camera.cameraToWorld());
    shader.set("corner", glm::vec4(destination.x, destination.y, 0.0f, 0.0f));
    shader.use();
    glEnable(GL_SCISSOR_TEST);
    glScissor(destination.x + part.x, destination.y + part.y, part.width, part.height);
    glBindVertexArray(emptyVertexArray);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glBindVertexArray(0);
}

} // namespace mirrorball::preview
