#pragma once

#include "app/ui/model/session.h"

#include <memory>
#include <vector>

namespace texplorer::ui {

/// The list and its inputs.
struct KeptTabState {
    std::shared_ptr<const Scene> kept;
    Scene now;
    std::vector<SceneChange> changes;
};

void drawKeptTab(const Session& session, KeptTabState& state);

} // namespace texplorer::ui
