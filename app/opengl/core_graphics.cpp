#include "app/opengl/core_graphics.h"

#include "app/render/capabilities.h"

#include <GL/glew.h>
#include <backends/imgui_impl_opengl3.h>

namespace texplorer::opengl {
namespace {

/// Core profiles start at OpenGL 3.2 with its GLSL; a forward-compatible context before that has an older
/// GLSL.
const char* shadingLanguage() {
    GLint major = 0;
    GLint minor = 0;
    glGetIntegerv(GL_MAJOR_VERSION, &major);
    glGetIntegerv(GL_MINOR_VERSION, &minor);
    return major > 3 || (major == 3 && minor >= 2) ? "#version 150" : "#version 130";
}

const PanelBackend coreBackend{[] { ImGui_ImplOpenGL3_Init(shadingLanguage()); },
                               ImGui_ImplOpenGL3_Shutdown,
                               ImGui_ImplOpenGL3_DestroyFontsTexture,
                               [] { ImGui_ImplOpenGL3_CreateFontsTexture(); },
                               ImGui_ImplOpenGL3_NewFrame,
                               ImGui_ImplOpenGL3_RenderDrawData};

} // namespace

CoreGraphics::CoreGraphics()
    : ContextGraphics(coreBackend)
    , capabilities_(render::namedCapabilities()) {
    const ProperName version{capabilities_.version};
    offered_.withhold(
        RendererKind::Fixed,
        Sentence("the driver has OpenGL {0} as a core profile alone, without fixed functions", version));
    offered_.withhold(RendererKind::Shader,
                      Sentence("the driver has OpenGL {0} as a core profile alone, without the texture "
                               "formats of the compatibility profile",
                               version));
}

Error CoreGraphics::lack(RendererKind renderer) const {
    return {ErrorCode::Unsupported, offered_.whyNot(renderer), {}};
}

Result<view::Frame> CoreGraphics::draw(RendererKind renderer, view::Side /*side*/, const Scene& /*scene*/,
                                       const ImageSource& /*images*/, double /*time*/, view::Size /*size*/,
                                       LevelsSource& /*levels*/) {
    return fail(lack(renderer));
}

Result<Image> CoreGraphics::read(RendererKind renderer, view::Side /*side*/) {
    return fail(lack(renderer));
}

view::PictureHandle CoreGraphics::showTexture(const Texture& texture, const ImageSource& images,
                                              LevelsSource& levels) {
    return show(preview_.show(texture, images, levels), Use::Enlarged);
}

} // namespace texplorer::opengl
