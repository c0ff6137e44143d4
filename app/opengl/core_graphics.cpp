#include "app/opengl/core_graphics.h"

#include "app/render/capabilities.h"
#include "app/render/rgba_pixels.h"
#include "texplorer/s3tc/surface_pixels.h"

#include <GL/glew.h>
#include <backends/imgui_impl_opengl3.h>

#include <new>
#include <utility>

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

/// nullptr: not ready. What is drawn can change with every frame, so that a worker would never finish it.
std::shared_ptr<const PreparedLevels> preparedFor(const LevelsRequest& request, LevelsSource& source) {
    if (!isDrawn(request.settings.source))
        return source.prepare(request);
    return std::make_shared<const PreparedLevels>(
        prepareLevels(request.settings, request.pictures, request.target));
}

/// The base level; nullptr if it cannot be made.
std::shared_ptr<const Image> pictureOf(const LevelsRequest& request, const PreparedLevels& levels) {
    if (!levels)
        return nullptr;
    const SharedSurface& base = levels->levels.front().surface;
    const BaseFormat format = baseFormat(request.settings.internalFormat);
    return std::make_shared<const Image>(render::asRgba8(toImage(*base), format));
}

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
    const std::optional<LevelsRequest> request = preview_.request(texture, images);
    if (!request)
        return view::PictureHandle::None;
    try {
        if (previewed_ != request) {
            if (const std::shared_ptr<const PreparedLevels> made = preparedFor(*request, levels)) {
                if (*made || made->error().code != ErrorCode::Cancelled)
                    texture_ = pictureOf(*request, *made);
                previewed_ = request;
                if (!isDrawn(request->settings.source))
                    levels.uploaded(*request, made, {});
            }
        }
        return show(texture_, Use::Enlarged);
    } catch (const std::bad_alloc&) {
        return view::PictureHandle::None;
    }
}

} // namespace texplorer::opengl
