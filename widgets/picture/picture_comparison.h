#pragma once

#include "core/preview/gl_object.h"
#include "core/preview/render_target.h"
#include "core/preview/shader_program.h"

#include <memory>

namespace mirrorball::studio {

/// |A - B| of two display pictures, amplified. Belongs to the context that is current when it first draws.
class PictureDifference {
public:
    /// Targets for the two pictures, of the size asked for. @return the framebuffer to draw A (0) or B (1) into
    unsigned target(int index, int width, int height);
    /// What was drawn into it last.
    const preview::RenderTarget& drawn(int index) const { return m_targets[index]; }
    /// Lays gain |A - B| into the framebuffer.
    void draw(unsigned framebuffer, float gain);

private:
    preview::RenderTarget m_targets[2]{};
    std::unique_ptr<preview::ShaderProgram> m_program{};
    preview::GlObject m_vertexArray{};
};

} // namespace mirrorball::studio
