#include "app/ui/model/shown_passes.h"

#include "app/ui/model/preview.h"
#include "texplorer/scene/params/scene_at.h"

#include <algorithm>

namespace texplorer::ui {

std::size_t shownPasses(const Session& session) {
    const std::size_t count = shownScene(session).passes.size();
    if (!session.view.stepsThroughPasses)
        return count;
    return std::min(count, static_cast<std::size_t>(session.look.selection.pass) + 1);
}

const Scene& shownScene(const Session& session, Scene& stepped) {
    const std::size_t shown = shownPasses(session);
    const Scene& whole = shownScene(session);
    const bool moves = !whole.timeline.keys.empty();
    if (shown == whole.passes.size() && !moves)
        return whole;
    stepped = moves ? sceneAt(whole, session.look.playback.time) : whole;
    stepped.passes.resize(shown);
    return stepped;
}

} // namespace texplorer::ui
