#include "render_resources.h"

namespace mirrorball::preview {

namespace {

/// What the object is drawn with once more: its edges, sample by sample, over what is there.
class SampleShading {
public:
    SampleShading()
    {
        glEnable(GL_SAMPLE_SHADING);
        glMinSampleShading(1.0f);
        glDepthFunc(GL_LEQUAL);
        glDepthMask(GL_FALSE);
    }
    ~SampleShading()
    {
        glDisable(GL_SAMPLE_SHADING);
        glDepthFunc(GL_LESS);
        glDepthMask(GL_TRUE);
    }
    SampleShading(const SampleShading&) = delete;
    SampleShading& operator=(const SampleShading&) = delete;
};

} // namespace

// Samples of a pixel differ along the outline of the object alone: inside of it each pixel is shaded once, and the edge of a highlight or
// of a line of ink is a staircase. Where neighbors differ visibly each sample is shaded by itself, behind the display's curve, so that
// their mean is a step between both sides whatever the radiance of either. Everywhere else depth 0 keeps the object away before it is
// shaded.
void Renderer::Resources::smoothEdges(const RenderSettings& settings, const RenderMaps& maps, Output output, const RenderTarget& object)
{
    if (edgeFramebuffer == 0)
        edgeFramebuffer = makeFramebuffer();
    glNamedFramebufferTexture(edgeFramebuffer, GL_DEPTH_ATTACHMENT, object.depth, 0); // no color: that one is read
    glNamedFramebufferDrawBuffer(edgeFramebuffer, GL_NONE);
    glBindFramebuffer(GL_FRAMEBUFFER, edgeFramebuffer);
    glDepthFunc(GL_ALWAYS);
    const ShaderProgram& shader =
        programs.get({"preview/composite.vert", "preview/smooth.frag"}, {{"OBJECT_SAMPLES", std::to_string(object.samples)}});
    glBindTextureUnit(3, object.colors[0]);
    shader.set("objectSamples", 3);
    shader.use();
    glBindVertexArray(emptyVertexArray);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glBindVertexArray(0);
    glBindFramebuffer(GL_FRAMEBUFFER, object.framebuffer);
    const SampleShading sampleBySample;
    drawMaterial(settings, maps, output);
}

} // namespace mirrorball::preview
