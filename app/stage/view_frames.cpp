#include "app/stage/view_frames.h"

#include "app/stage/step_picture.h"
#include "app/ui/model/kept.h"
#include "app/ui/model/preview.h"
#include "app/ui/model/shown_passes.h"
#include "texplorer/scene/params/scene_at.h"

#include <algorithm>
#include <array>
#include <utility>

namespace texplorer::stage {

void ViewFrames::draw(ui::Session& session, view::Size size) {
    frames_.clear();
    addDrawnImages(session);
    Scene stepped;
    const Subject now{view::Side::Now, ui::shownScene(session, stepped), images_};
    for (const RendererKind kind : ui::shownRenderers(session.view)) {
        const auto drawn = std::ranges::find(frames_, kind, &ui::ViewFrame::renderer);
        if (drawn != frames_.end()) // compared with itself
            frames_.push_back(ui::ViewFrame(*drawn));
        else
            frames_.push_back(draw(kind, now, session, size));
    }
    const std::shared_ptr<const Scene> kept =
        ui::isKeptBeside(session) ? session.document.kept.seen : nullptr;
    if (kept)
        frames_.push_back(
            draw(session.view.renderer, {view::Side::Kept, *kept, session.document.images}, session, size));
    for (const ui::ViewFrame& view : frames_) { // for the panels
        if (view.side == view::Side::Now)
            for (const auto& [key, picture] : view.frame.pictures)
                images_.putPicture(key, picture);
    }
    const bool asksReference =
        std::ranges::find(frames_, RendererKind::Reference, &ui::ViewFrame::renderer) != frames_.end();
    if (!asksReference)
        session.services.reference->rest();
    if (!asksReference || !kept)
        session.services.kept->rest();
    keepStepPicture(session);
    compareViews(session.view);
    problems_.clear();
    shaders_.clear();
    for (const ui::ViewFrame& view : frames_) {
        if (view.side == view::Side::Kept) // problems are reported only for the current scene
            continue;
        addProblems(view.frame.problems);
        if (view.renderer == RendererKind::Shader)
            shaders_ = view.frame.shaders;
    }
    const bool drawn =
        std::ranges::find(frames_, RendererKind::Shader, &ui::ViewFrame::renderer) != frames_.end();
    const bool offered = session.view.offered.has(RendererKind::Shader);
    if (isShown(session.settings.workspace, ui::Tab::Glsl) && offered && !drawn) { // they are made by drawing
        const view::Frame frame = drawLive(RendererKind::Shader, now, session, size).frame;
        addProblems(frame.problems);
        shaders_ = frame.shaders;
    }
}

/// The reference draws its own on its thread: they are needed only if something else shows them.
void ViewFrames::addDrawnImages(const ui::Session& session) {
    const Texture* bound = ui::boundTexture(session);
    const auto isLive = [](RendererKind kind) { return kind != RendererKind::Reference; };
    images_ = session.document.images;
    const bool draws = std::ranges::any_of(ui::shownRenderers(session.view), isLive) ||
                       isShown(session.settings.workspace, ui::Tab::Glsl);
    Scene stepped;
    const double time = session.look.playback.time;
    const Scene& scene = ui::shownScene(session, stepped);
    if (draws || (bound && bound->source == SourceKind::LightDepth))
        images_ = lightDepths_.addedTo(images_, *StandingScene(scene, time), time);
    if (!draws && bound && bound->source == SourceKind::Picture) { // otherwise a live renderer draws them
        if (Result<ImageSource> drawn = reference_.drawnImages({scene, images_, time}))
            images_ = std::move(*drawn);
    }
}

void ViewFrames::addProblems(const std::vector<Sentence>& problems) {
    for (const Sentence& problem : problems) {
        if (std::ranges::find(problems_, problem) == problems_.end())
            problems_.push_back(problem);
    }
}

ui::ViewFrame ViewFrames::draw(RendererKind kind, const Subject& subject, ui::Session& session,
                               view::Size size) {
    return kind == RendererKind::Reference ? drawReference(subject, session, size)
                                           : drawLive(kind, subject, session, size);
}

ui::ViewFrame ViewFrames::drawLive(RendererKind kind, const Subject& subject, ui::Session& session,
                                   view::Size size) {
    ui::ViewFrame view{kind, {{}, size, 0, {}, false}, nullptr, true, subject.side};
    Result<view::Frame> frame = graphics_.draw(kind, subject.side, subject.scene, subject.images,
                                               session.look.playback.time, size, session.services.levels);
    if (!frame) {
        view.frame.problems = {describe(frame.error())};
        return view;
    }
    view.frame = std::move(*frame);
    Pixels& pixels = pixels_[{subject.side, kind}];
    if (!ui::wantsPixels(session.view) && !session.look.explaining.pixel) {
        pixels.image.reset();
        return view;
    }
    if (!pixels.image || pixels.revision != view.frame.revision) {
        Result<Image> read = graphics_.read(kind, subject.side);
        if (!read) {
            view.frame.problems.push_back(describe(read.error()));
            return view;
        }
        pixels = {view.frame.revision, std::make_shared<const Image>(std::move(*read))};
    }
    view.image = pixels.image;
    return view;
}

ui::ViewFrame ViewFrames::drawReference(const Subject& subject, ui::Session& session, view::Size size) {
    reference::DrawWorker& worker =
        subject.side == view::Side::Now ? session.services.reference : session.services.kept;
    const reference::DrawWorker::Frame& picture =
        worker.frame({subject.scene, subject.images, session.look.playback.time, size.width, size.height,
                      session.view.anisotropy, session.view.rho});
    const view::PictureHandle shown = graphics_.show(picture.image, Graphics::Use::Enlarged);
    return {RendererKind::Reference,
            {shown, size, picture.milliseconds, picture.problems, false},
            picture.whole ? picture.image : nullptr,
            picture.whole,
            subject.side};
}

/// Keeps the picture of the shown history step, once it is complete and no mouse button is held: while a step
/// continues, its picture changes.
void ViewFrames::keepStepPicture(ui::Session& session) {
    ui::History& history = session.document.history;
    const ui::ViewFrame& view = frames_.front();
    if (history.pictureOf(history.position()) || ui::shownPreview(session) || ui::isKeptShown(session) ||
        !view.whole || view.frame.unfinished || ImGui::IsAnyMouseDown() || session.out.keyTaken ||
        session.document.scene != history.current())
        return;
    std::shared_ptr<const Image> seen = view.image;
    if (!seen && view.frame.picture != view::PictureHandle::None) {
        Result<Image> read = graphics_.read(view.renderer, view.side);
        seen = read ? std::make_shared<const Image>(std::move(*read)) : nullptr;
    }
    if (!seen)
        return;
    if (Image small = stepPicture(*seen); !small.empty())
        history.setPicture(std::make_shared<const Image>(std::move(small)));
}

void ViewFrames::compareViews(const ui::ViewSettings& settings) {
    const auto imageOf = [this](RendererKind kind, view::Side side) {
        const auto found = std::ranges::find_if(
            frames_, [&](const ui::ViewFrame& view) { return view.renderer == kind && view.side == side; });
        return found == frames_.end() ? nullptr : found->image;
    };
    const bool kept = settings.arrangement == ui::Arrangement::Kept;
    const std::array images = kept ? std::array{imageOf(settings.renderer, view::Side::Kept),
                                                imageOf(settings.renderer, view::Side::Now)}
                                   : std::array{imageOf(settings.compared[0], view::Side::Now),
                                                imageOf(settings.compared[1], view::Side::Now)};
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
