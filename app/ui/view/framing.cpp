#include "app/ui/view/framing.h"

#include "app/ui/model/camera.h"

#include <fmt/core.h>

#include <algorithm>

namespace texplorer::ui {

void resetCamera(Session& session, const Layout& layout) {
    session.document.scene.view = defaultScene().view;
    fitDistance(session.document.scene, session.window.playback.time, aspectOf(layout));
    session.document.fit = {session.document.scene.view, aspectOf(layout)};
    recordEdit(session, "Reset camera");
}

void frameAll(Session& session, const Layout& layout) {
    frameModels(session.document.scene, session.window.playback.time, aspectOf(layout));
    session.document.fit = {session.document.scene.view, aspectOf(layout)};
    recordEdit(session, "Frame the models");
}

void show(Session& session, const ShowRow& row, const Layout& layout) {
    showOnly(session.document.scene, row.show, session.window.playback.time, aspectOf(layout));
    session.document.fit = {session.document.scene.view, aspectOf(layout)};
    sealEdit(session);
    recordEdit(session, fmt::format("Show {}", row.label));
    sealEdit(session);
    const auto shown = std::ranges::find(session.document.scene.models, true, &Model::visible);
    session.window.selection.model = static_cast<int>(shown - session.document.scene.models.begin());
    session.window.selection.vertex.reset();
}

} // namespace texplorer::ui
