#pragma once

#include "gl_object.h"

#include <glm/glm.hpp>

#include <map>
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

/// A macro defined ahead of the source: {"SPECULAR_MIPS", "1"}.
using ShaderDefine = std::pair<std::string, std::string>;

/// GLSL of one stage with every `#include "lib/x.glsl"` put in (files that begin with `#pragma once` count only once), under a #version and
/// the defines.
struct ShaderSource {
    std::string text{};
    std::vector<std::string> files{}; ///< GLSL's source string number i is files[i]
};
/// @param name    what error logs call the text
/// @param prelude GLSL from elsewhere, between the defines and the text
ShaderSource resolveIncludes(std::string_view name, std::string_view text, const std::vector<ShaderDefine>& defines = {},
                             std::string_view prelude = {});

/// Files below resources/shaders that make a program; the geometry stage may be missing.
struct ShaderStages {
    const char* vertex;
    const char* fragment;
    const char* geometry = nullptr;
};

/// A linked vertex and fragment shader, with a geometry shader between them where there is one. Setters skip names that the compiler left
/// out because nothing reads them.
class ShaderProgram {
public:
    /// @throws WorkError with the compiler's log, in which the source numbers are replaced by file names
    ShaderProgram(const ShaderSource& vertex, const ShaderSource& fragment, const std::optional<ShaderSource>& geometry = {});
    /// @param prelude of the fragment shader
    explicit ShaderProgram(const ShaderStages& stages, const std::vector<ShaderDefine>& defines = {}, std::string_view prelude = {});

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

/// Programs by everything that they were compiled from: each is compiled when first asked for.
class ProgramCache {
public:
    const ShaderProgram& get(const ShaderStages& stages, const std::vector<ShaderDefine>& defines = {}, std::string_view prelude = {});

private:
    std::map<std::string, ShaderProgram> m_programs;
};

} // namespace mirrorball::preview
