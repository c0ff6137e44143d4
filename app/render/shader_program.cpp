#include "app/render/shader_program.h"

#include "app/render/shader_log.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <utility>

namespace texplorer::render {

namespace {

template<GLenum stage>
struct ShaderKind {
    static void generate(GLuint* name) { *name = glCreateShader(stage); }
    static void destroy(const GLuint* name) { glDeleteShader(*name); }
};

std::string logOf(GLuint object, auto getParameter, auto getLog) {
    GLint length = 0;
    getParameter(object, GL_INFO_LOG_LENGTH, &length);
    std::string log(static_cast<std::size_t>(std::max(length, 0)), '\0');
    GLsizei written = 0;
    if (length > 0)
        getLog(object, length, &written, log.data());
    log.resize(static_cast<std::size_t>(std::max(written, 0)));
    return log;
}

/// Empty if the driver accepts it. A driver that refuses it without a message gets one.
ShaderProgram::Log compileStage(GLuint shader, view::ShaderStage stage, const glsl::StageSource& source) {
    const GLchar* text = source.text.c_str();
    const auto length = static_cast<GLint>(source.text.size());
    glShaderSource(shader, 1, &text, &length);
    glCompileShader(shader);
    GLint compiled = GL_FALSE;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    if (compiled == GL_TRUE)
        return {};
    ShaderProgram::Log log = translateLog(logOf(shader, glGetShaderiv, glGetShaderInfoLog), source, stage);
    if (log.empty())
        log.push_back({stage, 0, N_("the driver can't compile the shader and gives no reason")});
    return log;
}

} // namespace

tl::expected<ShaderProgram, ShaderProgram::Log> ShaderProgram::compile(const glsl::ShaderSource& source) {
    const auto vertex = GlHandle<ShaderKind<GL_VERTEX_SHADER>>::create();
    const auto fragment = GlHandle<ShaderKind<GL_FRAGMENT_SHADER>>::create();
    Log log = compileStage(vertex.name(), view::ShaderStage::Vertex, source.vertex);
    std::ranges::move(compileStage(fragment.name(), view::ShaderStage::Fragment, source.fragment),
                      std::back_inserter(log));
    if (!log.empty())
        return tl::unexpected(std::move(log));

    ShaderProgram program;
    program.handle_ = GlHandle<Kind>::create();
    const GLuint name = program.handle_.name();
    glAttachShader(name, vertex.name());
    glAttachShader(name, fragment.name());
    glLinkProgram(name);
    glDetachShader(name, vertex.name());
    glDetachShader(name, fragment.name());
    GLint linked = GL_FALSE;
    glGetProgramiv(name, GL_LINK_STATUS, &linked);
    if (linked != GL_TRUE) {
        log = translateLog(logOf(name, glGetProgramiv, glGetProgramInfoLog), {});
        if (log.empty())
            log.push_back({std::nullopt, 0, N_("the driver can't link the two stages and gives no reason")});
        return tl::unexpected(std::move(log));
    }
    program.findUniforms();
    return program;
}

void ShaderProgram::findUniforms() {
    const GLuint program = handle_.name();
    GLint count = 0;
    GLint maxLength = 0;
    glGetProgramiv(program, GL_ACTIVE_UNIFORMS, &count);
    glGetProgramiv(program, GL_ACTIVE_UNIFORM_MAX_LENGTH, &maxLength);
    std::string name(static_cast<std::size_t>(std::max(maxLength, 1)), '\0');
    for (GLint i = 0; i < count; ++i) {
        GLsizei length = 0;
        GLint size = 0;
        GLenum type = 0;
        glGetActiveUniform(program, static_cast<GLuint>(i), maxLength, &length, &size, &type, name.data());
        const std::string uniform = name.substr(0, static_cast<std::size_t>(length));
        locations_[uniform] = glGetUniformLocation(program, uniform.c_str());
    }
}

GLint ShaderProgram::locationOf(std::string_view uniform) const {
    const auto found = locations_.find(uniform);
    return found == locations_.end() ? -1 : found->second;
}

void ShaderProgram::set(std::string_view uniform, int value) const {
    glUniform1i(locationOf(uniform), value);
}
void ShaderProgram::set(std::string_view uniform, float value) const {
    glUniform1f(locationOf(uniform), value);
}
void ShaderProgram::set(std::string_view uniform, const glm::vec3& value) const {
    glUniform3fv(locationOf(uniform), 1, glm::value_ptr(value));
}
void ShaderProgram::set(std::string_view uniform, const glm::vec4& value) const {
    glUniform4fv(locationOf(uniform), 1, glm::value_ptr(value));
}
void ShaderProgram::set(std::string_view uniform, const glm::mat3& value) const {
    glUniformMatrix3fv(locationOf(uniform), 1, GL_FALSE, glm::value_ptr(value));
}
void ShaderProgram::set(std::string_view uniform, const glm::mat4& value) const {
    glUniformMatrix4fv(locationOf(uniform), 1, GL_FALSE, glm::value_ptr(value));
}

} // namespace texplorer::render
