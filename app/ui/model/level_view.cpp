#include "app/ui/model/level_view.h"

#include "app/ui/model/session.h"
#include "app/ui/model/shown_passes.h"
#include "app/ui/model/workspace.h"

namespace texplorer::ui {

void askAboutLevels(Session& session, view::Size picture) {
    const WindowState& window = session.window;
    const bool isWanted =
        window.view.shown != reference::Shown::Picture || isShown(window.settings.workspace, Tab::Levels);
    if (!isWanted || picture.width < 1 || picture.height < 1) {
        session.window.levels.answer.reset();
        session.services.levelMap.rest();
        return;
    }
    Scene stepped;
    session.window.levels.answer = session.services.levelMap.answer(
        {{shownScene(session, stepped), session.document.images, window.playback.time, picture.width,
          picture.height, window.view.anisotropy, window.view.rho},
         {window.selection.pass, window.selection.unit},
         window.view.shown});
}

const reference::LevelMap* levelMapOf(const Session& session) {
    const auto& answer = session.window.levels.answer;
    const reference::LevelQuestion now{session.window.selection.pass, session.window.selection.unit};
    return answer && answer->map && answer->request.unit == now ? &*answer->map : nullptr;
}

std::optional<reference::PixelPlace> askedPixel(const Session& session) {
    return session.window.levels.hovered ? session.window.levels.hovered : session.window.explaining.pixel;
}

const reference::PixelLevels* askedLevels(const Session& session) {
    const reference::LevelMap* map = levelMapOf(session);
    const std::optional<reference::PixelPlace> pixel = askedPixel(session);
    return map && pixel ? map->at(pixel->x, pixel->y) : nullptr;
}

} // namespace texplorer::ui
