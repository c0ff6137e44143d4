#include "app/ui/model/shown_passes.h"

#include <algorithm>

namespace texplorer::ui {

std::size_t shownPasses(const Session& session) {
    const std::size_t count = session.document.scene.passes.size();
    if (!session.window.view.stepsThroughPasses)
        return count;
    return std::min(count, static_cast<std::size_t>(session.window.selection.pass) + 1);
}

Scene shownScene(const Session& session) {
    Scene scene = session.document.scene;
    scene.passes.resize(shownPasses(session));
    return scene;
}

} // namespace texplorer::ui
