#include "render_target.h"

#include "core/base/error.h"

#include <algorithm>

namespace mirrorball::preview {

namespace {

GlObject makeStorage(int width, int height, int samples, GLenum format)
{
    GlObject texture = makeTexture(samples > 1 ? GL_TEXTURE_2D_MULTISAMPLE : GL_TEXTURE_2D);
    if (samples > 1)
        glTextureStorage2DMultisample(texture, samples, format, width, height, GL_TRUE);
    else
        glTextureStorage2D(texture, 1, format, width, height);
    return texture;
}

} // namespace

RenderTarget::RenderTarget(int width_, int height_, int samples_, GLenum format_, int colorCount, GLenum depthFormat)
    : width(width_), height(height_), samples(samples_), format(format_), framebuffer(makeFramebuffer())
{
    std::vector<GLenum> buffers;
    for (int i = 0; i < colorCount; ++i) {
        colors.push_back(makeStorage(width, height, samples, format));
        buffers.push_back(static_cast<GLenum>(GL_COLOR_ATTACHMENT0 + i));
        glNamedFramebufferTexture(framebuffer, buffers.back(), colors.back(), 0);
    }
    if (depthFormat != GL_NONE) {
        depth = makeStorage(width, height, samples, depthFormat);
        glNamedFramebufferTexture(framebuffer, GL_DEPTH_ATTACHMENT, depth, 0);
    }
    glNamedFramebufferDrawBuffers(framebuffer, colorCount, buffers.data());
    if (glCheckNamedFramebufferStatus(framebuffer, GL_DRAW_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        throw WorkError("the OpenGL driver cannot draw " + std::to_string(width) + " x " + std::to_string(height) + " pixels with " +
                        std::to_string(samples) + " samples; ask for a smaller picture or fewer samples");
}

// OpenGL's rows run from the bottom.
Image readImage(const RenderTarget& target, int colorIndex)
{
    const int channels = target.format == GL_RG32F ? 2 : 4;
    Image image(target.width, target.height, channels);
    const size_t rowSize = static_cast<size_t>(target.width) * static_cast<size_t>(channels);
    if (target.format == GL_RGBA8) {
        std::vector<unsigned char> bytes(image.texels.size());
        glGetTextureImage(target.colors[static_cast<size_t>(colorIndex)], 0, GL_RGBA, GL_UNSIGNED_BYTE, static_cast<GLsizei>(bytes.size()),
                          bytes.data());
        for (int y = 0; y < target.height; ++y)
            std::transform(bytes.data() + static_cast<size_t>(y) * rowSize, bytes.data() + static_cast<size_t>(y + 1) * rowSize,
                           image.row(target.height - 1 - y), [](unsigned char byte) { return static_cast<float>(byte) / 255.0f; });
        return image;
    }
    glGetTextureImage(target.colors[static_cast<size_t>(colorIndex)], 0, channels == 2 ? GL_RG : GL_RGBA, GL_FLOAT,
                      static_cast<GLsizei>(image.texels.size() * sizeof(float)), image.texels.data());
    for (int y = 0; y < target.height / 2; ++y)
        std::swap_ranges(image.row(y), image.row(y) + rowSize, image.row(target.height - 1 - y));
    return image;
}

} // namespace mirrorball::preview
