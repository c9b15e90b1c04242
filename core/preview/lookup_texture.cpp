#include "lookup_texture.h"

#include "core/base/error.h"

namespace mirrorball::preview {

void LookupTexture::update(const std::shared_ptr<const Image>& table)
{
    if (!table)
        throw InvalidArgument("render maps: the picture needs the lookups of a BRDF and there are none");
    if (table == m_source)
        return;
    release();
    m_texture = makeTexture(GL_TEXTURE_2D);
    glTextureStorage2D(m_texture, 1, GL_RGB32F, table->width, table->height);
    glTextureSubImage2D(m_texture, 0, 0, 0, table->width, table->height, GL_RGB, GL_FLOAT, table->texels.data());
    glTextureParameteri(m_texture, GL_TEXTURE_MIN_FILTER, GL_NEAREST); // read texel by texel
    glTextureParameteri(m_texture, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    m_source = table;
}

void LookupTexture::release()
{
    m_texture = GlObject();
    m_source.reset();
}

} // namespace mirrorball::preview
