#pragma once

#include <epoxy/gl.h>

#include <utility>

/// Ownership of OpenGL names. The context must be current wherever one is made or dies.
namespace mirrorball::preview {

enum class GlKind { Buffer, VertexArray, Texture, Framebuffer, Sampler, Program };

/// Owns one OpenGL name: moves, does not copy, deletes at the end of its life. Converts to the name.
class GlObject {
public:
    GlObject() = default;
    GlObject(GlKind kind, GLuint name) : m_kind(kind), m_name(name) {}
    ~GlObject() { release(); }
    GlObject(GlObject&& other) noexcept : m_kind(other.m_kind), m_name(std::exchange(other.m_name, 0)) {}
    GlObject& operator=(GlObject&& other) noexcept
    {
        std::swap(m_kind, other.m_kind);
        std::swap(m_name, other.m_name);
        return *this;
    }
    GlObject(const GlObject&) = delete;
    GlObject& operator=(const GlObject&) = delete;

    operator GLuint() const { return m_name; }

private:
    void release()
    {
        if (m_name == 0)
            return;
        switch (m_kind) {
        case GlKind::Buffer:
            glDeleteBuffers(1, &m_name);
            break;
        case GlKind::VertexArray:
            glDeleteVertexArrays(1, &m_name);
            break;
        case GlKind::Texture:
            glDeleteTextures(1, &m_name);
            break;
        case GlKind::Framebuffer:
            glDeleteFramebuffers(1, &m_name);
            break;
        case GlKind::Sampler:
            glDeleteSamplers(1, &m_name);
            break;
        case GlKind::Program:
            glDeleteProgram(m_name);
            break;
        }
    }

    GlKind m_kind = GlKind::Buffer;
    GLuint m_name = 0;
};

inline GlObject makeBuffer()
{
    GLuint name = 0;
    glCreateBuffers(1, &name);
    return {GlKind::Buffer, name};
}

inline GlObject makeVertexArray()
{
    GLuint name = 0;
    glCreateVertexArrays(1, &name);
    return {GlKind::VertexArray, name};
}

inline GlObject makeTexture(GLenum target)
{
    GLuint name = 0;
    glCreateTextures(target, 1, &name);
    return {GlKind::Texture, name};
}

inline GlObject makeFramebuffer()
{
    GLuint name = 0;
    glCreateFramebuffers(1, &name);
    return {GlKind::Framebuffer, name};
}

} // namespace mirrorball::preview
