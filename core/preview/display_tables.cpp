#include "display_tables.h"

namespace mirrorball::preview {

namespace {

GlObject upload(const DisplayTable& table)
{
    const GLenum target = table.depth > 1 ? GL_TEXTURE_3D : table.height > 1 ? GL_TEXTURE_2D : GL_TEXTURE_1D;
    GlObject texture = makeTexture(target);
    const GLenum internal = table.channels == 1 ? GL_R32F : GL_RGB32F, format = table.channels == 1 ? GL_RED : GL_RGB;
    if (target == GL_TEXTURE_3D) {
        glTextureStorage3D(texture, 1, internal, table.width, table.height, table.depth);
        glTextureSubImage3D(texture, 0, 0, 0, 0, table.width, table.height, table.depth, format, GL_FLOAT, table.values.data());
    } else if (target == GL_TEXTURE_2D) {
        glTextureStorage2D(texture, 1, internal, table.width, table.height);
        glTextureSubImage2D(texture, 0, 0, 0, table.width, table.height, format, GL_FLOAT, table.values.data());
    } else {
        glTextureStorage1D(texture, 1, internal, table.width);
        glTextureSubImage1D(texture, 0, 0, table.width, format, GL_FLOAT, table.values.data());
    }
    const GLint filter = table.isNearest ? GL_NEAREST : GL_LINEAR;
    glTextureParameteri(texture, GL_TEXTURE_MIN_FILTER, filter);
    glTextureParameteri(texture, GL_TEXTURE_MAG_FILTER, filter);
    for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
        glTextureParameteri(texture, wrap, GL_CLAMP_TO_EDGE);
    return texture;
}

} // namespace

void DisplayTables::update(const std::shared_ptr<const DisplayTransform>& transform)
{
    if (transform == m_source)
        return;
    m_textures.clear();
    if (transform)
        for (const DisplayTable& table : transform->tables)
            m_textures.push_back(upload(table));
    m_source = transform;
}

void DisplayTables::bind(const ShaderProgram& program, GLuint first) const
{
    for (size_t i = 0; i < m_textures.size(); ++i) {
        const GLuint unit = first + static_cast<GLuint>(i);
        glBindTextureUnit(unit, m_textures[i]);
        program.set(m_source->tables[i].sampler.c_str(), static_cast<int>(unit));
    }
}

} // namespace mirrorball::preview
