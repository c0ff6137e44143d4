#include "tests/support/gl_device.h"

#include "app/render/gl_handle.h"
#include "texplorer/glsl/shader_source.h"

#include <GL/glew.h>

#include <array>
#include <cassert>
#include <ranges>

namespace texplorer::test {

int GlDevice::maxTextureSize() const {
    GLint size = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &size);
    return size;
}

int GlDevice::maxPointSize() const {
    std::array<GLint, 2> range{};
    glGetIntegerv(GL_ALIASED_POINT_SIZE_RANGE, range.data());
    return range[1];
}

unsigned GlDevice::makeTexels(std::span<const std::byte> texels, int rows, bool floats) {
    assert(texels.size() == static_cast<std::size_t>(rows) * glsl::texelsPerRow * (floats ? 16 : 4));
    GLuint name = 0;
    glGenTextures(1, &name);
    glBindTexture(GL_TEXTURE_2D, name);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexImage2D(GL_TEXTURE_2D, 0, floats ? GL_RGBA32F : GL_RGBA8, glsl::texelsPerRow, rows, 0, GL_RGBA,
                 floats ? GL_FLOAT : GL_UNSIGNED_BYTE, texels.data());
    return name;
}

void GlDevice::dropTexels(unsigned name) {
    glDeleteTextures(1, &name);
}

unsigned GlDevice::makeBuffer(view::BufferKind kind, std::span<const std::byte> content) {
    const GLenum target = kind == view::BufferKind::Indices ? GL_ELEMENT_ARRAY_BUFFER : GL_ARRAY_BUFFER;
    GLuint name = 0;
    glGenBuffers(1, &name);
    glBindBuffer(target, name);
    glBufferData(target, static_cast<GLsizeiptr>(content.size()), content.data(), GL_STATIC_DRAW);
    return name;
}

void GlDevice::dropBuffer(unsigned name) {
    glDeleteBuffers(1, &name);
}

gles::Device::Compiled GlDevice::makeProgram(std::string_view vertex, std::string_view fragment) {
    const GLuint program = glCreateProgram();
    Compiled compiled{program, {}};
    const auto attach = [&](GLenum stage, std::string_view text) {
        const GLuint shader = glCreateShader(stage);
        const GLchar* source = text.data();
        const auto length = static_cast<GLint>(text.size());
        glShaderSource(shader, 1, &source, &length);
        glCompileShader(shader);
        std::array<char, 4096> log{};
        glGetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), nullptr, log.data());
        compiled.log += log.data();
        glAttachShader(program, shader);
        glDeleteShader(shader);
    };
    attach(GL_VERTEX_SHADER, vertex);
    attach(GL_FRAGMENT_SHADER, fragment);
    glLinkProgram(program);
    GLint linked = GL_FALSE;
    glGetProgramiv(program, GL_LINK_STATUS, &linked);
    if (linked != GL_TRUE) {
        compiled.program = 0;
        glDeleteProgram(program);
        return compiled;
    }
    ++programs;
    return compiled;
}

void GlDevice::dropProgram(unsigned name) {
    glDeleteProgram(name);
    --programs;
}

unsigned GlDevice::makeTarget(view::Size size) {
    GLuint framebuffer = 0;
    Target target;
    glGenTextures(1, &target.color);
    glBindTexture(GL_TEXTURE_2D, target.color);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, size.width, size.height, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    glGenRenderbuffers(1, &target.depth);
    glBindRenderbuffer(GL_RENDERBUFFER, target.depth);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, size.width, size.height);
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, target.color, 0);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, target.depth);
    targets_[framebuffer] = target;
    return framebuffer;
}

void GlDevice::dropTarget(unsigned name) {
    const Target target = targets_[name];
    targets_.erase(name);
    glDeleteFramebuffers(1, &name);
    glDeleteRenderbuffers(1, &target.depth);
    glDeleteTextures(1, &target.color);
}

view::PictureHandle GlDevice::pictureOf(unsigned target) const {
    return render::handleOf(targets_.at(target).color);
}

void GlDevice::read(unsigned target, Image& image) {
    const render::StateGuard guard;
    glBindFramebuffer(GL_FRAMEBUFFER, target);
    glReadPixels(0, 0, image.width, image.height, GL_RGBA, GL_UNSIGNED_BYTE, image.pixels.data());
}

void GlDevice::begin(unsigned target, view::Size size, const glm::vec4& background) {
    guard_.emplace();
    glEnable(GL_PROGRAM_POINT_SIZE); // as OpenGL ES has it always
    glBindFramebuffer(GL_FRAMEBUFFER, target);
    glViewport(0, 0, size.width, size.height);
    glClearColor(background.r, background.g, background.b, background.a);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

void GlDevice::setFragmentTests(const Pass& pass) {
    (pass.depthTest ? glEnable : glDisable)(GL_DEPTH_TEST);
    glDepthFunc(static_cast<GLenum>(pass.depthFunc));
    (pass.blend ? glEnable : glDisable)(GL_BLEND);
    glBlendFunc(static_cast<GLenum>(pass.blendSrc), static_cast<GLenum>(pass.blendDst));
}

void GlDevice::use(unsigned program) {
    program_ = program;
    glUseProgram(program);
}

void GlDevice::setUniform(std::string_view name, gles::UniformKind kind, const void* values, int count) {
    const GLint location = glGetUniformLocation(program_, std::string(name).c_str());
    const auto* floats = static_cast<const float*>(values);
    const auto* ints = static_cast<const int*>(values);
    switch (kind) {
    case gles::UniformKind::Int:
        return glUniform1iv(location, count, ints);
    case gles::UniformKind::Float:
        return glUniform1fv(location, count, floats);
    case gles::UniformKind::Vec3:
        return glUniform3fv(location, count, floats);
    case gles::UniformKind::Vec4:
        return glUniform4fv(location, count, floats);
    case gles::UniformKind::Mat3:
        return glUniformMatrix3fv(location, count, GL_FALSE, floats);
    case gles::UniformKind::Mat4:
        return glUniformMatrix4fv(location, count, GL_FALSE, floats);
    case gles::UniformKind::Ivec4:
        return glUniform4iv(location, count, ints);
    }
}

void GlDevice::setTexels(int unit, unsigned texels) {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glBindTexture(GL_TEXTURE_2D, texels);
}

void GlDevice::setAttribute(unsigned location, unsigned buffer, int components, int stride,
                            std::size_t offset) {
    enabled_[location] = buffer;
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    glEnableVertexAttribArray(location);
    glVertexAttribPointer(
        location, components, GL_FLOAT, GL_FALSE, stride,
        reinterpret_cast<const void*>(offset)); // NOLINT(performance-no-int-to-ptr): an offset
}

void GlDevice::setAttribute(unsigned location, const glm::vec4& value) {
    enabled_.erase(location);
    glDisableVertexAttribArray(location);
    glVertexAttrib4f(location, value.r, value.g, value.b, value.a);
}

void GlDevice::draw(int corners, unsigned indices, std::size_t first, std::size_t count) {
    for (const unsigned buffer : enabled_ | std::views::values)
        assert(glIsBuffer(buffer)); // else WebGL refuses to draw
    constexpr std::array<GLenum, 3> primitives{GL_POINTS, GL_LINES, GL_TRIANGLES};
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices);
    glDrawElements(primitives.at(static_cast<std::size_t>(corners - 1)), static_cast<GLsizei>(count),
                   GL_UNSIGNED_INT,
                   reinterpret_cast<const void*>(first * 4)); // NOLINT(performance-no-int-to-ptr): an offset
}

void GlDevice::end() {
    guard_.reset();
}

} // namespace texplorer::test
