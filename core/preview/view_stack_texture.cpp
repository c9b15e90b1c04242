#include "view_stack_texture.h"

#include "half_texels.h"

#include "core/base/error.h"
#include "core/sphere/latlong.h"

#include <algorithm>
#include <cmath>

namespace mirrorball::preview {

namespace {

constexpr float largestHalf = 65504.0f;

// Powers of two round nothing.
float scaleFor(const ViewStack& stack, TexelFormat format)
{
    float largest = 0.0f;
    for (const Image& layer : stack.layers)
        for (const float value : layer.texels)
            largest = std::max(largest, std::abs(value));
    return format == TexelFormat::Float || largest <= largestHalf ? 1.0f : std::exp2(std::ceil(std::log2(largest / largestHalf)));
}

// Beyond a pole a map of order m comes back half a turn on, times (-1)^m. @param sign  of that
Image framed(const Image& layer, float sign, float scale)
{
    Image result(layer.width, layer.height + 2, 4);
    for (int y = -1; y <= layer.height; ++y)
        for (int x = 0; x < layer.width; ++x) {
            const Texel texel = latlong::acrossSeam(layer.height, x, y);
            const float factor = (y < 0 || y >= layer.height ? sign : 1.0f) / scale;
            for (int c = 0; c < 3; ++c)
                result.texel(x, y + 1)[c] = factor * layer.texel(texel.x, texel.y)[c];
        }
    return result;
}

void check(const ViewStack& stack)
{
    GLint largest = 0, most = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
    glGetIntegerv(GL_MAX_ARRAY_TEXTURE_LAYERS, &most);
    if (stack.layers.front().width > largest || static_cast<GLint>(stack.layers.size()) > most)
        throw WorkError("exact reflection: " + std::to_string(stack.layers.size()) + " maps of " +
                        std::to_string(stack.layers.front().width) + " texels are more than the OpenGL driver takes");
}

} // namespace

void ViewStackTexture::update(const std::shared_ptr<const ViewStack>& stack, TexelFormat format)
{
    if (!stack || stack->layers.empty())
        throw InvalidArgument("render maps: the picture needs the exact maps of a BRDF and there are none");
    if (stack == m_source)
        return;
    release();
    check(*stack);
    const float scale = scaleFor(*stack, format);
    const Image& first = stack->layers.front();
    m_texture = makeTexture(GL_TEXTURE_2D_ARRAY);
    glTextureStorage3D(m_texture, 1, format == TexelFormat::Half ? GL_RGBA16F : GL_RGBA32F, first.width, first.height + 2,
                       static_cast<GLsizei>(stack->layers.size()));
    for (const ViewStack::Node& node : stack->nodes) {
        m_nodes.emplace_back(node.view, node.firstLayer, node.orders, scale);
        for (int i = 0; i <= 2 * node.orders; ++i) {
            const int layer = node.firstLayer + i;
            const Image texels = framed(stack->layers[static_cast<size_t>(layer)], (i + 1) / 2 % 2 ? -1.0f : 1.0f, scale);
            if (format == TexelFormat::Half)
                glTextureSubImage3D(m_texture, 0, 0, 0, layer, texels.width, texels.height, 1, GL_RGBA, GL_HALF_FLOAT,
                                    halvesOf(texels).data());
            else
                glTextureSubImage3D(m_texture, 0, 0, 0, layer, texels.width, texels.height, 1, GL_RGBA, GL_FLOAT, texels.texels.data());
        }
    }
    for (const glm::dvec3& albedo : stack->albedo)
        m_albedo.emplace_back(glm::vec3(albedo), 0.0f);
    glTextureParameteri(m_texture, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTextureParameteri(m_texture, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTextureParameteri(m_texture, GL_TEXTURE_WRAP_S, GL_REPEAT);
    glTextureParameteri(m_texture, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    m_source = stack;
}

void ViewStackTexture::bind(const ShaderProgram& program, GLuint unit) const
{
    glBindTextureUnit(unit, m_texture);
    program.set("viewStack", static_cast<int>(unit));
    program.set("viewStackNodes", m_nodes);
    program.set("viewStackAlbedo", m_albedo);
}

void ViewStackTexture::release()
{
    m_texture = GlObject();
    m_source.reset();
    m_nodes.clear();
    m_albedo.clear();
}

} // namespace mirrorball::preview
