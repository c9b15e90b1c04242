#pragma once

#include "gl_object.h"
#include "render_settings.h"

#include "core/image/environment_map.h"

#include <glm/glm.hpp>

#include <span>
#include <vector>

namespace mirrorball::preview {

/// An environment map on the GPU, in its own parameterization, with the levels given and no others: OpenGL makes none, because its
/// mips would not filter across seams.
///
/// A cube is a GL_TEXTURE_CUBE_MAP with its levels. Every other kind is an *atlas*: one GL_TEXTURE_2D that holds all levels side by
/// side, each chart (a paraboloid has two, the others one) in a frame of one texel that repeats what lies across the seam. Bilinear
/// filtering by the hardware is then seamless on every level and at any size, which neither wrap modes nor mip chains can offer:
/// no wrap mode folds an octahedron's edge, and the frame of a mip chain would halve from level to level.
class EnvironmentTexture {
public:
    /// @param levels largest first, all of one kind; a cube's sizes halve, rounding down
    /// @throws InvalidArgument for no level, mixed kinds or an image that does not fit its layout; WorkError when larger than the GPU takes
    EnvironmentTexture(std::span<const EnvironmentMap> levels, TexelFormat format = TexelFormat::Half);

    void bind(GLuint unit) const { glBindTextureUnit(unit, m_texture); }
    Parameterization kind() const { return m_kind; }
    int levelCount() const { return m_levelCount; }
    /// What every texel was divided by: a power of two, 1 unless a half would have overflowed.
    float scale() const { return m_scale; }
    /// Of each level: where texel (0, 0) of the first chart lies in the atlas, the size N, the border. For a cube only N.
    const std::vector<glm::vec4>& levels() const { return m_levels; }

    /// More levels than a map of 2^15 texels can have.
    static constexpr int maxLevels = 16;

private:
    void uploadCube(std::span<const EnvironmentMap> levels, GLenum internalFormat);
    void uploadAtlas(std::span<const EnvironmentMap> levels, GLenum internalFormat);

    GlObject m_texture;
    Parameterization m_kind = Parameterization::Latlong;
    int m_levelCount = 0;
    float m_scale = 1.0f;
    std::vector<glm::vec4> m_levels;
};

} // namespace mirrorball::preview
