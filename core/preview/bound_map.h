#pragma once

#include "shader_program.h"
#include "texture.h"

#include <memory>
#include <string>
#include <vector>

namespace mirrorball::preview {

/// A texture and the map that it was made from. A pointer that comes back unchanged is the same map.
class BoundMap {
public:
    /// @param role for the message, "specular"
    /// @throws InvalidArgument when there is no map
    const EnvironmentTexture& update(const MapLevels& levels, TexelFormat format, const char* role);
    void release();
    /// Null before the first update.
    const EnvironmentTexture* texture() const { return m_texture.get(); }
    const MapLevels& source() const { return m_source; }

private:
    MapLevels m_source{};
    std::unique_ptr<EnvironmentTexture> m_texture{};
};

/// The function of a mapping that lib/mappings.glsl lists. @param what  "Coordinate", "TexelAngle" or "Seam"
std::string shaderFunction(Parameterization kind, const char* what);

/// What lib/environment_map.glsl needs to know of a map when it is compiled: `role`_CUBE, _COORDINATE, _TEXEL_ANGLE and _MIPS.
void addMapDefines(std::vector<ShaderDefine>& defines, const std::string& role, const EnvironmentTexture& texture);

/// Its uniforms, `role` before their names, and its texture. @param rotation world to map
void bindMap(const ShaderProgram& program, const std::string& role, GLuint unit, const EnvironmentTexture& texture,
             const glm::mat3& rotation, float lodBias = 0.0f);

} // namespace mirrorball::preview
