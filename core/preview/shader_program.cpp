#include "shader_program.h"

#include "core/base/error.h"

#include <algorithm>
#include <cctype>
#include <sstream>

namespace mirrorball::preview {

namespace {

constexpr std::string_view onceMark = "#pragma once";

// "lib/fresnel.glsl" as a macro.
std::string guardOf(std::string_view path)
{
    std::string guard = "INCLUDED_";
    for (const char c : path)
        guard += std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
    return guard;
}

// Appends the text of a file, and at the place of each #include the text of that one. A file that begins with the once mark stands between
// guards, so that it counts only once, and counts where the first #include of it stands under a condition that is false; one without
// the mark may be put in several times under different macros.
void append(ShaderSource& source, std::string_view name, std::string_view text)
{
    const size_t number = source.files.size();
    source.files.emplace_back(name);
    source.text += "#line 1 " + std::to_string(number) + '\n';
    std::istringstream lines{std::string(text)};
    int lineNumber = 0;
    for (std::string line; std::getline(lines, line);) {
        ++lineNumber;
        constexpr std::string_view directive = "#include \"";
        if (line.starts_with(onceMark))
            line.clear();
        if (!line.starts_with(directive)) {
            source.text += line + '\n';
            continue;
        }
        const std::string path = line.substr(directive.size(), line.find('"', directive.size()) - directive.size());
        const std::string_view included = shaderText(path);
        const bool isGuarded = included.starts_with(onceMark);
        if (isGuarded)
            source.text += "#ifndef " + guardOf(path) + "\n#define " + guardOf(path) + '\n';
        append(source, path, included);
        if (isGuarded)
            source.text += "#endif\n";
        source.text += "#line " + std::to_string(lineNumber + 1) + ' ' + std::to_string(number) + '\n';
    }
}

// Compilers begin a line of their log with "2:31(5)" or "2(31)", source string 2, line 31: the file's name is put in its place.
std::string withFileNames(const std::string& log, const std::vector<std::string>& files)
{
    std::istringstream lines(log);
    std::string result;
    for (std::string line; std::getline(lines, line);) {
        size_t digits = 0;
        while (digits < line.size() && std::isdigit(static_cast<unsigned char>(line[digits])))
            ++digits;
        const bool isPlace = digits > 0 && digits < 6 && digits < line.size() && (line[digits] == ':' || line[digits] == '(');
        const size_t number = isPlace ? std::stoul(line.substr(0, digits)) : files.size();
        result += number < files.size() ? files[number] + line.substr(digits) : line;
        result += '\n';
    }
    return result;
}

GLuint compile(GLenum stage, const ShaderSource& source)
{
    const GLuint shader = glCreateShader(stage);
    const char* text = source.text.c_str();
    glShaderSource(shader, 1, &text, nullptr);
    glCompileShader(shader);
    GLint done = GL_FALSE;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &done);
    if (done == GL_TRUE)
        return shader;
    GLint length = 0;
    glGetShaderiv(shader, GL_INFO_LOG_LENGTH, &length);
    std::string log(static_cast<size_t>(std::max(1, length)), '\0');
    glGetShaderInfoLog(shader, length, nullptr, log.data());
    glDeleteShader(shader);
    throw WorkError("shader " + source.files.front() + " does not compile:\n" + withFileNames(log, source.files));
}

} // namespace

std::string_view shaderText(std::string_view path)
{
    for (const ShaderFile& file : shaderFiles())
        if (file.path == path)
            return file.text;
    throw WorkError("shader file " + std::string(path) + " is not compiled in: list it in resources/shaders/CMakeLists.txt");
}

ShaderSource resolveIncludes(std::string_view name, std::string_view text, const std::vector<ShaderDefine>& defines,
                             std::string_view prelude)
{
    ShaderSource source;
    source.text = "#version 450 core\n";
    for (const auto& [macro, value] : defines)
        source.text += "#define " + macro + ' ' + value + '\n';
    source.text += prelude;
    append(source, name, text);
    return source;
}

ShaderProgram::ShaderProgram(const ShaderSource& vertex, const ShaderSource& fragment, const std::optional<ShaderSource>& geometry)
    : m_program(GlKind::Program, glCreateProgram())
{
    const auto attach = [&](GLenum stage, const ShaderSource& source) {
        const GLuint shader = compile(stage, source);
        glAttachShader(m_program, shader);
        glDeleteShader(shader); // lives on as long as it is attached
    };
    attach(GL_VERTEX_SHADER, vertex);
    if (geometry)
        attach(GL_GEOMETRY_SHADER, *geometry);
    attach(GL_FRAGMENT_SHADER, fragment);
    glLinkProgram(m_program);
    GLint done = GL_FALSE;
    glGetProgramiv(m_program, GL_LINK_STATUS, &done);
    if (done == GL_TRUE)
        return;
    GLint length = 0;
    glGetProgramiv(m_program, GL_INFO_LOG_LENGTH, &length);
    std::string log(static_cast<size_t>(std::max(1, length)), '\0');
    glGetProgramInfoLog(m_program, length, nullptr, log.data());
    throw WorkError("shaders " + vertex.files.front() + " and " + fragment.files.front() + " do not link:\n" + log);
}

namespace {

ShaderSource sourceOf(const char* path, const std::vector<ShaderDefine>& defines, std::string_view prelude = {})
{
    return resolveIncludes(path, shaderText(path), defines, prelude);
}

} // namespace

ShaderProgram::ShaderProgram(const ShaderStages& stages, const std::vector<ShaderDefine>& defines, std::string_view prelude)
    : ShaderProgram(sourceOf(stages.vertex, defines), sourceOf(stages.fragment, defines, prelude),
                    stages.geometry ? std::optional(sourceOf(stages.geometry, defines)) : std::nullopt)
{
}

const ShaderProgram& ProgramCache::get(const ShaderStages& stages, const std::vector<ShaderDefine>& defines, std::string_view prelude)
{
    std::string key = std::string(stages.vertex) + ' ' + stages.fragment + (stages.geometry ? std::string(" ") + stages.geometry : "");
    for (const auto& [name, value] : defines)
        key += ' ' + name + '=' + value;
    key += prelude;
    const auto found = m_programs.find(key);
    return found != m_programs.end() ? found->second : m_programs.emplace(key, ShaderProgram(stages, defines, prelude)).first->second;
}

void ShaderProgram::use() const { glUseProgram(m_program); }

GLint ShaderProgram::location(const char* name) const { return glGetUniformLocation(m_program, name); }

// A location of -1 is ignored by OpenGL.
void ShaderProgram::set(const char* name, int value) const { glProgramUniform1i(m_program, location(name), value); }
void ShaderProgram::set(const char* name, float value) const { glProgramUniform1f(m_program, location(name), value); }
void ShaderProgram::set(const char* name, const glm::vec3& value) const { glProgramUniform3fv(m_program, location(name), 1, &value.x); }
void ShaderProgram::set(const char* name, const glm::vec4& value) const { glProgramUniform4fv(m_program, location(name), 1, &value.x); }
void ShaderProgram::set(const char* name, const glm::mat3& value) const
{
    glProgramUniformMatrix3fv(m_program, location(name), 1, GL_FALSE, &value[0].x);
}
void ShaderProgram::set(const char* name, const glm::mat4& value) const
{
    glProgramUniformMatrix4fv(m_program, location(name), 1, GL_FALSE, &value[0].x);
}
void ShaderProgram::set(const char* name, std::span<const glm::vec4> values) const
{
    glProgramUniform4fv(m_program, location(name), static_cast<GLsizei>(values.size()), &values.front().x);
}

} // namespace mirrorball::preview
