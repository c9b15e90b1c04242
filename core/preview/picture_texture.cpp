#include "picture_texture.h"

#include "half_texels.h"

#include "core/base/error.h"

#include <algorithm>
#include <string>

namespace mirrorball::preview {

void PictureTexture::update(const PictureLevels& levels, const char* role)
{
    if (!levels || levels->empty())
        throw InvalidArgument(std::string("render maps: the picture needs a ") + role + " and there is none");
    if (levels == m_source)
        return;
    release();
    const Image& whole = levels->front();
    GLint largest = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
    if (std::max(whole.width, whole.height) > largest)
        throw WorkError(std::string(role) + ": a texture of " + std::to_string(std::max(whole.width, whole.height)) +
                        " texels is more than the OpenGL driver takes; make the picture smaller");
    const bool isColor = whole.channels == 3;
    m_texture = makeTexture(GL_TEXTURE_2D);
    glTextureStorage2D(m_texture, static_cast<GLsizei>(levels->size()), isColor ? GL_RGBA16F : GL_R16F, whole.width, whole.height);
    glPixelStorei(GL_UNPACK_ALIGNMENT, sizeof(std::uint16_t)); // rows of odd widths follow each other without a gap
    for (size_t i = 0; i < levels->size(); ++i) {
        const Image& level = (*levels)[i];
        glTextureSubImage2D(m_texture, static_cast<GLint>(i), 0, 0, level.width, level.height, isColor ? GL_RGB : GL_RED, GL_HALF_FLOAT,
                            halvesOf(level, 65504.0f).data());
    }
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glTextureParameteri(m_texture, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glTextureParameteri(m_texture, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTextureParameteri(m_texture, GL_TEXTURE_WRAP_S, GL_REPEAT);
    glTextureParameteri(m_texture, GL_TEXTURE_WRAP_T, GL_REPEAT);
    m_source = levels;
}

void PictureTexture::release()
{
    m_texture = GlObject();
    m_source.reset();
}

} // namespace mirrorball::preview
