#include "app/stage/stage.h"

#include "app/stage/view_frames.h"
#include "app/ui/language/translate.h"
#include "app/ui/model/notice.h"
#include "app/ui/model/settle.h"
#include "app/ui/state/layout.h"
#include "app/ui/view/panes.h"
#include "app/ui/widgets/keys.h"
#include "app/ui/widgets/panel.h"
#include "app/ui/widgets/theme.h"
#include "app/ui/window/layout.h"
#include "texplorer/base/sentence_format.h"

#include <imgui.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>
#include <utility>

namespace texplorer::stage {
namespace {

constexpr float minFrameSeconds = 1e-4F; // seconds: Dear ImGui requires a positive time step

/// Writes the requested picture from the frame that was just drawn, or from a later one if its view is not
/// complete.
void writeCapture(ui::Session& session, Graphics& graphics, const ui::ViewFrame& view, view::Size window) {
    const std::optional<ui::Capture> wanted = std::exchange(session.window.wantedCapture, std::nullopt);
    if (!wanted || !session.services.captures)
        return;
    if (*wanted == ui::Capture::Window)
        return session.services.captures->write("texplorer-window", graphics.readPanels(window));
    if (view.image)
        return session.services.captures->write("texplorer-view", Image(*view.image));
    if (!view.whole) {
        session.window.wantedCapture = wanted;
        return ui::say(session, N_("The picture is written when the reference has drawn it."));
    }
    if (view.renderer == RendererKind::Reference)
        return ui::say(session, view.frame.problems.empty() ? Sentence() : view.frame.problems.front());
    Result<Image> image = graphics.read(view.renderer, view.side);
    if (!image)
        return ui::say(session, image.error());
    session.services.captures->write("texplorer-view", *std::move(image));
}

} // namespace

/// Goes on measuring what textures cost, if the session wants it: little enough for the window to stay
/// fluent.
void measureCosts(ui::CostFigure& figure, Graphics& graphics, std::unique_ptr<view::CostMeter>& meter) {
    constexpr std::chrono::milliseconds time(20);
    figure.driver = graphics.capabilities().renderer;
    if (!figure.subject) {
        meter.reset();
        return;
    }
    if (!meter)
        meter = graphics.costMeter(*figure.subject);
    if (!meter || !meter->measure(figure.costs, time)) {
        meter.reset();
        figure.subject.reset();
    }
}

/// Dear ImGui with the host's graphics.
class HostedPanels {
public:
    HostedPanels(Graphics& graphics, float scale)
        : graphics_(graphics)
        , scale_(scale) {
        ImGui::CreateContext();
        ui::applyTheme(scale_, appearance_, nullptr, letters_);
        ui::prepareKeys();
        graphics_.startPanels();
    }
    ~HostedPanels() {
        graphics_.endPanels();
        ImGui::DestroyContext();
        ui::useCatalogue(nullptr);
    }
    HostedPanels(const HostedPanels&) = delete;
    HostedPanels& operator=(const HostedPanels&) = delete;

    /// Returns sentences about missing things, such as letters that no font has.
    [[nodiscard]] Sentence setLook(float scale, const ui::Settings& settings, ui::Language system) {
        const ui::Language language = settings.language == ui::Language::System ? system : settings.language;
        Sentence problem;
        const bool fontCame = waitsForFont_ && ui::hasLettersOf(ui::Language::Chinese);
        waitsForFont_ = waitsForFont_ && !fontCame;
        const bool translated = language != language_ || fontCame;
        if (translated)
            problem = setLanguage(language);
        ui::useCatalogue(catalogue_.get());
        ui::beginTranslations();
        const ui::Appearance appearance = ui::appearanceOf(settings);
        if (scale == scale_ && appearance == appearance_ && !translated && !lacksLetters_)
            return problem;
        scale_ = scale;
        appearance_ = appearance;
        lacksLetters_ = false;
        ui::applyTheme(scale_, appearance_, catalogue_.get(), letters_);
        graphics_.fontsChanged();
        return problem;
    }

    /// Whether it has letters that the next frame will provide.
    [[nodiscard]] bool lacksLetters(const ImDrawData& drawn) {
        lacksLetters_ = letters_.look(drawn);
        if (lacksLetters_ && letters_.needChineseFont() && !ui::hasLettersOf(ui::Language::Chinese))
            waitsForFont_ = graphics_.fetchFont();
        return lacksLetters_;
    }

private:
    Sentence setLanguage(ui::Language language) {
        language_ = language;
        ui::useCatalogue(nullptr);
        catalogue_.reset();
        if (!ui::hasLettersOf(language)) {
            waitsForFont_ = graphics_.fetchFont();
            if (waitsForFont_)
                return {};
            return N_("No readable font with Chinese characters was found. Install fonts-droid-fallback or "
                      "fonts-wqy-microhei and restart Texplorer.");
        }
        Result<std::unique_ptr<const ui::Catalogue>> catalogue = ui::catalogueOf(language);
        if (!catalogue)
            return {N_("The window stays in English: {0}."), describe(catalogue.error())};
        catalogue_ = *std::move(catalogue);
        return {};
    }

