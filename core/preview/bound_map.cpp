#include "bound_map.h"

#include "core/base/error.h"

namespace mirrorball::preview {

const EnvironmentTexture& BoundMap::update(const MapLevels& levels, TexelFormat format, const char* role)
{
    if (!levels || levels->empty())
        throw InvalidArgument(std::string("render maps: the picture needs a ") + role + " map and there is none");
    if (levels != m_source) {
        m_texture.reset(); // the old one goes before the new one comes
        m_texture = std::make_unique<EnvironmentTexture>(*levels, format);
        m_source = levels;
    }
    return *m_texture;
}

void BoundMap::release()
{
    m_texture.reset();
    m_source.reset();
}

std::string shaderFunction(Parameterization kind, const char* what) { return std::string(name(kind)) + what; }

void addMapDefines(std::vector<ShaderDefine>& defines, const std::string& role, const EnvironmentTexture& texture)
{
    defines.emplace_back(role + "_CUBE", texture.kind() == Parameterization::Cube ? "1" : "0");
    defines.emplace_back(role + "_COORDINATE", shaderFunction(texture.kind(), "Coordinate"));
    defines.emplace_back(role + "_TEXEL_ANGLE", shaderFunction(texture.kind(), "TexelAngle"));
    defines.emplace_back(role + "_MIPS", texture.levelCount() > 1 ? "1" : "0");
}

void bindMap(const ShaderProgram& program, const std::string& role, GLuint unit, const EnvironmentTexture& texture,
             const glm::mat3& rotation, float lodBias)
{
    texture.bind(unit);
    program.set((role + "Map").c_str(), static_cast<int>(unit));
    program.set((role + "Levels").c_str(), texture.levels());
    program.set((role + "Settings").c_str(), glm::vec4(texture.scale(), float(texture.levelCount() - 1), lodBias, 0.0f));
    program.set((role + "Rotation").c_str(), rotation);
}

} // namespace mirrorball::preview
