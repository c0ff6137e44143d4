#include "app/render/gl_functions.h"

#include "texplorer/base/translatable.h"

#include <GL/glew.h>

#include <array>

namespace texplorer::render {

namespace {

constexpr const char* version12 = N_("OpenGL 1.2");
constexpr const char* version13 = N_("OpenGL 1.3");
constexpr const char* version14 = N_("OpenGL 1.4");
constexpr const char* version15 = N_("OpenGL 1.5");
constexpr const char* version20 = N_("OpenGL 2.0");
constexpr const char* framebuffers = "GL_ARB_framebuffer_object";

// GLEW's names are macros that expand to the pointers.
#define TEXPLORER_GL(function, source, needed)                                                               \
    {                                                                                                        \
#function, source, [] { return (function) != nullptr; }, needed                                      \
    }

constexpr auto functions = std::to_array<GlFunction>({
    TEXPLORER_GL(glDrawRangeElements, version12, true),
    TEXPLORER_GL(glTexImage3D, version12, true),
    TEXPLORER_GL(glTexSubImage3D, version12, true),
    TEXPLORER_GL(glActiveTexture, version13, true),
    TEXPLORER_GL(glClientActiveTexture, version13, true),
    TEXPLORER_GL(glCompressedTexImage2D, version13, true),
    TEXPLORER_GL(glGetCompressedTexImage, version13, true),
    TEXPLORER_GL(glBlendEquation, version14, true),
    TEXPLORER_GL(glBindBuffer, version15, true),
    TEXPLORER_GL(glBufferData, version15, true),
    TEXPLORER_GL(glDeleteBuffers, version15, true),
    TEXPLORER_GL(glGenBuffers, version15, true),
    TEXPLORER_GL(glAttachShader, version20, true),
    TEXPLORER_GL(glCompileShader, version20, true),
    TEXPLORER_GL(glCreateProgram, version20, true),
    TEXPLORER_GL(glCreateShader, version20, true),
    TEXPLORER_GL(glDeleteProgram, version20, true),
    TEXPLORER_GL(glDeleteShader, version20, true),
    TEXPLORER_GL(glDetachShader, version20, true),
    TEXPLORER_GL(glDisableVertexAttribArray, version20, true),
    TEXPLORER_GL(glEnableVertexAttribArray, version20, true),
    TEXPLORER_GL(glGetActiveUniform, version20, true),
    TEXPLORER_GL(glGetProgramInfoLog, version20, true),
    TEXPLORER_GL(glGetProgramiv, version20, true),
    TEXPLORER_GL(glGetShaderInfoLog, version20, true),
    TEXPLORER_GL(glGetShaderiv, version20, true),
    TEXPLORER_GL(glGetUniformLocation, version20, true),
    TEXPLORER_GL(glLinkProgram, version20, true),
    TEXPLORER_GL(glShaderSource, version20, true),
    TEXPLORER_GL(glUniform1f, version20, true),
    TEXPLORER_GL(glUniform1i, version20, true),
    TEXPLORER_GL(glUniform3fv, version20, true),
    TEXPLORER_GL(glUniform4fv, version20, true),
    TEXPLORER_GL(glUniformMatrix3fv, version20, true),
    TEXPLORER_GL(glUniformMatrix4fv, version20, true),
    TEXPLORER_GL(glUseProgram, version20, true),
    TEXPLORER_GL(glVertexAttrib4fv, version20, true),
    TEXPLORER_GL(glVertexAttribPointer, version20, true),
    TEXPLORER_GL(glBindFramebuffer, framebuffers, true),
    TEXPLORER_GL(glBindRenderbuffer, framebuffers, true),
    TEXPLORER_GL(glCheckFramebufferStatus, framebuffers, true),
    TEXPLORER_GL(glDeleteFramebuffers, framebuffers, true),
    TEXPLORER_GL(glDeleteRenderbuffers, framebuffers, true),
    TEXPLORER_GL(glFramebufferRenderbuffer, framebuffers, true),
    TEXPLORER_GL(glFramebufferTexture2D, framebuffers, true),
    TEXPLORER_GL(glGenFramebuffers, framebuffers, true),
    TEXPLORER_GL(glGenRenderbuffers, framebuffers, true),
    TEXPLORER_GL(glGenerateMipmap, framebuffers, true),
    TEXPLORER_GL(glRenderbufferStorage, framebuffers, true),
    TEXPLORER_GL(glGetStringi, N_("OpenGL 3.0"), false),
    TEXPLORER_GL(glProvokingVertex, "GL_ARB_provoking_vertex", false),
    TEXPLORER_GL(glBindSampler, "GL_ARB_sampler_objects", false),
    TEXPLORER_GL(glBindVertexArray, "GL_ARB_vertex_array_object", false),
});
#undef TEXPLORER_GL

} // namespace

std::span<const GlFunction> glFunctions() {
    return functions;
}

} // namespace texplorer::render
