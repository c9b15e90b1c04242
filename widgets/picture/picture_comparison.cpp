#include "picture_comparison.h"

#include <epoxy/gl.h>

namespace mirrorball::studio {

namespace {

constexpr const char* vertexText =
    "void main() { gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0); }\n";
constexpr const char* fragmentText =
    "uniform sampler2D pictureA;\nuniform sampler2D pictureB;\nuniform float gain;\nlayout(location = 0) out vec4 result;\n"
    "void main() {\n"
    "    ivec2 p = ivec2(gl_FragCoord.xy);\n"
    "    result = vec4(gain * abs(texelFetch(pictureA, p, 0).rgb - texelFetch(pictureB, p, 0).rgb), 1.0);\n"
    "}\n";

} // namespace

unsigned PictureDifference::target(int index, int width, int height)
{
    preview::RenderTarget& slot = m_targets[index];
    if (!slot.fits(width, height, 1, GL_RGBA8)) {
        slot = preview::RenderTarget();
        slot = preview::RenderTarget(width, height, 1, GL_RGBA8, 1, GL_NONE);
    }
    return slot.framebuffer;
}

void PictureDifference::draw(unsigned framebuffer, float gain)
{
    if (!m_program) {
        m_program = std::make_unique<preview::ShaderProgram>(preview::resolveIncludes("difference.vert", vertexText),
                                                             preview::resolveIncludes("difference.frag", fragmentText));
        m_vertexArray = preview::makeVertexArray();
    }
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glViewport(0, 0, m_targets[0].width, m_targets[0].height);
    for (unsigned i = 0; i < 2; ++i)
        glBindTextureUnit(i, m_targets[i].colors[0]);
    m_program->set("pictureA", 0);
    m_program->set("pictureB", 1);
    m_program->set("gain", gain);
    m_program->use();
    glBindVertexArray(m_vertexArray);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glBindVertexArray(0);
    glUseProgram(0);
}

} // namespace mirrorball::studio
