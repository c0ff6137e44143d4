#include "app/opengl/context_graphics.h"

#include <GL/glew.h>

namespace texplorer::opengl {
namespace {

void setBlending(const ImDrawList* /*list*/, const ImDrawCmd* command) {
    (command->UserCallbackData ? glEnable : glDisable)(GL_BLEND);
}

} // namespace

view::PictureHandle ContextGraphics::show(const std::shared_ptr<const Image>& image, Use use) {
    return pictures_.show(image, use == Use::Enlarged ? render::PictureCache::Use::Enlarged
                                                      : render::PictureCache::Use::Scaled);
}

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
