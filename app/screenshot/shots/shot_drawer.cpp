#include "app/screenshot/shots/shot_drawer.h"

#include "texplorer/reference/draw.h"

#include <utility>

namespace texplorer::screenshot {
namespace {

Result<Shot> drawByReference(const ShotRequest& request) {
    Result<Frame> drawn = reference::drawReference(request.drawRequest(),
                                                   {.levels = request.levels, .stop = request.levels.stop});
    if (!drawn)
        return fail(drawn.error());
    return Shot{std::move(*drawn), {}};
}

/// Of the unit's levels of detail or footprints; transparent where it samples nothing.
Result<Shot> drawFalseColors(const ShotRequest& request) {
    Result<reference::LevelMap> map = reference::levelMap(
        request.drawRequest(), request.shownUnit, {.levels = request.levels, .stop = request.levels.stop});
    if (!map)
        return fail(map.error());
    return Shot{{reference::falseColors(*map, request.shown), std::move(map->problems)}, {}};
}

bool needsStudio(const ShotRequest& request) {
    return !request.window && request.renderer != RendererKind::Reference;
}

} // namespace

Result<void> ShotDrawer::open(const ShotRequest& request) {
    if (studio_ || !needsStudio(request))
        return {};
    Result<std::unique_ptr<Studio>> opened = openStudio(request.shaders, request.pretence, request.context);
    if (!opened)
        return fail(opened.error());
    studio_ = *std::move(opened);
    return {};
}

Result<Shot> ShotDrawer::draw(const ShotRequest& request) {
    if (request.window)
        return screenshot::draw(request);
    if (!needsStudio(request))
        return request.shown == reference::Shown::Picture ? drawByReference(request)
                                                          : drawFalseColors(request);
    if (const Result<void> opened = open(request); !opened)
        return fail(opened.error());
    Result<Frame> frame = studio_->draw(request.renderer, request.drawRequest(), request.levels);
    if (!frame)
        return fail(frame.error());
    return Shot{std::move(*frame), studio_->driver(), studio_->context()};
}

} // namespace texplorer::screenshot
