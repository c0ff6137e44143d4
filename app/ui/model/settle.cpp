#include "app/ui/model/settle.h"

#include "app/ui/model/explaining.h"
#include "app/ui/model/kept.h"
#include "app/ui/state/camera.h"
#include "texplorer/lesson/numbers.h"
#include "texplorer/scene/animation.h"

#include <algorithm>
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
    document.history.change([&](Scene& scene) {
        if (scene.view == before)
            scene.view = document.scene.view;
    });
    if (document.saved.view == before)
        document.saved.view = document.scene.view;
}

/// The distance of the explained pixel's triangle from the eye's plane; of the target if nothing covers the
/// pixel.
double distanceOf(const Session& session, const View& view) {
    const reference::Explanation* explanation = explanationOf(session);
    const reference::FragmentExplanation* seen = explanation ? explanation->seen() : nullptr;
    if (!seen || explanation->pixel != session.look.explaining.pixel)
        return double{view.distance};
    const auto [near, far] = clipPlanes(view);
    return near * far / (far - static_cast<double>(seen->depth) * (far - near));
}

/// Enlarges the place of the explained pixel as the picture when a fitted camera has moved.
void followCamera(Session& session, const View& before) {
    std::optional<WantedProbe>& wanted = session.look.wantedProbe;
    const View& now = session.document.scene.view;
    if (!wanted || now.distance == before.distance)
        return;
    const bool isPerspective = before.projection == Projection::Perspective;
    if (!isPerspective || wanted->distance <= 0)
        wanted->distance = isPerspective ? distanceOf(session, before) : double{before.distance};
    const double distance = std::max(1e-6, wanted->distance + double{now.distance} - double{before.distance});
    wanted->zoom *= wanted->distance / distance;
    wanted->distance = distance;
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
        wanted = WantedProbe{[pixel = *explained, picture](lesson::PictureSize shown, double zoom) {
            return lesson::pixelOf(pixel, picture, shown, zoom);
        }};
    if (wanted)
        explained = wanted->pixel = wanted->in(picture, wanted->zoom);
}

} // namespace

void settle(Session& session, const Layout& layout) {
    const View before = session.document.scene.view;
    followShape(session.document, session.look.playback.time, aspectOf(layout));
    followCamera(session, before);
    showPresent(session);
    bringSelectionBack(session);
    followKept(session);
    placeProbe(session, {layout.picture.width, layout.picture.height});
}

} // namespace texplorer::ui
