#include "app/stage/stage.h"

#include "app/stage/view_frames.h"
#include "app/ui/model/scene_files.h"
#include "app/ui/view/panes.h"
#include "app/ui/widgets/keys.h"
#include "app/ui/widgets/theme.h"
#include "app/ui/window/layout.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

namespace texplorer::stage {
namespace {

constexpr float shortestFrame = 1e-4F; // seconds: Dear ImGui wants its time to go on

} // namespace

/// Dear ImGui, as the host draws it.
class HostedPanels {
public:
    HostedPanels(Graphics& graphics, float scale)
        : graphics_(graphics)
        , scale_(scale) {
        ImGui::CreateContext();
        ui::applyTheme(scale);
        ui::mapKeys();
        graphics_.startPanels();
    }
    ~HostedPanels() {
        graphics_.endPanels();
        ImGui::DestroyContext();
    }
    HostedPanels(const HostedPanels&) = delete;
    HostedPanels& operator=(const HostedPanels&) = delete;

    void setScale(float scale) {
        if (scale == scale_)
            return;
        scale_ = scale;
        ui::applyTheme(scale);
        graphics_.fontsChanged();
    }

private:
    Graphics& graphics_;
    float scale_;
};

struct Stage::State {
    State(Graphics& lent, float scale)
        : graphics(lent)
        , frames(lent)
        , panels(lent, scale) {}

    Graphics& graphics;
    ViewFrames frames;
    HostedPanels panels;
    ui::PanelStates states;
    std::vector<std::string> problems;
};

Stage::Stage(Graphics& graphics, float scale)
    : state_(std::make_unique<State>(graphics, scale)) {}
Stage::Stage(Stage&&) noexcept = default;
Stage& Stage::operator=(Stage&&) noexcept = default;
Stage::~Stage() = default;

const std::vector<std::string>& Stage::problems() const {
    return state_->problems;
}

ui::Requests Stage::draw(ui::Session& session, const Surface& surface, float seconds,
                         const std::function<void()>& feedInput) {
    Graphics& graphics = state_->graphics;
    state_->panels.setScale(surface.scale);
    if (const std::string instead = ui::offerRenderers(session.window.view, graphics.renderers());
        !instead.empty())
        ui::say(session, instead);
    const float density =
        static_cast<float>(surface.pixels.width) / static_cast<float>(std::max(1, surface.size.width));
    const ui::Layout layout = ui::layoutFor(surface.size.width, surface.size.height, surface.scale / density,
                                            session.window.columns, ui::gridOf(session.window.view));
    ui::settle(session, layout);

    const auto toPixels = [density](int length) {
        return std::max(1, static_cast<int>(std::lround(static_cast<float>(length) * density)));
    };
    const view::Size picture{toPixels(layout.picture.width), toPixels(layout.picture.height)};
    state_->frames.draw(session, picture);
    const Texture* bound = ui::boundTexture(std::as_const(session));
    const view::PictureHandle texture =
        bound ? graphics.showTexture(*bound, state_->frames.images(), session.services.levels)
              : view::PictureHandle::None;

    graphics.beginFrame();
    ImGuiIO& io = ImGui::GetIO();
    io.DisplaySize = {static_cast<float>(surface.size.width), static_cast<float>(surface.size.height)};
    io.DisplayFramebufferScale = {density, density};
    io.DeltaTime = std::max(seconds, shortestFrame);
    if (feedInput)
        feedInput();
    ImGui::NewFrame();
    const auto keep = [&graphics](const std::shared_ptr<const Image>& image) {
        return graphics.show(image, Graphics::Use::Scaled);
    };
    ui::Requests requests = ui::drawWorkbench(session, state_->states,
                                              {.frames = state_->frames.frames(),
                                               .difference = state_->frames.difference(),
                                               .problems = state_->frames.problems(),
                                               .shaders = state_->frames.shaders(),
                                               .texture = texture,
                                               .setBlending = graphics.blendingSwitch(),
                                               .keep = keep},
                                              graphics.capabilities(), layout);
    requests.unfinished = state_->frames.isUnfinished() || graphics.isUploading();
    ImGui::Render();

    graphics.drawPanels(*ImGui::GetDrawData(), surface.pixels);
    graphics.endFrame();
    state_->problems = state_->frames.problems();
    return requests;
}

} // namespace texplorer::stage
