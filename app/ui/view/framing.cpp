#include "app/ui/view/framing.h"

#include "app/ui/model/camera.h"

#include <fmt/core.h>

#include <algorithm>

namespace texplorer::ui {

void resetCamera(Session& session, const Layout& layout) {
    submitDrag(session, "Reset camera", [&](Scene& scene) {
        scene.view = defaultScene().view;
        fitDistance(scene, session.window.playback.time, aspectOf(layout));
        session.document.fit = {scene.view, aspectOf(layout)};
    });
}

void frameAll(Session& session, const Layout& layout) {
    submitDrag(session, "Frame the models", [&](Scene& scene) {
        frameModels(scene, session.window.playback.time, aspectOf(layout));
        session.document.fit = {scene.view, aspectOf(layout)};
    });
}

void show(Session& session, const ShowRow& row, const Layout& layout) {
    Selection selection = session.window.selection;
    selection.vertex.reset();
    Step step = stepThat(session, fmt::format("Show {}", row.label), [&](Scene& scene) {
        showOnly(scene, row.show, session.window.playback.time, aspectOf(layout));
        session.document.fit = {scene.view, aspectOf(layout)};
        const auto shown = std::ranges::find(scene.models, true, &Model::visible);
        selection.model = static_cast<int>(shown - scene.models.begin());
    });
    step.select = std::move(selection);
    submit(session, std::move(step));
}

} // namespace texplorer::ui
