#include "mesh_buffer.h"

namespace mirrorball::preview {

namespace {

template <class Element>
GlObject upload(const std::vector<Element>& elements)
{
    if (elements.empty())
        return {};
    GlObject buffer = makeBuffer();
    glNamedBufferStorage(buffer, static_cast<GLsizeiptr>(elements.size() * sizeof(Element)), elements.data(), 0);
    return buffer;
}

} // namespace

MeshBuffer::MeshBuffer(const Mesh& mesh)
    : m_vertexArray(makeVertexArray()), m_attributes{upload(mesh.positions), upload(mesh.normals), upload(mesh.texCoords)},
      m_indices(upload(mesh.indices)), m_count(static_cast<GLsizei>(mesh.indices.size())), m_openFrom(static_cast<GLsizei>(mesh.openFrom)),
      m_vertexCount(static_cast<GLsizei>(mesh.positions.size())), m_bounds(boundingBox(mesh))
{
    const GLint components[3] = {3, 3, 2};
    for (GLuint i = 0; i < (mesh.texCoords.empty() ? 2u : 3u); ++i) { // without one, shaders read 0
        glVertexArrayVertexBuffer(m_vertexArray, i, m_attributes[i], 0, static_cast<GLsizei>(components[i] * sizeof(float)));
        glVertexArrayAttribFormat(m_vertexArray, i, components[i], GL_FLOAT, GL_FALSE, 0);
        glEnableVertexArrayAttrib(m_vertexArray, i);
    }
    glVertexArrayElementBuffer(m_vertexArray, m_indices);
}

void MeshBuffer::draw() const
{
    glBindVertexArray(m_vertexArray);
    glEnable(GL_CULL_FACE);
    glCullFace(GL_BACK);
    glDrawElements(GL_TRIANGLES, m_count, GL_UNSIGNED_INT, nullptr);
    if (m_openFrom < m_count) {
        glCullFace(GL_FRONT);
        const auto* offset = static_cast<const char*>(nullptr) + static_cast<size_t>(m_openFrom) * sizeof(std::uint32_t);
        glDrawElements(GL_TRIANGLES, m_count - m_openFrom, GL_UNSIGNED_INT, offset);
    }
    glCullFace(GL_BACK);
    glDisable(GL_CULL_FACE);
    glBindVertexArray(0);
}

void MeshBuffer::drawVertices() const
{
    glBindVertexArray(m_vertexArray);
    glDrawArrays(GL_POINTS, 0, m_vertexCount);
    glBindVertexArray(0);
}

} // namespace mirrorball::preview
