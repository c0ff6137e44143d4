#include "app/ui/view/framing.h"

#include "app/ui/model/camera.h"

#include <fmt/core.h>

#include <algorithm>

namespace texplorer::ui {
namespace {

void rememberFit(const Session& session, const View& view, const Layout& layout) {
    act(session, [fit = Fit{view, aspectOf(layout)}](Session& s) { s.document.fit = fit; });
}

} // namespace

void resetCamera(const Session& session, const Layout& layout) {
    View fitted;
    submitDrag(session, "Reset camera", [&](Scene& scene) {
        scene.view = defaultScene().view;
        fitDistance(scene, session.window.playback.time, aspectOf(layout));
        fitted = scene.view;
    });
    rememberFit(session, fitted, layout);
}

void frameAll(const Session& session, const Layout& layout) {
    View fitted;
    submitDrag(session, "Frame the models", [&](Scene& scene) {
        frameModels(scene, session.window.playback.time, aspectOf(layout));
        fitted = scene.view;
    });
    rememberFit(session, fitted, layout);
}

void show(const Session& session, const ShowRow& row, const Layout& layout) {
    Selection selection = session.window.selection;
    selection.vertex.reset();
    View fitted;
    Step step = stepThat(session, fmt::format("Show {}", row.label), [&](Scene& scene) {
        showOnly(scene, row.show, session.window.playback.time, aspectOf(layout));
        fitted = scene.view;
        const auto shown = std::ranges::find(scene.models, true, &Model::visible);
        selection.model = static_cast<int>(shown - scene.models.begin());
    });
    step.select = std::move(selection);
    submit(session, std::move(step));
    rememberFit(session, fitted, layout);
}

} // namespace texplorer::ui
