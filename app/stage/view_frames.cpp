#include "app/stage/view_frames.h"

#include "app/ui/model/shown_passes.h"

#include <algorithm>
#include <array>
#include <utility>

namespace texplorer::stage {

void ViewFrames::draw(ui::Session& session, view::Size size) {
    frames_.clear();
    addLightDepths(session);
    for (const RendererKind kind : ui::shownRenderers(session.window.view)) {
        const auto drawn = std::ranges::find(frames_, kind, &ui::ViewFrame::renderer);
        if (drawn != frames_.end()) // compared with itself
            frames_.push_back(ui::ViewFrame(*drawn));
        else
            frames_.push_back(kind == RendererKind::Reference ? drawReference(session, size)
                                                              : drawLive(kind, session, size));
    }
    if (std::ranges::find(frames_, RendererKind::Reference, &ui::ViewFrame::renderer) == frames_.end())
        session.services.reference.rest();
    compareViews(session.window.view);
    problems_.clear();
    shaders_.clear();
    for (const ui::ViewFrame& view : frames_) {
        addProblems(view.frame.problems);
        if (view.renderer == RendererKind::Shader)
            shaders_ = view.frame.shaders;
    }
    const bool drawn =
        std::ranges::find(frames_, RendererKind::Shader, &ui::ViewFrame::renderer) != frames_.end();
    const bool offered = session.window.view.offered.has(RendererKind::Shader);
    if (session.window.shownTab == ui::Tab::Glsl && offered && !drawn) { // they are made while they draw
        const view::Frame frame = drawLive(RendererKind::Shader, session, size).frame;
        addProblems(frame.problems);
        shaders_ = frame.shaders;
    }
}

/// The reference draws its own, on its own thread: where nothing else shows them, they aren't needed here.
void ViewFrames::addLightDepths(const ui::Session& session) {
    const Texture* bound = ui::boundTexture(session);
    const auto isLive = [](RendererKind kind) { return kind != RendererKind::Reference; };
    images_ = session.document.images;
    if (!(bound && bound->source == SourceKind::LightDepth) &&
        std::ranges::none_of(ui::shownRenderers(session.window.view), isLive) &&
        session.window.shownTab != ui::Tab::Glsl)
        return;
    Scene stepped;
    images_ = lightDepths_.addedTo(images_, ui::shownScene(session, stepped), session.window.playback.time);
}

void ViewFrames::addProblems(const std::vector<std::string>& problems) {
    for (const std::string& problem : problems) {
        if (std::ranges::find(problems_, problem) == problems_.end())
            problems_.push_back(problem);
    }
}

ui::ViewFrame ViewFrames::drawLive(RendererKind kind, ui::Session& session, view::Size size) {
    ui::ViewFrame view{kind, {{}, size, 0, {}, false}, nullptr, true};
    Scene stepped;
    Result<view::Frame> frame = graphics_.draw(kind, ui::shownScene(session, stepped), images_,
                                               session.window.playback.time, size, session.services.levels);
    if (!frame) {
        view.frame.problems = {describe(frame.error())};
        return view;
    }
    view.frame = std::move(*frame);
    Pixels& pixels = pixels_[kind];
    if (!ui::wantsPixels(session.window.view) && !session.window.explaining.pixel) {
        pixels.image.reset();
        return view;
    }
    if (!pixels.image || pixels.revision != view.frame.revision) {
        Result<Image> read = graphics_.read(kind);
        if (!read) {
            view.frame.problems.push_back(describe(read.error()));
            return view;
        }
        pixels = {view.frame.revision, std::make_shared<const Image>(std::move(*read))};
    }
    view.image = pixels.image;
    return view;
}

ui::ViewFrame ViewFrames::drawReference(ui::Session& session, view::Size size) {
    Scene stepped;
    const reference::DrawWorker::Frame& picture = session.services.reference.frame(
        {ui::shownScene(session, stepped), images_, session.window.playback.time, size.width, size.height,
         session.window.view.anisotropy});
    const view::PictureHandle shown = graphics_.show(picture.image, Graphics::Use::Enlarged);
    return {RendererKind::Reference,
            {shown, size, picture.milliseconds, picture.problems, false},
            picture.whole ? picture.image : nullptr,
            picture.whole};
}

void ViewFrames::compareViews(const ui::ViewSettings& settings) {
    const auto imageOf = [this](RendererKind kind) {
        const auto found = std::ranges::find(frames_, kind, &ui::ViewFrame::renderer);
        return found == frames_.end() ? nullptr : found->image;
    };
    const std::array images{imageOf(settings.compared[0]), imageOf(settings.compared[1])};
    const HeatScale scale{settings.tolerance, 255};
    if (!ui::isComparing(settings) || !images[0] || !images[1]) {
        difference_.reset();
        compared_ = {};
        heatMap_.reset();
        return;
    }
    if (difference_ && compared_ == images && difference_->scale == scale) {
        difference_->heatMap = graphics_.show(heatMap_, Graphics::Use::Enlarged);
        return;
    }
    compared_ = images;
    difference_.reset();
    const Result<Difference> numbers = compare(*images[0], *images[1], settings.tolerance, Compared::Rgb);
    Result<Image> heat = heatMap(*images[0], *images[1], scale, Compared::Rgb);
    if (!numbers || !heat)
        return;
    heatMap_ = std::make_shared<const Image>(std::move(*heat));
    difference_ = {*numbers, scale, graphics_.show(heatMap_, Graphics::Use::Enlarged)};
}

bool ViewFrames::isUnfinished() const {
    return std::ranges::any_of(frames_, [](const ui::ViewFrame& view) { return view.frame.unfinished; });
}

} // namespace texplorer::stage
