#include "app/ui/model/settle.h"

#include "app/ui/model/kept.h"
#include "app/ui/state/camera.h"
#include "texplorer/lesson/numbers.h"

#include <optional>

namespace texplorer::ui {
namespace {

/// A fitted camera that the user has not moved fills its picture when the picture's shape changes. This is
/// not an edit: steps of the history and the saved scene with the same camera are changed as well.
void followShape(Document& document, double time, float aspect) {
    const Fit& fit = document.fit;
    const bool follows = fit.aspect > 0 && fit.aspect != aspect && document.scene.view == fit.view;
    if (!document.needsFit && !follows)
        return;
    const View before = document.scene.view;
    fitDistance(document.scene, time, aspect);
    document.needsFit = false;
    document.fit = {document.scene.view, aspect};
    document.history.replaceView(before, document.scene.view);
    if (document.saved.view == before)
        document.saved.view = document.scene.view;
}

/// Moves the explained pixel with the picture when the picture's size changes.
void placeProbe(Session& session, lesson::PictureSize picture) {
    std::optional<WantedProbe>& wanted = session.look.wantedProbe;
    std::optional<reference::PixelPlace>& explained = session.look.explaining.pixel;
    if (wanted && wanted->pixel && explained != wanted->pixel)
        wanted.reset(); // for another one, or none
    if (picture.width < 1 || picture.height < 1)
        return;
    if (explained && !wanted)
        wanted = WantedProbe{[pixel = *explained, picture](lesson::PictureSize shown) {
            return lesson::pixelOf(pixel, picture, shown);
        }};
    if (wanted)
        explained = wanted->pixel = wanted->in(picture);
}

} // namespace

void settle(Session& session, const Layout& layout) {
    followShape(session.document, session.look.playback.time, aspectOf(layout));
    showPresent(session);
    bringSelectionBack(session);
    followKept(session);
    placeProbe(session, {layout.picture.width, layout.picture.height});
}

} // namespace texplorer::ui
