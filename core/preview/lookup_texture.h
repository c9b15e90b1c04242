#pragma once

#include "gl_object.h"

#include "core/image/image.h"

#include <memory>

namespace mirrorball::preview {

/// The table of a BRDF's lookups (core/filter/lookup_table.h) on the GPU, as floats: lib/brdf_lookups.glsl reads it. A pointer that comes
/// back unchanged is the same table.
class LookupTexture {
public:
    /// @throws InvalidArgument when there is none
    void update(const std::shared_ptr<const Image>& table);
    /// How many lookups the table has; 0 without one.
    int count() const { return m_source ? m_source->height / 2 : 0; }
    void bind(GLuint unit) const { glBindTextureUnit(unit, m_texture); }
    void release();

private:
    std::shared_ptr<const Image> m_source{};
    GlObject m_texture{};
};

} // namespace mirrorball::preview
