#pragma once

#include "app/opengl/context_graphics.h"
#include "app/render/shader_renderer.h"
#include "app/render/texture_preview.h"
#include "app/view/pretence.h"

#include <map>
#include <utility>

namespace texplorer::opengl {

/// Draws with OpenGL: the fixed-function and the shader renderer, pictures as textures, the panels with Dear
/// ImGui's OpenGL2 backend. Works with a window's context and without a display. Belongs to the current
/// context and its thread, and must be destroyed before the context. A renderer is created at its first use.
class OpenGlGraphics final : public ContextGraphics {
public:
    /// `shaders` are for the shader renderer; `pretence` removes features of the driver. The error says what
    /// the driver lacks.
    [[nodiscard]] static Result<std::unique_ptr<OpenGlGraphics>> create(render::ShaderOptions shaders = {},
                                                                        const view::Pretence& pretence = {});

    [[nodiscard]] const view::Capabilities& capabilities() const override { return capabilities_; }
    [[nodiscard]] const view::OfferedRenderers& renderers() const override { return offered_; }
    [[nodiscard]] Result<view::Frame> draw(RendererKind renderer, view::Side side, const Scene& scene,
                                           const ImageSource& images, double time, view::Size size,
                                           LevelsSource& levels) override;
    [[nodiscard]] Result<Image> read(RendererKind renderer, view::Side side) override;
    [[nodiscard]] view::PictureHandle showTexture(const Texture& texture, const ImageSource& images,
                                                  LevelsSource& levels) override;
    [[nodiscard]] bool isUploading() const override { return preview_.isUploading(); }
    [[nodiscard]] std::unique_ptr<view::CostMeter> costMeter(view::CostSubject subject) override;

private:
    OpenGlGraphics(view::Capabilities capabilities, render::ShaderOptions shaders);
    Result<render::SceneRenderer>& rendererOf(RendererKind kind, view::Side side);

    view::Capabilities capabilities_;
    view::OfferedRenderers offered_;
    render::ShaderOptions shaders_;
    std::map<std::pair<view::Side, RendererKind>, Result<render::SceneRenderer>> renderers_;
    render::TexturePreview preview_;
};

} // namespace texplorer::opengl
