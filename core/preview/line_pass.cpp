#include "render_resources.h"

#include <algorithm>

namespace mirrorball::preview {

namespace {
constexpr int mostNormals = 3000; ///< lines that a picture can show apart
constexpr float lineWidth = 1.5f; ///< pixels of the window
} // namespace

void Renderer::Resources::drawLines(const RenderSettings& settings, Output output)
{
    const bool ofNormals = settings.shading == Shading::NormalLines;
    const MeshBuffer& buffer = mesh(settings.geometry);
    const ShaderProgram& shader =
        programs.get({"preview/lines.vert", "preview/lines.frag", "preview/lines.geom"},
                     {{"LINES_OF", ofNormals ? "1" : "2"}, {"ENCODED", settings.display && output == Output::Display ? "1" : "0"}});
    const BoundingBox& box = buffer.bounds();
    shader.set("worldToClip", worldToClip(settings, drawnBounds(settings, box)));
    shader.set("viewport", glm::vec4(settings.width, settings.height, 0.5f * lineWidth * settings.pixelRatio, 0.0f));
    shader.set("everyNth", ofNormals ? std::max(1, buffer.vertexCount() / mostNormals) : 1);
    shader.set("lineLength", normalLineLength);
    shader.set("boxLow", glm::vec4(box.low, 0.0f));
    shader.set("boxHigh", glm::vec4(box.high, 0.0f));
    shader.set("lineColor", ofNormals ? glm::vec3(0.1f, 0.55f, 0.9f) : glm::vec3(0.9f, 0.55f, 0.1f));
    shader.use();
    if (ofNormals) {
        buffer.drawVertices();
        return;
    }
    glBindVertexArray(emptyVertexArray);
    glDrawArrays(GL_POINTS, 0, 12);
    glBindVertexArray(0);
}

} // namespace mirrorball::preview
