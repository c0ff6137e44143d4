#pragma once

#include "app/ui/model/session.h"
#include "app/ui/widgets/pictures.h"

#include <cstddef>

namespace texplorer::ui {

struct HistoryTabState {
    std::size_t shown = 0; ///< the last step that was scrolled to
};

void drawHistoryTab(const Session& session, HistoryTabState& state, const Pictures& pictures);

} // namespace texplorer::ui
