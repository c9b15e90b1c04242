#pragma once

#include "render_settings.h"
#include "shader_program.h"

#include <memory>
#include <vector>

namespace mirrorball::preview {

/// The exact maps of a BRDF (core/filter/view_stack.h) on the GPU, as lib/view_stack.glsl reads them: an array of latlong maps that repeat
/// along their rows, each with the row beyond either pole. A pointer that comes back unchanged is the same stack.
class ViewStackTexture {
public:
    /// @throws InvalidArgument when there is none; WorkError when it is larger than the GPU takes
    void update(const std::shared_ptr<const ViewStack>& stack, TexelFormat format);
    /// VIEW_STACK_NODES of the shader.
    size_t nodeCount() const { return m_nodes.size(); }
    void bind(const ShaderProgram& program, GLuint unit) const;
    void release();

private:
    std::shared_ptr<const ViewStack> m_source{};
    GlObject m_texture{};
    std::vector<glm::vec4> m_nodes{}, m_albedo{};
};

} // namespace mirrorball::preview
