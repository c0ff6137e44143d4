#include "app/ui/model/level_view.h"

#include "app/ui/model/preview.h"
#include "app/ui/model/session.h"
#include "app/ui/model/shown_passes.h"
#include "app/ui/state/workspace.h"

namespace texplorer::ui {

void askAboutLevels(Session& session, view::Size picture) {
    const bool isWanted =
        session.view.shown != reference::Shown::Picture || isShown(session.settings.workspace, Tab::Levels);
    if (!isWanted || picture.width < 1 || picture.height < 1) {
        session.look.levels.answer.reset();
        session.services.levelMap->rest();
        return;
    }
    Scene stepped;
    session.look.levels.answer = session.services.levelMap->answer(
        {{shownScene(session, stepped), session.document.images, session.look.playback.time, picture.width,
          picture.height, session.view.anisotropy, session.view.rho},
         {session.look.selection.pass, session.look.selection.unit},
         session.view.shown});
}

void askAboutTextures(Session& session) {
    for (const Unit& unit : selectedPass(session).units) {
        if (const Texture* texture = textureOf(presentScene(session), unit))
            (void)session.services.levels->summary(levelsOf(session, *texture, unit.target));
    }
}

LevelsRequest levelsOf(const Session& session, const Texture& texture, Target target) {
    const ImageSource& images = isDrawn(texture.source) ? session.drawn : session.document.images;
    return {images.picturesOf(texture), imageSettings(texture), target};
}

std::optional<LevelsRequest> boundLevels(const Session& session) {
    return boundImage(session)
               ? std::optional(levelsOf(session, *boundTexture(session), selectedUnit(session).target))
               : std::nullopt;
}

std::shared_ptr<const LevelsSummary> summaryOf(const Session& session, const LevelsRequest& request) {
    std::shared_ptr<const LevelsSummary> known = session.services.levels->find(request);
    if (!known)
        ask(session,
            [request](Session& changed) { return changed.services.levels->summary(request) != nullptr; });
    return known;
}

const reference::LevelMap* levelMapOf(const Session& session) {
    const auto& answer = session.look.levels.answer;
    const reference::LevelQuestion now{session.look.selection.pass, session.look.selection.unit};
    return answer && answer->map && answer->request.unit == now ? &*answer->map : nullptr;
}

std::optional<reference::PixelPlace> askedPixel(const Session& session) {
    return session.look.levels.hovered ? session.look.levels.hovered : session.look.explaining.pixel;
}

const reference::PixelLevels* askedLevels(const Session& session) {
    const reference::LevelMap* map = levelMapOf(session);
    const std::optional<reference::PixelPlace> pixel = askedPixel(session);
    return map && pixel ? map->at(pixel->x, pixel->y) : nullptr;
}

} // namespace texplorer::ui
