#include "app/opengl/opengl_graphics.h"

#include "app/render/capabilities.h"
#include "app/render/cost_meter.h"

#include <GL/glew.h>
#include <backends/imgui_impl_opengl2.h>

#include <algorithm>
#include <utility>

namespace texplorer::opengl {
namespace {

const PanelBackend fixedBackend{[] { ImGui_ImplOpenGL2_Init(); },
                                ImGui_ImplOpenGL2_Shutdown,
                                ImGui_ImplOpenGL2_DestroyFontsTexture,
                                [] { ImGui_ImplOpenGL2_CreateFontsTexture(); },
                                ImGui_ImplOpenGL2_NewFrame,
                                ImGui_ImplOpenGL2_RenderDrawData};

} // namespace

Result<std::unique_ptr<OpenGlGraphics>> OpenGlGraphics::create(render::ShaderOptions shaders,
                                                               const view::Pretence& pretence) {
    Result<view::Capabilities> capabilities = render::loadCapabilities();
    if (!capabilities)
        return fail(capabilities.error());
    return std::unique_ptr<OpenGlGraphics>(
        new OpenGlGraphics(pretence.of(std::move(*capabilities)), std::move(shaders)));
}

OpenGlGraphics::OpenGlGraphics(view::Capabilities capabilities, render::ShaderOptions shaders)
    : ContextGraphics(fixedBackend)
    , capabilities_(std::move(capabilities))
    , offered_(render::offeredRenderers(capabilities_))
    , shaders_(std::move(shaders)) {}

Result<render::SceneRenderer>& OpenGlGraphics::rendererOf(RendererKind kind, view::Side side) {
    const auto found = renderers_.find({side, kind});
    if (found != renderers_.end())
        return found->second;
    Result<render::SceneRenderer> made = render::createRenderer(kind, capabilities_, shaders_);
    const auto other = std::ranges::find_if(renderers_, [side](const auto& entry) {
        return entry.first.first == side && entry.second.has_value();
    });
    if (made && other != renderers_.end())
        made->shareTextures(*other->second);
    return renderers_.emplace(std::pair(side, kind), std::move(made)).first->second;
}

Result<view::Frame> OpenGlGraphics::draw(RendererKind renderer, view::Side side, const Scene& scene,
                                         const ImageSource& images, double time, view::Size size,
                                         LevelsSource& levels) {
    Result<render::SceneRenderer>& found = rendererOf(renderer, side);
    if (!found)
        return fail(found.error());
    Result<view::Frame> frame = found->draw(scene, images, time, size, &levels);
    glFlush(); // a software renderer draws on its own threads while the panels are built here
    return frame;
}

Result<Image> OpenGlGraphics::read(RendererKind renderer, view::Side side) {
    Result<render::SceneRenderer>& found = rendererOf(renderer, side);
    return found ? found->read() : fail(found.error());
}

view::PictureHandle OpenGlGraphics::showTexture(const Texture& texture, const ImageSource& images,
                                                LevelsSource& levels) {
    return render::handleOf(preview_.show(texture, images, &levels));
}

std::unique_ptr<view::CostMeter> OpenGlGraphics::costMeter(view::CostSubject subject) {
    return std::make_unique<render::CostMeter>(capabilities_, std::move(subject), view::costPairs);
}

} // namespace texplorer::opengl