    Graphics& graphics_;
    float scale_;
    ui::Language language_ = ui::Language::English;
    std::unique_ptr<const ui::Catalogue> catalogue_; ///< nullptr: English
    ui::Appearance appearance_;
    ui::Letters letters_;
    bool lacksLetters_ = false;
    bool waitsForFont_ = false; ///< of Chinese letters
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
    std::vector<Sentence> problems;
    std::unique_ptr<view::CostMeter> meter; ///< nullptr: nothing is measured
};

Stage::Stage(Graphics& graphics, float scale)
    : state_(std::make_unique<State>(graphics, scale)) {}
Stage::Stage(Stage&&) noexcept = default;
Stage& Stage::operator=(Stage&&) noexcept = default;
Stage::~Stage() = default;

const std::vector<Sentence>& Stage::problems() const {
    return state_->problems;
}

ui::Requests Stage::draw(ui::Session& session, const Surface& surface, float seconds,
                         const std::function<void()>& feedInput) {
    Graphics& graphics = state_->graphics;
    if (const Sentence problem =
            state_->panels.setLook(surface.scale, session.settings, session.window.systemLanguage);
        !problem.empty())
        ui::say(session, problem);
    if (const Sentence instead = ui::offerRenderers(session.view, graphics.renderers()); !instead.empty())
        ui::say(session, instead);
    const float density =
        static_cast<float>(surface.pixels.width) / static_cast<float>(std::max(1, surface.size.width));
    const ui::Settings& settings = session.settings;
    const ui::Layout layout = ui::layoutFor(
        surface.size.width, surface.size.height, ui::textScale(surface.scale / density, settings.textPercent),
        settings.workspace, ui::gridOf(session.view), settings.largeControls);
    ui::settle(session, layout);

    const auto toPixels = [density](int length) {
        return std::max(1, static_cast<int>(std::lround(static_cast<float>(length) * density)));
    };
    measureCosts(session.cost, graphics, state_->meter); // before drawing: the driver has nothing else to do
    const view::Size picture{toPixels(layout.picture.width), toPixels(layout.picture.height)};
    state_->frames.draw(session, picture);
    session.drawn = state_->frames.images();
    const Texture* bound = ui::boundTexture(std::as_const(session));
    const view::PictureHandle texture =
        bound ? graphics.showTexture(*bound, state_->frames.images(), session.services.levels)
              : view::PictureHandle::None;

    graphics.beginFrame();
    ImGuiIO& io = ImGui::GetIO();
    io.DisplaySize = {static_cast<float>(surface.size.width), static_cast<float>(surface.size.height)};
    io.DisplayFramebufferScale = {density, density};
    io.DeltaTime = std::max(seconds, minFrameSeconds);
    if (feedInput)
        feedInput();
    ImGui::NewFrame();
    const auto keepFor = [&graphics](Graphics::Use use) {
        return
            [&graphics, use](const std::shared_ptr<const Image>& image) { return graphics.show(image, use); };
    };
    ui::Requests requests = ui::drawWorkbench(session, state_->states,
                                              {.frames = state_->frames.frames(),
                                               .difference = state_->frames.difference(),
                                               .problems = state_->frames.problems(),
                                               .shaders = state_->frames.shaders(),
                                               .texture = texture,
                                               .setBlending = graphics.blendingSwitch(),
                                               .keep = keepFor(Graphics::Use::Scaled),
                                               .keepTexels = keepFor(Graphics::Use::Enlarged)},
                                              graphics.capabilities(), layout);
    ImGui::Render();
    const bool lacksLetters = state_->panels.lacksLetters(*ImGui::GetDrawData());
    requests.unfinished |= lacksLetters || state_->frames.isUnfinished() || graphics.isUploading() ||
                           session.cost.subject.has_value();

    graphics.drawPanels(*ImGui::GetDrawData(), surface.pixels, ui::panelGround());
    writeCapture(session, graphics, state_->frames.frames().front(), surface.pixels);
    graphics.endFrame();
    state_->problems = state_->frames.problems();
    return requests;
}

} // namespace texplorer::stage
