#pragma once

#include "app/ui/model/session.h"
#include "app/ui/widgets/pictures.h"

#include <optional>

namespace texplorer::ui {

/// What the tab remembers.
struct LevelsTabState {
    /// A level that a click chose as the only one, and what it replaced.
    struct Forced {
        int texture = 0;
        int level = 0;
        int baseLevel = 0;
        int maxLevel = 0;
    };

    bool equal = false; ///< all levels have one size
    float zoom = 1;
    std::optional<Forced> forced;

    static constexpr float largestZoom = 64;
};

/// The levels of the texture of the selected unit beside each other, and which of them a pixel reads.
void drawLevelsTab(Session& session, LevelsTabState& state, const Pictures& pictures);

} // namespace texplorer::ui
