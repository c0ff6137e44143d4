#pragma once

#include "app/opengl/context_graphics.h"
#include "app/render/shader_renderer.h"
#include "app/render/texture_preview.h"
#include "app/view/pretence.h"

#include <map>
#include <utility>

namespace texplorer::opengl {

/// Paints with OpenGL: the fixed function and the shaders, pictures as textures, the panels with Dear ImGui's
/// OpenGL2 backend, which draws on a window's context and without a display alike. Belongs to the context
/// that is current, on its thread, and must be destroyed before that. A renderer is made when it is first
/// asked for.
class OpenGlGraphics final : public ContextGraphics {
public:
    /// `shaders` are for the shader renderer, `pretence` is taken from what the driver has. The error says
    /// what the driver lacks.
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
