#include "app/ui/model/shown_passes.h"

#include "app/ui/model/preview.h"

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
    if (shown == whole.passes.size())
        return whole;
    stepped = whole;
    stepped.passes.resize(shown);
    return stepped;
}

} // namespace texplorer::ui
