#include "app/opengl/context_graphics.h"

#include "app/render/gl_errors.h"
#include "app/render/gl_handle.h"

#include <GL/glew.h>

namespace texplorer::opengl {
namespace {

void setBlending(const ImDrawList* /*list*/, const ImDrawCmd* command) {
    (command->UserCallbackData ? glEnable : glDisable)(GL_BLEND);
}

/// A 2D texture; None if OpenGL refused it. Restores the bound texture.
view::PictureHandle makeTexture(const Image& image, stage::Graphics::Use use) {
    GLint bound = 0;
    glGetIntegerv(GL_TEXTURE_BINDING_2D, &bound);
    GLuint texture = 0;
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER,
                    use == stage::Graphics::Use::Enlarged ? GL_NEAREST : GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, image.width, image.height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 image.pixels.data());
    glBindTexture(GL_TEXTURE_2D, static_cast<GLuint>(bound));
    render::GlErrors errors; // errors of pictures in panels are not reported
    if (errors.check("glTexImage2D"))
        return render::handleOf(texture);
    glDeleteTextures(1, &texture);
    return view::PictureHandle::None;
}

void dropTexture(view::PictureHandle picture) {
    const auto texture = static_cast<GLuint>(picture);
    glDeleteTextures(1, &texture); // of 0: nothing
}

} // namespace

ContextGraphics::ContextGraphics(const PanelBackend& backend)
    : backend_(backend)
    , pictures_({makeTexture, dropTexture}) {}

void ContextGraphics::fontsChanged() {
    backend_.dropFonts();
    backend_.makeFonts();
}

void ContextGraphics::drawPanels(ImDrawData& panels, view::Size pixels, const ImVec4& ground) {
    glViewport(0, 0, pixels.width, pixels.height);
    glClearColor(ground.x, ground.y, ground.z, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    backend_.draw(&panels);
}

Image ContextGraphics::readPanels(view::Size pixels) {
    Image image = Image::uninitialised(PixelFormat::Rgba8, pixels.width, pixels.height);
    glReadPixels(0, 0, image.width, image.height, GL_RGBA, GL_UNSIGNED_BYTE, image.pixels.data());
    return image;
}

ImDrawCallback ContextGraphics::blendingSwitch() const {
    return setBlending;
}

} // namespace texplorer::opengl
