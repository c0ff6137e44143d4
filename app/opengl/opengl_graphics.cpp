#include "app/opengl/opengl_graphics.h"

#include "app/render/capabilities.h"

#include <GL/glew.h>
#include <backends/imgui_impl_opengl2.h>

#include <algorithm>
#include <utility>

namespace texplorer::opengl {
namespace {

void setBlending(const ImDrawList* /*list*/, const ImDrawCmd* command) {
    (command->UserCallbackData ? glEnable : glDisable)(GL_BLEND);
}

} // namespace

Result<std::unique_ptr<OpenGlGraphics>> OpenGlGraphics::create(render::ShaderOptions shaders) {
    Result<view::Capabilities> capabilities = render::loadCapabilities();
    if (!capabilities)
        return fail(capabilities.error());
    return std::unique_ptr<OpenGlGraphics>(new OpenGlGraphics(std::move(*capabilities), std::move(shaders)));
}

OpenGlGraphics::OpenGlGraphics(view::Capabilities capabilities, render::ShaderOptions shaders)
    : capabilities_(std::move(capabilities))
    , shaders_(std::move(shaders)) {}

Result<render::SceneRenderer>& OpenGlGraphics::rendererOf(RendererKind kind) {
    const auto found = renderers_.find(kind);
    if (found != renderers_.end())
        return found->second;
    Result<render::SceneRenderer> made = render::createRenderer(kind, capabilities_, shaders_);
    const auto other =
        std::ranges::find_if(renderers_, [](const auto& entry) { return entry.second.has_value(); });
    if (made && other != renderers_.end())
        made->shareTextures(*other->second);
    return renderers_.emplace(kind, std::move(made)).first->second;
}

Result<view::Frame> OpenGlGraphics::draw(RendererKind renderer, const Scene& scene, const ImageSource& images,
                                         double time, view::Size size, LevelsSource& levels) {
    Result<render::SceneRenderer>& found = rendererOf(renderer);
    return found ? found->draw(scene, images, time, size, &levels) : fail(found.error());
}

Result<Image> OpenGlGraphics::read(RendererKind renderer) {
    Result<render::SceneRenderer>& found = rendererOf(renderer);
    return found ? found->read() : fail(found.error());
}

unsigned OpenGlGraphics::show(const std::shared_ptr<const Image>& image, Use use) {
    return pictures_.show(image, use == Use::Enlarged ? render::PictureCache::Use::Enlarged
                                                      : render::PictureCache::Use::Scaled);
}

unsigned OpenGlGraphics::showTexture(const Texture& texture, const ImageSource& images,
                                     LevelsSource& levels) {
    return preview_.show(texture, images, &levels);
}

void OpenGlGraphics::startPanels() {
    ImGui_ImplOpenGL2_Init();
}

void OpenGlGraphics::endPanels() {
    ImGui_ImplOpenGL2_Shutdown();
}

void OpenGlGraphics::fontsChanged() {
    ImGui_ImplOpenGL2_DestroyFontsTexture();
    ImGui_ImplOpenGL2_CreateFontsTexture();
}

void OpenGlGraphics::beginFrame() {
    ImGui_ImplOpenGL2_NewFrame();
}

void OpenGlGraphics::drawPanels(ImDrawData& panels, view::Size pixels) {
    glViewport(0, 0, pixels.width, pixels.height);
    glClearColor(0, 0, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    ImGui_ImplOpenGL2_RenderDrawData(&panels);
}

ImDrawCallback OpenGlGraphics::blendingSwitch() const {
    return setBlending;
}

} // namespace texplorer::opengl
