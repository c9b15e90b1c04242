#pragma once

#include "core/base/error.h"
#include "core/preview/offscreen_context.h"
#include "core/preview/render_target.h"
#include "core/preview/shader_program.h"

#include <gtest/gtest.h>

#include <functional>
#include <optional>

namespace mirrorball::test {

/// A context is current in every test of this fixture; where none can be had the test fails and says what to install.
class GlTest : public testing::Test {
protected:
    void SetUp() override
    {
        try {
            m_context.emplace();
        } catch (const Error& error) {
            FAIL() << error.what();
        }
    }
    void TearDown() override { EXPECT_TRUE(!m_context || glGetError() == GL_NO_ERROR); }

private:
    std::optional<preview::OffscreenContext> m_context;
};

/// Calls a GLSL function `vec4 twin(vec4 x)` once per input, on the GPU.
/// @param text     GLSL that defines it, #include lines at will
/// @param prepare  sets uniforms and binds textures (unit 0 is taken)
inline std::vector<glm::vec4> evaluateGlsl(const std::string& text, const std::vector<glm::vec4>& inputs,
                                           const std::vector<preview::ShaderDefine>& defines = {},
                                           const std::function<void(const preview::ShaderProgram&)>& prepare = {})
{
    using namespace preview;
    const std::string vertex =
        "void main() { gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0); }\n";
    const std::string fragment = text + "\nuniform sampler2D twinInputs;\nlayout(location = 0) out vec4 twinResult;\n"
                                        "void main() { twinResult = twin(texelFetch(twinInputs, ivec2(gl_FragCoord.xy), 0)); }\n";
    const ShaderProgram program(resolveIncludes("twin.vert", vertex), resolveIncludes("twin.frag", fragment, defines));

    const int width = 256, height = static_cast<int>((inputs.size() + 255) / 256);
    std::vector<glm::vec4> padded = inputs;
    padded.resize(static_cast<size_t>(width) * static_cast<size_t>(height), inputs.back());
    const GlObject texture = makeTexture(GL_TEXTURE_2D);
    glTextureStorage2D(texture, 1, GL_RGBA32F, width, height);
    glTextureSubImage2D(texture, 0, 0, 0, width, height, GL_RGBA, GL_FLOAT, padded.data());
    glTextureParameteri(texture, GL_TEXTURE_MIN_FILTER, GL_NEAREST);

    const RenderTarget target(width, height, 1, GL_RGBA32F, 1, GL_NONE);
    const GlObject vertexArray = makeVertexArray();
    program.set("twinInputs", 0);
    glBindTextureUnit(0, texture);
    if (prepare)
        prepare(program);
    program.use();
    glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer);
    glViewport(0, 0, width, height);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_SCISSOR_TEST);
    glEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
    glBindVertexArray(vertexArray);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glBindVertexArray(0);

    const Image image = readImage(target);
    std::vector<glm::vec4> results(inputs.size());
    for (size_t i = 0; i < inputs.size(); ++i) { // the image's rows run from the top
        const float* t = image.texel(static_cast<int>(i % 256), height - 1 - static_cast<int>(i / 256));
        results[i] = {t[0], t[1], t[2], t[3]};
    }
    return results;
}

} // namespace mirrorball::test
