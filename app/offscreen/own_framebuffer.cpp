#include "app/offscreen/own_framebuffer.h"

#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>
#include <fmt/core.h>

#include <array>
#include <cstdlib>
#include <string_view>

namespace texplorer::offscreen {
namespace {

// Some drivers can only draw with depth that is packed with a stencil.
constexpr std::array depthFormats{GL_DEPTH_COMPONENT24, GL_DEPTH24_STENCIL8};

std::string_view textOf(GLenum name) {
    const GLubyte* found = glGetString(name);
    return found ? reinterpret_cast<const char*>(found) : "";
}

/// Of OpenGL 3.0, or of the extension. A core profile, which has no such list, is newer than that.
bool hasFramebufferObjects() {
    return std::strtol(textOf(GL_VERSION).data(), nullptr, 10) >= 3 ||
           textOf(GL_EXTENSIONS).find("GL_ARB_framebuffer_object") != std::string_view::npos;
}

GLuint bindRenderbuffer(int format, view::Size size) {
    GLuint name = 0;
    glGenRenderbuffers(1, &name);
    glBindRenderbuffer(GL_RENDERBUFFER, name);
    glRenderbufferStorage(GL_RENDERBUFFER, static_cast<GLenum>(format), size.width, size.height);
    return name;
}

} // namespace

Result<void> bindOwnFramebuffer(view::Size size) {
    if (!hasFramebufferObjects())
        return {};
    GLint limit = 0;
    glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &limit);
    if (size.width < 1 || size.height < 1 || size.width > limit || size.height > limit)
        return fail(ErrorCode::OutOfRange,
                    fmt::format("an off-screen framebuffer has 1 x 1 to {} pixels, not {}",
                                asText(view::Size{limit, limit}), asText(size)));

    GLuint framebuffer = 0;
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    const GLuint color = bindRenderbuffer(GL_RGBA8, size);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, color);
    GLenum status = GL_FRAMEBUFFER_UNSUPPORTED;
    for (const int format : depthFormats) {
        if (status == GL_FRAMEBUFFER_COMPLETE)
            break;
        const GLuint depth = bindRenderbuffer(format, size);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth);
        status = glCheckFramebufferStatus(GL_FRAMEBUFFER);
    }
    glBindRenderbuffer(GL_RENDERBUFFER, 0);
    const GLenum error = glGetError();
    if (error == GL_OUT_OF_MEMORY)
        return fail(
            ErrorCode::TooLarge,
            fmt::format("there is no memory for an off-screen framebuffer of {} pixels", asText(size)));
    if (error != GL_NO_ERROR || status != GL_FRAMEBUFFER_COMPLETE)
        return fail(ErrorCode::Driver, fmt::format("{} can't draw into a framebuffer of {} pixels: "
                                                   "glCheckFramebufferStatus says {}",
                                                   textOf(GL_RENDERER), asText(size), status));
    glViewport(0, 0, size.width, size.height);
    glScissor(0, 0, size.width, size.height);
    return {};
}

} // namespace texplorer::offscreen
