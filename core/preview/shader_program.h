#pragma once

#include "gl_object.h"

#include <glm/glm.hpp>

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace mirrorball::preview {

/// A shader file compiled into the program.
struct ShaderFile {
    std::string_view path; ///< below resources/shaders: "lib/fresnel.glsl"
    std::string_view text;
};
/// All files below resources/shaders.
std::span<const ShaderFile> shaderFiles();
/// @throws WorkError for a path that is not compiled in
std::string_view shaderText(std::string_view path);

/// A macro defined ahead of the source: {"SPECULAR_KIND", "1"}.
using ShaderDefine = std::pair<std::string, std::string>;

/// GLSL of one stage with every `#include "lib/x.glsl"` put in (files that begin with `#pragma once` only once), under a #version and
/// the defines.
struct ShaderSource {
    std::string text{};
    std::vector<std::string> files{}; ///< GLSL's source string number i is files[i]
};
/// @param name what error logs call the text
ShaderSource resolveIncludes(std::string_view name, std::string_view text, const std::vector<ShaderDefine>& defines = {});

/// A linked vertex and fragment shader. Setters skip names that the compiler left out because nothing reads them.
class ShaderProgram {
public:
    /// @throws WorkError with the compiler's log, in which the source numbers are replaced by file names
    ShaderProgram(const ShaderSource& vertex, const ShaderSource& fragment);
    /// From files below resources/shaders.
    ShaderProgram(std::string_view vertexPath, std::string_view fragmentPath, const std::vector<ShaderDefine>& defines = {});

    void use() const;
    void set(const char* name, int value) const;
    void set(const char* name, float value) const;
    void set(const char* name, const glm::vec3& value) const;
    void set(const char* name, const glm::vec4& value) const;
    void set(const char* name, const glm::mat3& value) const;
    void set(const char* name, const glm::mat4& value) const;
    void set(const char* name, std::span<const glm::vec4> values) const;

private:
    GLint location(const char* name) const;
    GlObject m_program;
};

} // namespace mirrorball::preview
