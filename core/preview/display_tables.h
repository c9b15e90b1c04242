#pragma once

#include "display_transform.h"
#include "gl_object.h"
#include "shader_program.h"

#include <vector>

namespace mirrorball::preview {

/// The tables of a display transform on the GPU. A pointer that comes back unchanged is the same transform.
class DisplayTables {
public:
    void update(const std::shared_ptr<const DisplayTransform>& transform);
    /// Binds them to texture units from `first` on.
    void bind(const ShaderProgram& program, GLuint first) const;

private:
    std::shared_ptr<const DisplayTransform> m_source{};
    std::vector<GlObject> m_textures{};
};

} // namespace mirrorball::preview
