#pragma once

#include "app/render/gl_handle.h"
#include "texplorer/glsl/shader_source.h"

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace texplorer::render {

/// A compiled and linked program, with its uniforms by name. Uniforms are set while it is in use
/// (glUseProgram); a uniform that it does not have is ignored.
class ShaderProgram {
public:
    /// The driver's messages about a source that it does not accept, with positions in the files.
    using Log = std::vector<view::ShaderMessage>;

    [[nodiscard]] static tl::expected<ShaderProgram, Log> compile(const glsl::ShaderSource& source);

    void use() const { glUseProgram(handle_.name()); }

    void set(std::string_view uniform, int value) const;
    void set(std::string_view uniform, float value) const;
    void set(std::string_view uniform, const glm::vec3& value) const;
    void set(std::string_view uniform, const glm::vec4& value) const;
    void set(std::string_view uniform, const glm::mat3& value) const;
    void set(std::string_view uniform, const glm::mat4& value) const;

private:
    struct Kind {
        static void generate(GLuint* name) { *name = glCreateProgram(); }
        static void destroy(const GLuint* name) { glDeleteProgram(*name); }
    };

    [[nodiscard]] GLint locationOf(std::string_view uniform) const; ///< -1: there is none
    void findUniforms();

    GlHandle<Kind> handle_;
    std::map<std::string, GLint, std::less<>> locations_;
};

} // namespace texplorer::render
