#include "sphere_map_texture.h"

#include "half_texels.h"

#include "core/base/error.h"

#include <algorithm>

namespace mirrorball::preview {

namespace {

void check(const std::vector<Image>& levels, const char* role)
{
    for (size_t i = 0; i < levels.size(); ++i) {
        const int size = std::max(1, levels[0].width >> i);
        if (levels[i].width != size || levels[i].height != size || levels[i].channels != 4)
            throw InvalidArgument(std::string(role) + ": level " + std::to_string(i) + " must be " + std::to_string(size) + " x " +
                                  std::to_string(size) + " texels of RGBA");
    }
    GLint largest = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
    if (levels[0].width > largest)
        throw WorkError(std::string(role) + ": a texture of " + std::to_string(levels[0].width) +
                        " texels is more than the OpenGL driver takes");
}

} // namespace

void SphereMapTexture::update(const SphereMapChain& map, const char* role)
{
    if (!map || map->levels.empty())
        throw InvalidArgument(std::string("render maps: the picture needs a ") + role + " and there is none");
    if (map == m_source)
        return;
    check(map->levels, role);
    release();
    m_texture = makeTexture(GL_TEXTURE_2D);
    const auto levels = static_cast<GLsizei>(map->levels.size());
    glTextureStorage2D(m_texture, levels, GL_RGBA16F, map->levels[0].width, map->levels[0].height);
    for (GLsizei i = 0; i < levels; ++i)
        patch(map->levels[static_cast<size_t>(i)], 0, 0, i);
    glTextureParameteri(m_texture, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glTextureParameteri(m_texture, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTextureParameteri(m_texture, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTextureParameteri(m_texture, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    m_source = map;
}

void SphereMapTexture::bind(GLuint unit, int anisotropy, std::optional<int> onlyLevel) const
{
    // Of a texture whose first level is its last, lookups find no other, and textureSize() is that level's.
    const int last = static_cast<int>(m_source->levels.size()) - 1, only = std::clamp(onlyLevel.value_or(0), 0, last);
    glTextureParameteri(m_texture, GL_TEXTURE_BASE_LEVEL, only);
    glTextureParameteri(m_texture, GL_TEXTURE_MAX_LEVEL, onlyLevel ? only : last);
    if (epoxy_has_gl_extension("GL_EXT_texture_filter_anisotropic") || epoxy_has_gl_extension("GL_ARB_texture_filter_anisotropic"))
        glTextureParameterf(m_texture, GL_TEXTURE_MAX_ANISOTROPY_EXT, static_cast<float>(anisotropy));
    glBindTextureUnit(unit, m_texture);
}

void SphereMapTexture::release()
{
    m_texture = GlObject();
    m_source.reset();
}

void SphereMapTexture::patch(const Image& texels, int x, int y, int level)
{
    if (m_texture == 0)
        return;
    glTextureSubImage2D(m_texture, level, x, y, texels.width, texels.height, GL_RGBA, GL_HALF_FLOAT, halvesOf(texels).data());
}

} // namespace mirrorball::preview
