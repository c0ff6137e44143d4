#pragma once

#include "app/ui/model/session.h"

#include <cstddef>
#include <optional>
#include <string>

namespace texplorer::ui {

/// The state of the tab.
struct TimelineTabState {
    /// Identified by its index in the timeline and its parameter.
    struct ChosenKey {
        std::size_t number;
        std::string path;
    };
    std::optional<ChosenKey> chosen;
    float grid = 0.1F;            ///< in seconds: dragged keys snap to it; 0: none
    float grabbed = 0;            ///< the original time of the dragged key
    std::optional<float> seconds; ///< shown seconds, constant during a drag
};

/// Draws every parameter with key frames and its keys over time, to move, change, add and remove them.
void drawTimelineTab(const Session& session, TimelineTabState& state);

} // namespace texplorer::ui
