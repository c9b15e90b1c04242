#pragma once

#include "gl_object.h"
#include "mesh.h"

namespace mirrorball::preview {

/// A mesh on the GPU: attribute 0 position, 1 normal, 2 texture coordinate, (0, 0) where the mesh has none.
class MeshBuffer {
public:
    explicit MeshBuffer(const Mesh& mesh);
    /// Outsides first, then the insides that a hole may show: these are all but hidden by then, and hidden pixels are not shaded.
    void draw() const;
    /// Every vertex as a point.
    void drawVertices() const;
    int vertexCount() const { return m_vertexCount; }
    const BoundingBox& bounds() const { return m_bounds; }

private:
    GlObject m_vertexArray, m_attributes[3], m_indices;
    GLsizei m_count = 0, m_openFrom = 0, m_vertexCount = 0;
    BoundingBox m_bounds;
};

} // namespace mirrorball::preview
