#include "app/stage/stage.h"

#include "app/render/picture_cache.h"
#include "app/stage/view_pictures.h"
#include "app/ui/view/panes.h"
#include "app/ui/widgets/theme.h"
#include "app/ui/window/layout.h"

#include <GL/glew.h>
#include <backends/imgui_impl_opengl2.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

namespace texplorer::stage {
namespace {

/// Dear ImGui with its OpenGL2 backend, which draws on a window's context and on OSMesa alike.
class Panels {
public:
    explicit Panels(float scale)
        : scale_(scale) {
        ImGui::CreateContext();
        ui::applyTheme(scale);
        ImGui_ImplOpenGL2_Init();
    }
    ~Panels() {
        ImGui_ImplOpenGL2_Shutdown();
        ImGui::DestroyContext();
    }
    Panels(const Panels&) = delete;
    Panels& operator=(const Panels&) = delete;

    void setScale(float scale) {
        if (scale == scale_)
            return;
        scale_ = scale;
        ImGui_ImplOpenGL2_DestroyFontsTexture();
        ui::applyTheme(scale);
        ImGui_ImplOpenGL2_CreateFontsTexture();
    }

private:
    float scale_;
};

void setBlending(const ImDrawList* /*list*/, const ImDrawCmd* command) {
    (command->UserCallbackData ? glEnable : glDisable)(GL_BLEND);
}

} // namespace

struct Stage::State {
    view::Capabilities capabilities;
    ViewPictures views;
    render::TexturePreview preview;
    render::PictureCache pictures;
    Panels panels;
    ui::PanelStates states;
    std::vector<std::string> problems;

    State(view::Capabilities found, const render::ShaderOptions& shaders, float scale)
        : capabilities(std::move(found))
        , views(capabilities, shaders)
        , panels(scale) {}
};

Result<Stage> Stage::create(float scale, const render::ShaderOptions& shaders) {
    Result<view::Capabilities> capabilities = render::loadCapabilities();
    if (!capabilities)
        return fail(capabilities.error());
    return Stage(std::make_unique<State>(std::move(*capabilities), shaders, scale));
}

Stage::Stage(std::unique_ptr<State> state)
    : state_(std::move(state)) {}
Stage::Stage(Stage&&) noexcept = default;
Stage& Stage::operator=(Stage&&) noexcept = default;
Stage::~Stage() = default;

const view::Capabilities& Stage::capabilities() const {
    return state_->capabilities;
}

const std::vector<std::string>& Stage::problems() const {
    return state_->problems;
}

ui::Requests Stage::draw(ui::Session& session, const Surface& surface,
                         const std::function<void()>& feedInput) {
    state_->panels.setScale(surface.scale);
    const float density =
        static_cast<float>(surface.pixels.width) / static_cast<float>(std::max(1, surface.size.width));
    const ui::Layout layout = ui::layoutFor(surface.size.width, surface.size.height, surface.scale / density,
                                            session.window.columns, ui::gridOf(session.window.views));
    ui::settle(session, layout);

    const auto toPixels = [density](int length) {
        return std::max(1, static_cast<int>(std::lround(static_cast<float>(length) * density)));
    };
    const view::Size picture{toPixels(layout.picture.width), toPixels(layout.picture.height)};
    state_->views.draw(session, picture);
    const Texture* bound = ui::boundTexture(std::as_const(session));
    const unsigned texture =
        bound ? state_->preview.show(*bound, session.document.images, &session.services.levels) : 0;

    ImGui_ImplOpenGL2_NewFrame();
    ImGui::GetIO().DisplaySize = {static_cast<float>(surface.size.width),
                                  static_cast<float>(surface.size.height)};
    ImGui::GetIO().DisplayFramebufferScale = {density, density};
    if (feedInput)
        feedInput();
    ImGui::NewFrame();
    const auto textureOf = [this](const std::shared_ptr<const Image>& image) {
        return state_->pictures.show(image);
    };
    ui::Requests requests = ui::drawWorkbench(session, state_->states,
                                              {.views = state_->views.views(),
                                               .difference = state_->views.difference(),
                                               .problems = state_->views.problems(),
                                               .shaders = state_->views.shaders(),
                                               .texture = texture,
                                               .setBlending = setBlending,
                                               .textureOf = textureOf},
                                              state_->capabilities, layout);
    requests.unfinished = state_->views.isUnfinished() || state_->preview.isUploading();
    ImGui::Render();

    glViewport(0, 0, surface.pixels.width, surface.pixels.height);
    glClearColor(0, 0, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    ImGui_ImplOpenGL2_RenderDrawData(ImGui::GetDrawData());
    state_->pictures.endFrame();
    state_->problems = state_->views.problems();
    return requests;
}

} // namespace texplorer::stage
