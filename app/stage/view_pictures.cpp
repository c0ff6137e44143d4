#include "app/stage/view_pictures.h"

#include <algorithm>
#include <array>
#include <utility>

namespace texplorer::stage {

void ViewPictures::draw(ui::Session& session, view::Size size) {
    views_.clear();
    for (const RendererKind kind : ui::shownRenderers(session.window.views)) {
        const auto drawn = std::ranges::find(views_, kind, &ui::RenderedView::renderer);
        if (drawn != views_.end()) // compared with itself
            views_.push_back(ui::RenderedView(*drawn));
        else
            views_.push_back(kind == RendererKind::Reference ? drawReference(session, size)
                                                             : drawLive(kind, session, size));
    }
    if (std::ranges::find(views_, RendererKind::Reference, &ui::RenderedView::renderer) == views_.end())
        session.services.reference.rest();
    compareViews(session.window.views);
    problems_.clear();
    shaders_.clear();
    for (const ui::RenderedView& view : views_) {
        addProblems(view.frame.problems);
        if (view.renderer == RendererKind::Shader)
            shaders_ = view.frame.shaders;
    }
    const bool drawn =
        std::ranges::find(views_, RendererKind::Shader, &ui::RenderedView::renderer) != views_.end();
    if (session.window.shownTab == ui::Tab::Glsl && !drawn) { // they are made while they draw
        const view::Frame frame = drawLive(RendererKind::Shader, session, size).frame;
        addProblems(frame.problems);
        shaders_ = frame.shaders;
    }
}

void ViewPictures::addProblems(const std::vector<std::string>& problems) {
    for (const std::string& problem : problems) {
        if (std::ranges::find(problems_, problem) == problems_.end())
            problems_.push_back(problem);
    }
}

ui::RenderedView ViewPictures::drawLive(RendererKind kind, ui::Session& session, view::Size size) {
    ui::RenderedView view{kind, {0, size, 0, {}, false}, nullptr, true};
    Result<view::Frame> frame = graphics_.draw(kind, session.document.scene, session.document.images,
                                               session.window.playback.time, size, session.services.levels);
    if (!frame) {
        view.frame.problems = {describe(frame.error())};
        return view;
    }
    view.frame = std::move(*frame);
    Pixels& pixels = pixels_[kind];
    if (!ui::wantsPixels(session.window.views) && !session.window.explaining.pixel) {
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

ui::RenderedView ViewPictures::drawReference(ui::Session& session, view::Size size) {
    const reference::DrawWorker::Picture& picture = session.services.reference.picture(
        {session.document.scene, session.document.images, session.window.playback.time, size.width,
         size.height, session.window.views.anisotropy});
    const unsigned texture = graphics_.show(picture.image, Graphics::Use::Enlarged);
    return {RendererKind::Reference,
            {texture, size, picture.milliseconds, picture.problems, false},
            picture.whole ? picture.image : nullptr,
            picture.whole};
}

void ViewPictures::compareViews(const ui::Views& views) {
    const auto imageOf = [this](RendererKind kind) {
        const auto found = std::ranges::find(views_, kind, &ui::RenderedView::renderer);
        return found == views_.end() ? nullptr : found->image;
    };
    const std::array images{imageOf(views.compared[0]), imageOf(views.compared[1])};
    const HeatScale scale{views.tolerance, 255};
    if (!ui::isComparing(views) || !images[0] || !images[1]) {
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
    const Result<Difference> numbers = compare(*images[0], *images[1], views.tolerance, Compared::Rgb);
    Result<Image> heat = heatMap(*images[0], *images[1], scale, Compared::Rgb);
    if (!numbers || !heat)
        return;
    heatMap_ = std::make_shared<const Image>(std::move(*heat));
    difference_ = {*numbers, scale, graphics_.show(heatMap_, Graphics::Use::Enlarged)};
}

bool ViewPictures::isUnfinished() const {
    return std::ranges::any_of(views_, [](const ui::RenderedView& view) { return view.frame.unfinished; });
}

} // namespace texplorer::stage
