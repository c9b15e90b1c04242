#pragma once

#include "gl_object.h"

#include "core/image/picture_levels.h"

namespace mirrorball::preview {

/// A picture on the GPU, with the levels given, for lookups by a mesh's texture coordinates (lib/surface_picture.glsl): linear within and
/// between levels, repeated. Stored as halves, what is larger than they hold as the largest of them. A pointer that comes back unchanged is
/// the same picture.
class PictureTexture {
public:
    /// @param levels of one or three channels @param role for messages, "diffuse picture"
    /// @throws InvalidArgument when there is no picture; WorkError when it is larger than the GPU takes
    void update(const PictureLevels& levels, const char* role);
    void bind(GLuint unit) const { glBindTextureUnit(unit, m_texture); }
    void release();
    bool isHeld() const { return m_source != nullptr; }

private:
    PictureLevels m_source{};
    GlObject m_texture{};
};

} // namespace mirrorball::preview
